// Which face lies over which, as FOLD says it.
// SPDX-License-Identifier: MIT
#include "io/face_orders.h"

#include <algorithm>
#include <utility>

#include "core/geometry/bounds.h"
#include "core/geometry/convex.h"

namespace kiri {

namespace {

/// A face as it lies in the plane of its set.
struct PlaneFace {
  std::uint32_t face = 0;
  FacetId facet;
  std::uint32_t rank = 0;
  std::vector<Vec2> polygon;  // counter-clockwise
  Box box;
};

PlaneFace layDown(const FoldedState& state, const FacetMesh& mesh, std::uint32_t face,
                  const Rigid& plane) {
  const MeshFace& source = mesh.faces[face];
  PlaneFace out{face, source.facet, state.layers.rankOf(source.facet), {}, {}};
  for (const std::uint32_t v : source.vertices) {
    out.polygon.push_back(plane.pullBack(state.poseOf(source.facet).apply(mesh.vertices[v])));
  }
  if (signedArea(out.polygon) < 0) std::reverse(out.polygon.begin(), out.polygon.end());
  out.box = boundsOf(out.polygon);
  return out;
}

/// The pairs (positions in `faces`) whose boxes overlap, lower rank first, found by sweeping along
/// x.
std::vector<std::vector<std::uint32_t>> candidatesBelow(const std::vector<PlaneFace>& faces) {
  std::vector<std::uint32_t> order(faces.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(faces[a].box.low.x, a) < std::pair(faces[b].box.low.x, b);
  });
  std::vector<std::vector<std::uint32_t>> below(faces.size());
  std::vector<std::uint32_t> active;
  for (const std::uint32_t i : order) {
    const PlaneFace& face = faces[i];
    active.erase(
        std::remove_if(active.begin(), active.end(),
                       [&](std::uint32_t j) { return faces[j].box.high.x <= face.box.low.x; }),
        active.end());
    for (const std::uint32_t j : active) {
      const bool isApart =
          faces[j].box.high.y <= face.box.low.y || face.box.high.y <= faces[j].box.low.y;
      if (isApart || faces[j].facet == face.facet) continue;
      const bool isLower = std::pair(faces[j].rank, j) < std::pair(face.rank, i);
      below[isLower ? i : j].push_back(isLower ? j : i);
    }
    active.push_back(i);
  }
  return below;
}

/// Collects the orders of one layer-set.
class SetOrders {
 public:
  SetOrders(const FoldedState& state, const LayerSet& set, std::vector<PlaneFace> faces)
      : state_(state), set_(set), faces_(std::move(faces)) {
    std::stable_sort(faces_.begin(), faces_.end(),
                     [](const PlaneFace& a, const PlaneFace& b) { return a.rank < b.rank; });
    constexpr std::size_t kFew = 256;
    constexpr std::size_t kTooMany = 16384;
    isReduced_ = set.exceptions.empty() && faces_.size() > kFew && faces_.size() <= kTooMany;
  }

  void appendTo(FaceOrders& out) {
    std::vector<std::vector<std::uint32_t>> below = candidatesBelow(faces_);
    const std::size_t words = isReduced_ ? (faces_.size() + 63) / 64 : 0;
    implied_.assign(faces_.size(), std::vector<std::uint64_t>(words, 0));
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
      std::sort(below[i].rbegin(), below[i].rend());
      for (const std::uint32_t j : below[i]) {
        if (isReduced_ && isImplied(i, j)) {
          out.isReduced = true;
          continue;
        }
        if (!overlap(faces_[i].polygon, faces_[j].polygon, state_.tolerance().fat())) continue;
        out.list.push_back(orderOf(faces_[i], faces_[j]));
        if (isReduced_) imply(i, j);
      }
    }
  }

 private:
  bool isImplied(std::uint32_t i, std::uint32_t j) const {
    return (implied_[i][j / 64] >> (j % 64) & 1) != 0;
  }

  void imply(std::uint32_t i, std::uint32_t j) {
    for (std::size_t w = 0; w < implied_[i].size(); ++w) implied_[i][w] |= implied_[j][w];
    implied_[i][j / 64] |= std::uint64_t{1} << (j % 64);
  }

  FaceOrder orderOf(const PlaneFace& a, const PlaneFace& b) const {
    const PlaneFace& f = a.face < b.face ? a : b;
    const PlaneFace& g = a.face < b.face ? b : a;
    const bool isUp = dot(state_.poseOf(g.facet).normal(), set_.normal) > 0;
    const bool isAbove = state_.layers.isAbove(f.facet, g.facet);
    return {f.face, g.face, isAbove == isUp ? 1 : -1};
  }

  const FoldedState& state_;
  const LayerSet& set_;
  std::vector<PlaneFace> faces_;
  bool isReduced_ = false;
  std::vector<std::vector<std::uint64_t>>
      implied_;  // for each face a bit for each face that is known to lie below
};

}  // namespace

FaceOrders faceOrdersOf(const FoldedState& state, const FacetMesh& mesh) {
  const std::vector<LayerSet>& sets = state.layers.sets();
  std::vector<std::vector<PlaneFace>> faces(sets.size());
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const std::uint32_t set = state.layers.setOf(mesh.faces[f].facet);
    const Rigid& plane = state.poseOf(sets[set].upward.front());
    faces[set].push_back(layDown(state, mesh, f, plane));
  }
  FaceOrders out;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    if (faces[s].size() > 1) SetOrders(state, sets[s], std::move(faces[s])).appendTo(out);
  }
  std::sort(out.list.begin(), out.list.end(), [](const FaceOrder& a, const FaceOrder& b) {
    return std::pair(a.f, a.g) < std::pair(b.f, b.g);
  });
  return out;
}

}  // namespace kiri
