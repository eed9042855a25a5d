// SPDX-License-Identifier: MIT
#include "core/creases/repair_log.h"

#include <algorithm>
#include <string>

#include "core/base/text.h"

namespace kiri {
namespace {

/// How many places are kept of a kind: enough to mark a picture, few enough for any drawing.
constexpr std::size_t kMostPlaces = 1000;

/// What happened, for one and for many, after the count.
struct Wording {
  const char* one;
  const char* many;
};

Wording wordingOf(RepairKind kind) {
  switch (kind) {
    case RepairKind::MergedVertices:
      return {"end of a line was merged with an end nearby",
              "ends of lines were merged with ends nearby"};
    case RepairKind::MovedToEdge:
      return {"vertex beside a line was joined to it", "vertices beside lines were joined to them"};
    case RepairKind::SplitCrossings:
      return {"vertex was added where lines cross or meet",
              "vertices were added where lines cross or meet"};
    case RepairKind::DroppedDuplicates:
      return {"line that lay on another one was left out",
              "lines that lay on others were left out"};
    case RepairKind::Conflicts:
      return {
          "line lay on another one with a different assignment; border goes before cut, "
          "mountain and valley, unassigned, flat, join",
          "lines lay on others with different assignments; border goes before cut, mountain "
          "and valley, unassigned, flat, join"};
    case RepairKind::DroppedPoints:
      return {"line without length or with a coordinate that is no number was left out",
              "lines without length or with coordinates that are no numbers were left out"};
    case RepairKind::DroppedDangling:
      return {"crease that ends inside a facet was left out: it cannot fold",
              "creases that end inside a facet were left out: they cannot fold"};
    case RepairKind::DroppedOutside:
      return {"line was left out where there is no paper",
              "lines were left out where there is no paper"};
    case RepairKind::AddedBorder:
      return {"line of the outline was made a border", "lines of the outline were made borders"};
    case RepairKind::SlitBorders:
      return {"border line with paper on both sides was read as a cut",
              "border lines with paper on both sides were read as cuts"};
    case RepairKind::JoinedPieces:
      return {"vertex that was left over on a straight line was taken away",
              "vertices that were left over on straight lines were taken away"};
    case RepairKind::IgnoredFaces:
      return {"face of the file disagrees with the border lines, which were followed",
              "faces of the file disagree with the border lines, which were followed"};
  }
  return {"", ""};
}

std::string sentenceOf(const Repair& repair) {
  const Wording wording = wordingOf(repair.kind);
  std::string sentence =
      std::to_string(repair.count) + " " + (repair.count == 1 ? wording.one : wording.many);
  if (repair.farthest > 0) sentence += ", by at most " + text(repair.farthest);
  if (!repair.places.empty())
    sentence += (repair.count == 1 ? ", at " : ", first at ") + text(repair.places.front());
  return sentence;
}

}  // namespace

void RepairLog::add(RepairKind kind, Vec2 place, double distance) {
  Repair& entry = entries_[indexOf(kind)];
  entry.kind = kind;
  ++entry.count;
  entry.farthest = std::max(entry.farthest, distance);
  if (entry.places.size() < kMostPlaces) entry.places.push_back(place);
}

std::vector<Repair> RepairLog::repairs() const {
  std::vector<Repair> result;
  for (const Repair& entry : entries_) {
    if (entry.count == 0) continue;
    result.push_back(entry);
    result.back().message = sentenceOf(entry);
  }
  return result;
}

}  // namespace kiri
