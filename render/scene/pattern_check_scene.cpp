// A crease pattern with its faults and repairs marked, for kiri check and the window.
// SPDX-License-Identifier: MIT
#include "render/scene/pattern_check_scene.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "core/paper/boxes.h"
#include "render/scene/assigned_items.h"
#include "render/scene/label_room.h"
#include "render/scene/page.h"
#include "render/scene/page_text.h"
#include "render/scene/paled.h"
#include "render/scene/pattern_page.h"

namespace kiri {
namespace {

constexpr Color kFaultColor{230, 90, 0};
constexpr Color kRepairColor{0, 140, 110};
/// More labels than this cannot be read on one page.
constexpr std::size_t kMostLabels = 120;
constexpr double kRepairHalf = 1;

constexpr std::array<const char*, 5> kRuleNames{"odd degree", "Kawasaki", "Maekawa",
                                                "big-little-big", "self-crossing"};
constexpr std::array<const char*, 5> kRuleMeanings{
    "an odd number of folded creases", "alternate angles do not add up to 180 degrees",
    "mountains and valleys do not differ by two",
    "the creases beside a smallest angle are folded alike",
    "paper would pass through paper in every order of its layers"};

struct MountainsAndValleys {
  std::size_t mountains = 0;
  std::size_t valleys = 0;
  std::size_t open = 0;
};

MountainsAndValleys foldsAround(const AssignedPattern& creases, VertexId vertex) {
  MountainsAndValleys counts;
  for (std::size_t i = 0; i < creases.pattern.edges.size(); ++i) {
    const EdgeId e(i);
    const Edge& edge = creases.pattern[e];
    if ((edge.from != vertex && edge.to != vertex) || !creases.isFolded(e)) continue;
    if (creases.of(e) == Assignment::Unassigned) {
      ++counts.open;
    } else if (edge.angle > 0) {
      ++counts.valleys;
    } else {
      ++counts.mountains;
    }
  }
  return counts;
}

std::string shortNumber(double value) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), value < 0.01 ? "%.1g" : "%.2f", value);
  return buffer.data();
}

/// Rings are as large as the pattern leaves room for.
double ringRadius(const AssignedPattern& creases, double scale) {
  constexpr double kLeast = 0.7;
  constexpr double kMost = 2.4;
  std::vector<double> lengths;
  for (const Edge& edge : creases.pattern.edges) {
    lengths.push_back(distance(creases.pattern[edge.from], creases.pattern[edge.to]) * scale);
  }
  if (lengths.empty()) return kMost;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return std::clamp(*middle / 5, kLeast, kMost);
}

std::vector<LegendLine> legendOf(const std::vector<VertexFault>& faults,
                                 const std::vector<Repair>& repairs, bool hasVerdict) {
  std::vector<LegendLine> legend;
  for (std::size_t rule = 0; rule < kRuleNames.size(); ++rule) {
    const auto count = std::count_if(faults.begin(), faults.end(), [&](const VertexFault& fault) {
      return static_cast<std::size_t>(fault.rule) == rule;
    });
    if (count == 0) continue;
    legend.push_back(
        {LegendLine::Sign::Ring,
         std::to_string(count) + " \u00d7 " + kRuleNames[rule] + ": " + kRuleMeanings[rule],
         kFaultColor});
  }
  if (faults.empty() && !hasVerdict) legend.push_back({{}, "every vertex folds flat", {}});
  if (faults.size() > kMostLabels) {
    legend.push_back({{}, "too many faults to write beside their places", {}});
  }
  for (const Repair& repair : repairs) {
    const auto sign = repair.places.empty() ? LegendLine::Sign::None : LegendLine::Sign::Square;
    std::string words = repair.message;
    if (!repair.places.empty() && repair.places.size() < repair.count) {
      words += " (" + std::to_string(repair.places.size()) + " of them marked)";
    }
    legend.push_back({sign, std::move(words), kRepairColor});
  }
  return legend;
}

class CheckMarks {
 public:
  CheckMarks(const AssignedPattern& creases, const Affine& toScene, const PatternPage& page)
      : creases_(creases),
        toScene_(toScene),
        radius_(ringRadius(creases, toScene.a)),
        labels_(page.page()) {
    // The legend is no place for labels.
    const Box whole = page.page();
    labels_.keepFree({whole.low, {whole.high.x, page.pictures().low.y - 2 * radius_}});
  }

  Group repairs(const std::vector<Repair>& repairs) {
    Group group{"repairs", "repairs", {}, {}};
    for (const Repair& repair : repairs) {
      for (const Vec2 place : repair.places) {
        // A place outside the paper, of a line that was left out, is not on the page.
        const Vec2 at = toScene_.apply(place);
        if (!isOnPaper(place)) continue;
        group.items.push_back(squareMark(at, kRepairHalf, kRepairColor, "repair"));
      }
    }
    return group;
  }

  Group faults(const std::vector<VertexFault>& faults) {
    Group group{"faults", "faults", {}, {}};
    std::size_t sameVertex = 0;
    for (std::size_t i = 0; i < faults.size(); ++i) {
      const VertexFault& fault = faults[i];
      sameVertex = i > 0 && faults[i - 1].vertex == fault.vertex ? sameVertex + 1 : 0;
      const double radius = radius_ + static_cast<double>(sameVertex) * 2 * kMarkWidth;
      const Vec2 at = toScene_.apply(creases_.pattern[fault.vertex]);
      Item ring = ringMark(at, radius, kFaultColor, "fault");
      ring.data = {{"rule", kRuleNames[static_cast<std::size_t>(fault.rule)]},
                   {"amount", shortNumber(fault.amount)},
                   {"vertex", std::to_string(fault.vertex.index)}};
      group.items.push_back(std::move(ring));
      labels_.keepFree({at - Vec2{radius, radius}, at + Vec2{radius, radius}});
    }
    return group;
  }

  Group labels(const std::vector<VertexFault>& faults) {
    Group group{"labels", "faults in words", {}, {}};
    if (faults.size() > kMostLabels) return group;
    constexpr std::size_t kFew = 30;
    const double height = faults.size() > kFew ? 0.7 * kWordHeight : kWordHeight;
    std::size_t first = 0;
    while (first < faults.size()) {
      std::size_t end = first;
      std::string words;
      for (; end < faults.size() && faults[end].vertex == faults[first].vertex; ++end) {
        words += (words.empty() ? "" : ", ") + labelOf(creases_, faults[end]);
      }
      const double reach = radius_ + static_cast<double>(end - first) * 2 * kMarkWidth;
      const Vec2 at = toScene_.apply(creases_.pattern[faults[first].vertex]);
      const Vec2 middle = labels_.takeAround(at, {widthOf(words, height), height}, reach);
      group.items.push_back({centredText(words, height, middle, kWordColor), "label", "", {}});
      first = end;
    }
    return group;
  }

 private:
  static constexpr Color kWordColor{140, 50, 0};

  bool isOnPaper(Vec2 place) const {
    const Box box = paperBoxOf(creases_.pattern);
    return place.x >= box.low.x && place.x <= box.high.x && place.y >= box.low.y &&
           place.y <= box.high.y;
  }

  const AssignedPattern& creases_;
  Affine toScene_;
  double radius_;
  LabelRoom labels_;
};

}  // namespace

std::string labelOf(const AssignedPattern& creases, const VertexFault& fault) {
  std::string name = kRuleNames[static_cast<std::size_t>(fault.rule)];
  const MountainsAndValleys folds = foldsAround(creases, fault.vertex);
  switch (fault.rule) {
    case VertexRule::EvenDegree:
      return name + " " + std::to_string(folds.mountains + folds.valleys + folds.open);
    case VertexRule::Kawasaki:
      return name + " " + shortNumber(fault.amount) + "\u00b0";
    case VertexRule::Maekawa:
      return name + " " + std::to_string(folds.mountains) + "-" + std::to_string(folds.valleys) +
             (folds.open > 0 ? "+" + std::to_string(folds.open) : "");
    case VertexRule::BigLittleBig:
    case VertexRule::SelfCrossing:
      break;
  }
  return name;
}

Scene patternCheckScene(const AssignedPattern& creases, const std::vector<VertexFault>& faults,
                        const std::vector<Repair>& repairs, const Appearance& appearance,
                        const PatternCheckOptions& options) {
  const Box box = paperBoxOf(creases.pattern);
  const Vec2 size = box.high - box.low;
  const double larger = std::max(size.x, size.y);
  const double scale = larger > 0 ? options.size / larger : 1;
  const PatternPage page(size * scale, legendOf(faults, repairs, !options.verdict.empty()),
                         options);
  const Affine toScene = placed(box, scale, page.corner());
  const double width = std::min(appearance.drawnWidth, kMarkWidth * 0.7);
  std::vector<Group> groups = assignedGroups(creases, toScene, paledFor(appearance), width);
  CheckMarks marks(creases, toScene, page);
  const auto append = [&](Group group) {
    if (!group.items.empty()) groups.push_back(std::move(group));
  };
  append(marks.repairs(repairs));
  append(marks.faults(faults));
  append(marks.labels(faults));
  return page.scene(std::move(groups));
}

}  // namespace kiri
