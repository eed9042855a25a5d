// SPDX-License-Identifier: MIT
#include "core/sweep/slides.h"

#include <cmath>
#include <optional>

#include "core/layers/plane_view.h"
#include "core/sweep/first_meeting.h"

namespace kiri {
namespace {

/// What passing an edge of the plane means for paper that slides.
enum class Passing { Harmless, Doubtful, Wrong };

class Slides {
 public:
  Slides(const FoldedState& state, const std::vector<bool>& moves, const AxisFrame& frame,
         FirstFound& found)
      : state_(state),
        moves_(moves),
        frame_(frame),
        found_(found),
        touch_(state.tolerance().match()) {}

  void meet(const Body& sliding) {
    const std::vector<Patch> inside = insideOf(state_, moves_, frame_, sliding.facet, touch_);
    PlaneView view(state_.pattern, state_.poses, state_.poseOf(sliding.facet));
    for (const Edge& edge : state_.pattern.edges) {
      const FacetId any = edge.left.isValid() ? edge.left : edge.right;
      if (edge.isCurved() || moves_[any.index] == moves_[sliding.facet.index]) continue;
      const Vec3 from = frame_.toFrame(state_.poseOf(any).apply(state_.pattern[edge.from]));
      const Vec3 to = frame_.toFrame(state_.poseOf(any).apply(state_.pattern[edge.to]));
      if (std::abs(from.z - sliding.zLow) > touch_ || std::abs(to.z - sliding.zLow) > touch_)
        continue;
      const Passing passing = passingOf(view, sliding.facet, edge);
      if (passing != Passing::Harmless) meet(sliding, inside, any, from, to, passing);
    }
  }

 private:
  /// The edge as a band that stands across the plane.
  std::optional<Patch> bandOf(Vec3 from, Vec3 to) const {
    const double span = distance(from, to);
    if (span <= 4 * touch_) return std::nullopt;
    const Vec3 along = (to - from) / span;
    const Vec3 a = from + along * touch_;
    const Vec3 b = to - along * touch_;
    const Vec3 up{0, 0, span / 4};
    Patch band;
    band.points = {a - up, b - up, b + up, a + up};
    band.normal = normalized(cross(along, up));
    band.offset = dot(band.normal, a);
    band.zLow = from.z - up.z;
    band.zHigh = from.z + up.z;
    return band;
  }

  void meet(const Body& sliding, const std::vector<Patch>& inside, FacetId owner, Vec3 from,
            Vec3 to, Passing passing) {
    const std::optional<Patch> band = bandOf(from, to);
    if (!band) return;
    const bool doesMove = moves_[sliding.facet.index];
    for (const Patch& patch : inside) {
      const std::optional<Meeting3> met = firstMeeting(
          doesMove ? patch : *band, doesMove ? *band : patch, frame_, {}, {touch_ / 8, touch_ / 4});
      if (!met) continue;
      found_.add({doesMove ? sliding.facet : owner, doesMove ? owner : sliding.facet, met->turn,
                  met->place, passing == Passing::Wrong});
    }
  }

  /// +1 and -1: the facet leaves the plane at the edge, along the axis or against it; 0: it lies in
  /// it.
  int leavingOf(const Edge& edge, FacetId facet) const {
    const Vec2 along = normalized(state_.pattern[edge.to] - state_.pattern[edge.from]);
    const Vec2 in = facet == edge.left ? perpendicular(along) : -perpendicular(along);
    const double rise = dot(frame_.z, state_.poseOf(facet).direction(in));
    if (std::abs(rise) <= kSamePlane) return 0;
    return rise > 0 ? 1 : -1;
  }

  Passing passingOf(PlaneView& view, FacetId sliding, const Edge& edge) const {
    if (edge.kind != EdgeKind::Hinge) {
      bool isNew = false;
      for (const FacetId f : {edge.left, edge.right}) {
        isNew = isNew || (f.isValid() && leavingOf(edge, f) == 0 && !lieTogether(view, sliding, f));
      }
      return isNew ? Passing::Doubtful : Passing::Harmless;
    }
    const int left = leavingOf(edge, edge.left);
    const int right = leavingOf(edge, edge.right);
    if (left == 0 && right == 0) return passingWithin(view, sliding, edge);
    if (left != 0 && right != 0) return left == right ? Passing::Harmless : Passing::Wrong;
    const FacetId lying = left == 0 ? edge.left : edge.right;
    if (!lieTogether(view, sliding, lying)) return Passing::Doubtful;
    return isAbove(sliding, lying) == (left + right > 0) ? Passing::Wrong : Passing::Harmless;
  }

  /// Both facets of the hinge lie in the plane.
  Passing passingWithin(PlaneView& view, FacetId sliding, const Edge& edge) const {
    const bool isOverLeft = lieTogether(view, sliding, edge.left);
    const bool isOverRight = lieTogether(view, sliding, edge.right);
    if (edge.angle == 0) return isOverLeft || isOverRight ? Passing::Harmless : Passing::Doubtful;
    if (!isOverLeft || !isOverRight) return Passing::Doubtful;
    const bool isBetween = isAbove(sliding, edge.left) != isAbove(sliding, edge.right);
    return isBetween ? Passing::Wrong : Passing::Harmless;
  }

  bool lieTogether(PlaneView& view, FacetId a, FacetId b) const {
    return state_.layers.areCoplanar(a, b) && view.doOverlap(a, b);
  }

  /// Along the axis. Requires facets that lie together.
  bool isAbove(FacetId a, FacetId b) const {
    const Vec3 up = state_.layers.sets()[state_.layers.setOf(a)].normal;
    return state_.layers.isAbove(a, b) == (dot(up, frame_.z) > 0);
  }

  const FoldedState& state_;
  const std::vector<bool>& moves_;
  const AxisFrame& frame_;
  FirstFound& found_;
  double touch_;
};

}  // namespace

void meetSlides(const FoldedState& state, const std::vector<bool>& moves,
                const std::vector<Body>& moving, const std::vector<Body>& resting,
                const AxisFrame& frame, FirstFound& found) {
  Slides slides(state, moves, frame, found);
  for (const auto* bodies : {&moving, &resting}) {
    for (const Body& body : *bodies) {
      if (body.stance == Stance::Level) slides.meet(body);
    }
  }
}

}  // namespace kiri
