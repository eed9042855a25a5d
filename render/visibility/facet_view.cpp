// One facet as it lies in the view.
// SPDX-License-Identifier: MIT
#include "render/visibility/facet_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kiri {
namespace {

constexpr std::uint32_t kAbsent = std::numeric_limits<std::uint32_t>::max();

/// The paper frame in view coordinates.
struct Placement {
  Vec2 x, y, origin;
  Vec2 apply(Vec2 p) const { return x * p.x + y * p.y + origin; }
  Arc apply(const Arc& arc) const {
    Arc out = arc;
    out.start = apply(arc.start);
    out.end = apply(arc.end);
    if (arc.isCurved) {
      out.control1 = apply(arc.control1);
      out.control2 = apply(arc.control2);
    }
    return out;
  }
};

Box boxOf(const std::vector<Arc>& arcs) {
  Box box = boundsOf(arcs.front());
  for (const Arc& arc : arcs) {
    const Box b = boundsOf(arc);
    box.low = {std::min(box.low.x, b.low.x), std::min(box.low.y, b.low.y)};
    box.high = {std::max(box.high.x, b.high.x), std::max(box.high.y, b.high.y)};
  }
  return box;
}

/// One straight loop that turns left everywhere and only once around.
bool isConvexLoop(const FacetView& view, double eps) {
  if (view.loopStarts.size() != 1) return false;
  const std::size_t n = view.arcs.size();
  int turnsOfX = 0;  // a convex loop changes its direction in x at most twice
  for (std::size_t i = 0; i < n; ++i) {
    const Arc& a = view.arcs[i];
    const Arc& b = view.arcs[(i + 1) % n];
    if (a.isCurved) return false;
    const Vec2 d = a.end - a.start;
    const Vec2 e = b.end - b.start;
    if (cross(d, e) < -eps * length(d)) return false;
    if (cross(d, e) <= eps * length(d) && dot(d, e) < 0) return false;
    if ((d.x < 0) != (e.x < 0)) ++turnsOfX;
  }
  return turnsOfX <= 2;
}

}  // namespace

Region FacetView::region() const {
  Region out;
  for (std::size_t i = 0; i < loopStarts.size(); ++i) {
    const std::size_t end = i + 1 < loopStarts.size() ? loopStarts[i + 1] : arcs.size();
    out.loops.emplace_back(arcs.begin() + loopStarts[i],
                           arcs.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return out;
}

FacetViews::FacetViews(const FoldedState& state, const ViewFrame& view) : state_(state) {
  const auto& sets = state.layers.sets();
  views_.reserve(state.pattern.facets.size());
  std::vector<std::pair<double, std::size_t>>
      order;  // nearest first, so that far sets find their occluders
  for (std::size_t s = 0; s < sets.size(); ++s) {
    hasExceptions_.push_back(!sets[s].exceptions.empty());
    isFlipped_.push_back(view.depth(sets[s].normal) < 0);
    const double depth =
        sets[s].upward.empty() ? 0 : view.depth(state.poseOf(sets[s].upward.front()).origin);
    order.emplace_back(-depth, s);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [depth, s] : order) {
    const auto& upward = sets[s].upward;
    for (std::size_t i = 0; i < upward.size(); ++i) {
      const std::size_t place = isFlipped_[s] ? i : upward.size() - 1 - i;
      add(upward[place], view, static_cast<std::uint32_t>(upward.size() - 1 - i));
    }
  }
  collectExceptions();
}

void FacetViews::add(FacetId facet, const ViewFrame& view, std::uint32_t rank) {
  const Rigid& pose = state_.poseOf(facet);
  const double towards = view.depth(pose.normal());
  // Seen edge-on: narrower than any line, and its depth would be all rounding.
  if (std::abs(towards) * tolerance().sheetSize() < tolerance().pick()) return;
  const Placement place{view.project(pose.x), view.project(pose.y), view.project(pose.origin)};
  const Facet& source = state_.pattern[facet];
  FacetView out;
  out.id = facet;
  out.showsFront = towards > 0;
  out.set = state_.layers.setOf(facet);
  out.rank = rank;
  out.slope = view.project(pose.normal()) * (-1 / towards);
  out.depth0 = dot(pose.normal(), pose.origin) / towards;
  const std::size_t n = source.border.size();
  out.arcs.reserve(n);
  out.uses.reserve(n);
  for (std::size_t loop = 0; loop <= source.holeStarts.size(); ++loop) {
    const std::size_t from = loop == 0 ? 0 : source.holeStarts[loop - 1];
    const std::size_t to = loop < source.holeStarts.size() ? source.holeStarts[loop] : n;
    out.loopStarts.push_back(static_cast<std::uint32_t>(from));
    for (std::size_t i = from; i < to; ++i) {
      EdgeUse use = source.border[out.showsFront ? i : from + to - 1 - i];
      if (!out.showsFront) use.isReversed = !use.isReversed;
      out.arcs.push_back(place.apply(arcOf(state_.pattern, use)));
      out.uses.push_back(use);
    }
  }
  if (out.arcs.empty()) return;
  out.box = boxOf(out.arcs);
  out.isConvex = isConvexLoop(out, tolerance().match());
  views_.push_back(std::move(out));
}

bool FacetViews::isPlainStack() const {
  return exceptions_.empty() && (views_.empty() || views_.front().set == views_.back().set);
}

double FacetViews::depthTolerance(const FacetView& a, const FacetView& b) const {
  const Vec2 d = a.slope - b.slope;
  return tolerance().match() * (1 + std::abs(d.x) + std::abs(d.y));
}

bool FacetViews::isOverInSet(const FacetView& a, const FacetView& b) const {
  if (!hasExceptions_[a.set]) return a.rank > b.rank;
  return isFlipped_[a.set] ? state_.layers.isAbove(b.id, a.id) : state_.layers.isAbove(a.id, b.id);
}

bool FacetViews::isOver(const FacetView& a, const FacetView& b, Vec2 p, Vec2 side) const {
  if (a.set == b.set) return isOverInSet(a, b);
  const double ahead = a.depthAt(p) - b.depthAt(p);
  if (std::abs(ahead) > depthTolerance(a, b)) return ahead > 0;
  const double rise = dot(a.slope - b.slope, side);
  if (std::abs(rise) > kParallel) return rise > 0;
  return a.id < b.id;
}

void FacetViews::collectExceptions() {
  std::vector<std::uint32_t> numberOf(state_.pattern.facets.size(), kAbsent);
  for (std::size_t i = 0; i < views_.size(); ++i) {
    numberOf[views_[i].id.index] = static_cast<std::uint32_t>(i);
  }
  const auto& sets = state_.layers.sets();
  for (std::size_t s = 0; s < sets.size(); ++s) {
    for (const auto& [upper, lower] : sets[s].exceptions) {
      const std::uint32_t over = numberOf[(isFlipped_[s] ? lower : upper).index];
      const std::uint32_t under = numberOf[(isFlipped_[s] ? upper : lower).index];
      if (over != kAbsent && under != kAbsent) exceptions_.emplace_back(under, over);
    }
  }
  std::sort(exceptions_.begin(), exceptions_.end());
}

std::vector<std::uint32_t> FacetViews::exceptionsOver(std::uint32_t number) const {
  std::vector<std::uint32_t> out;
  auto it = std::lower_bound(exceptions_.begin(), exceptions_.end(), std::pair{number, 0U});
  for (; it != exceptions_.end() && it->first == number; ++it) out.push_back(it->second);
  return out;
}

}  // namespace kiri
