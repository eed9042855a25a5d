// One facet as it lies in the view.
// SPDX-License-Identifier: MIT
#include "render/visibility/facet_view.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/check.h"
#include "core/geometry/bounds.h"

namespace kiri {
namespace {

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

bool isEdgeOn(const Rigid& pose, const ViewFrame& view, const Tolerance& tolerance) {
  const double towards = view.facing(pose.normal(), pose.origin);
  return std::abs(towards) * tolerance.sheetSize() < tolerance.pick();
}

double FacetView::onEdge(std::uint32_t arc, double t) const {
  if (!sources.empty()) t = sources[arc].onPaper(t);
  return uses[arc].isReversed ? 1 - t : t;
}

FacetViews::FacetViews(const FoldedState& state, const ViewFrame& view)
    : state_(state), frame_(view) {
  const auto& sets = state.layers.sets();
  views_.reserve(state.pattern.facets.size());
  std::vector<std::pair<double, std::uint32_t>>
      order;  // nearest first, so that far sets find their occluders
  for (std::uint32_t s = 0; s < sets.size(); ++s) {
    if (sets[s].upward.empty()) continue;
    order.emplace_back(-dot(state.poseOf(sets[s].upward.front()).origin, view.toEye), s);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [depth, s] : order) addSet(s);
  collectExceptions();
}

FacetViews::FacetViews(const FoldedState& state, const ViewFrame& view, std::uint32_t onlySet)
    : state_(state), frame_(view) {
  addSet(onlySet);
  collectExceptions();
}

void FacetViews::addSet(std::uint32_t set) {
  const LayerSet& layers = state_.layers.sets()[set];
  const Vec3 place = state_.poseOf(layers.upward.front()).origin;
  const bool isFlipped = frame_.facing(layers.normal, place) < 0;
  sets_.push_back({set, isFlipped});
  const auto& upward = layers.upward;
  for (std::size_t i = 0; i < upward.size(); ++i) {
    const std::size_t at = isFlipped ? i : upward.size() - 1 - i;
    add(upward[at], static_cast<std::uint32_t>(upward.size() - 1 - i));
  }
}

void FacetViews::add(FacetId facet, std::uint32_t rank) {
  const Rigid& pose = state_.poseOf(facet);
  if (isEdgeOn(pose, frame_, tolerance())) return;
  const double towards = frame_.facing(pose.normal(), pose.origin);
  FacetView out;
  out.id = facet;
  out.showsFront = towards > 0;
  out.set = sets_.back().number;
  out.isFlipped = sets_.back().isFlipped;
  out.rank = rank;
  // The plane of the facet, solved for depth; in perspective that of the projected space, in which
  // planes are planes again (ViewFrame::depth).
  const Vec2 across = frame_.direction(pose.normal());
  const Vec3 centre = frame_.isPerspective() ? frame_.centre : Vec3{};
  out.slope = across * (-1 / towards);
  out.depth0 =
      (dot(pose.normal(), pose.origin - centre) + dot(across, frame_.direction(centre))) / towards;
  addBorder(facet, out);
  if (out.arcs.empty()) return;
  out.box = boundsOf(out.arcs);
  out.isConvex = isConvexLoop(out, tolerance().match());
  views_.push_back(std::move(out));
}

void FacetViews::addBorder(FacetId facet, FacetView& out) const {
  const Rigid& pose = state_.poseOf(facet);
  const Facet& source = state_.pattern[facet];
  const std::size_t n = source.border.size();
  out.arcs.reserve(n);
  out.uses.reserve(n);
  std::vector<SeenArc> seen;
  for (std::size_t loop = 0; loop <= source.holeStarts.size(); ++loop) {
    const std::size_t from = loop == 0 ? 0 : source.holeStarts[loop - 1];
    const std::size_t to = loop < source.holeStarts.size() ? source.holeStarts[loop] : n;
    out.loopStarts.push_back(static_cast<std::uint32_t>(out.arcs.size()));
    for (std::size_t i = from; i < to; ++i) {
      EdgeUse use = source.border[out.showsFront ? i : from + to - 1 - i];
      if (!out.showsFront) use.isReversed = !use.isReversed;
      seen.clear();
      // Finer than places are told apart, so that layers cut along one curve stay together.
      appendSeen(arcOf(state_.pattern, use), pose, frame_, tolerance().match() / 2, seen);
      for (const SeenArc& part : seen) {
        out.arcs.push_back(part.arc);
        out.uses.push_back(use);
        if (!frame_.isPerspective()) continue;
        KIRI_CHECK(part.nearStart > 0 && part.nearEnd > 0, "the eye lies outside of the model");
        out.sources.push_back(part);
        const double nearest = std::max(part.nearStart, part.nearEnd);
        out.depthUnit = std::max(out.depthUnit, nearest * nearest);
      }
    }
  }
}

bool FacetViews::isPlainStack() const {
  return exceptions_.empty() && (views_.empty() || views_.front().set == views_.back().set);
}

double FacetViews::depthTolerance(const FacetView& a, const FacetView& b) const {
  const Vec2 d = a.slope - b.slope;
  return tolerance().match() * (std::max(a.depthUnit, b.depthUnit) + std::abs(d.x) + std::abs(d.y));
}

bool FacetViews::isOverInSet(const FacetView& a, const FacetView& b) const {
  if (state_.layers.sets()[a.set].exceptions.empty()) return a.rank > b.rank;
  return a.isFlipped ? state_.layers.isAbove(b.id, a.id) : state_.layers.isAbove(a.id, b.id);
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
  std::unordered_map<std::uint32_t, std::uint32_t> numbers;  // looked up, never walked
  for (const SetInView& seen : sets_) {
    const LayerSet& set = state_.layers.sets()[seen.number];
    if (set.exceptions.empty()) continue;
    if (numbers.empty()) {
      for (std::uint32_t i = 0; i < views_.size(); ++i) numbers.emplace(views_[i].id.index, i);
    }
    for (const auto& [upper, lower] : set.exceptions) {
      const auto over = numbers.find((seen.isFlipped ? lower : upper).index);
      const auto under = numbers.find((seen.isFlipped ? upper : lower).index);
      if (over != numbers.end() && under != numbers.end())
        exceptions_.emplace_back(under->second, over->second);
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
