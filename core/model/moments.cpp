// A model folded, half way, and unfolded: what galleries show of it.
// SPDX-License-Identifier: MIT
#include "core/model/moments.h"

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "core/model/apply.h"

namespace kiri {
namespace {

constexpr double kHalf = 0.5;

bool unfoldsAll(const Step& step) {
  const auto* unfold = std::get_if<UnfoldStep>(&step.action);
  return unfold != nullptr && unfold->lines.empty();
}

/// How many fold lines are folded, however little; creases without one count as one.
std::size_t foldedLines(const FoldedState& state) {
  std::set<std::uint32_t> lines;
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind == EdgeKind::Hinge && edge.angle != 0) {
      lines.insert(edge.line.index);
    }
  }
  return lines.size();
}

bool endsOpen(const Movements& way) { return !way.empty() && foldedLines(stateAlong(way, 1)) == 0; }

/// The way from the folded model to the sheet; none where the paper would have to bend.
Movements wayOpen(const Model& model, const Timeline& timeline, std::size_t folded) {
  if (folded < model.steps.size() && endsOpen(timeline.movementsOf(folded))) {
    return timeline.movementsOf(folded);
  }
  for (const Sequence sequence : {model.opening, Sequence::InOrder}) {
    Movements movements;
    const Step unfold{UnfoldStep{{}, sequence}, "", "", ""};
    const int number = static_cast<int>(folded) + 1;
    if (apply(timeline.stateAfter(folded), unfold, number, &movements) && endsOpen(movements)) {
      return movements;
    }
  }
  return {};
}

/// Half of the degrees are turned; near the start or end of a movement, where the paper may lie
/// flat, the middle of that movement.
FoldedState midwayAlong(const Movements& way) {
  constexpr double kNearEnds = 0.15;
  double left = kHalf * degreesOf(way);
  for (const Movement& movement : way) {
    const double share = degreesOf(movement);
    if (left > share) {
      left -= share;
      continue;
    }
    const double part = share > 0 ? left / share : kHalf;
    return stateDuring(movement, part < kNearEnds || part > 1 - kNearEnds ? kHalf : part);
  }
  return stateDuring(way.back(), kHalf);
}

void findHalf(const Model& model, const Timeline& timeline, Moments& moments) {
  const Movements way = wayOpen(model, timeline, moments.folded);
  if (!way.empty()) {
    moments.halfWay = HalfWay::Unfolding;
    moments.half = midwayAlong(way);
    return;
  }
  for (std::size_t i = moments.folded; i-- > 0;) {
    if (timeline.movementsOf(i).empty()) continue;
    moments.halfWay = HalfWay::LastFold;
    moments.half = stateAlong(timeline.movementsOf(i), kHalf);
    return;
  }
}

/// The paper of a state as it lies before it is folded.
FoldedState atRest(const FoldedState& state) {
  FoldedState flat(state.pattern);
  for (Edge& edge : flat.pattern.edges) edge.angle = 0;
  flat.lines = state.lines;
  LayerSet plane{{0, 0, 1}, {}, {}};
  std::set<std::uint32_t> pieces;
  const std::vector<std::uint32_t> pieceOf = piecesOf(flat.pattern);
  for (std::size_t f = 0; f < flat.pattern.facets.size(); ++f) {
    plane.upward.emplace_back(f);
    if (pieces.insert(pieceOf[f]).second) flat.rests.push_back({FacetId(f), Rigid{}});
  }
  flat.layers = LayerOrder({std::move(plane)});
  flat.poses = derivePoses(flat.pattern, flat.rests);
  return flat;
}

}  // namespace

std::optional<std::size_t> stepsUntilFolded(const Model& model, const StateAfter& stateAfter) {
  std::size_t best = 0;
  std::size_t most = 0;
  const std::size_t count = model.steps.size();
  for (std::size_t i = 0; i <= count; ++i) {
    if (i < count && !unfoldsAll(model.steps[i])) continue;
    const std::size_t lines = foldedLines(stateAfter(i));
    if (lines >= most) best = i;
    most = std::max(most, lines);
  }
  if (most == 0) return std::nullopt;
  return best;
}

Moments momentsOf(const Model& model, const Timeline& timeline) {
  const std::size_t count = model.steps.size();
  const FoldedState& last = timeline.stateAfter(count);
  const auto stateAfter = [&](std::size_t i) -> const FoldedState& {
    return timeline.stateAfter(i);
  };
  Moments moments{0, false, HalfWay::None, {}, atRest(last)};
  moments.folded = stepsUntilFolded(model, stateAfter).value_or(count);
  moments.isOpenAtTheEnd = moments.folded < count && foldedLines(last) == 0;
  findHalf(model, timeline, moments);
  return moments;
}

}  // namespace kiri
