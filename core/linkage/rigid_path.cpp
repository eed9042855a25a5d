// Straight motions, and what lies between the samples of a followed one.
// SPDX-License-Identifier: MIT
#include "core/linkage/rigid_path.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/linkage/closure.h"
#include "core/linkage/continuation.h"

namespace kiri {
namespace {

/// Moments at which a straight motion is tested. A loop that closes at so many, unevenly spread,
/// closes throughout: its equations are sums of few sines.
constexpr int kStraightTests = 37;

FoldAngles between(const FoldAngles& a, const FoldAngles& b, double part) {
  if (part == 1) return b;
  FoldAngles angles = a;
  for (std::size_t e = 0; e < a.size(); ++e) angles[e] += part * (b[e] - a[e]);
  return angles;
}

bool closesStraight(const Closure& closure, const FoldAngles& start, const FoldAngles& end) {
  if (!closure.hasLoops()) return true;
  // Half way first: where a straight motion fails, it mostly fails there.
  for (int i = kStraightTests; i > 0; --i) {
    const double part = std::sqrt(static_cast<double>(i) / kStraightTests);
    if (closure.error(between(start, end, part / 2)) > kClosedLoop) return false;
    if (closure.error(between(start, end, 1 - part / 2)) > kClosedLoop) return false;
  }
  return closure.error(end) <= kClosedLoop;
}

}  // namespace

FoldAngles anglesOf(const CreasePattern& pattern) {
  FoldAngles angles;
  angles.reserve(pattern.edges.size());
  for (const Edge& edge : pattern.edges)
    angles.push_back(edge.kind == EdgeKind::Hinge ? edge.angle : 0);
  return angles;
}

double closureError(const CreasePattern& pattern, const std::vector<Rest>& rests,
                    const FoldAngles& angles) {
  CreasePattern folded = pattern;
  for (std::size_t e = 0; e < angles.size(); ++e) {
    if (folded.edges[e].kind == EdgeKind::Hinge) folded.edges[e].angle = angles[e];
  }
  const std::vector<Rigid> poses = derivePoses(folded, rests);
  double worst = 0;
  for (const Edge& edge : folded.edges) {
    if (edge.kind != EdgeKind::Hinge) continue;
    const Vec2 a = folded[edge.from];
    const Vec2 u = normalized(folded[edge.to] - a);
    const Rigid turned =
        compose(poses[edge.left.index], rotationAbout({a.x, a.y, 0}, {u.x, u.y, 0}, -edge.angle));
    for (const EdgeUse use : folded[edge.right].border) {
      const Vec2 corner = folded[startOf(folded, use)];
      worst =
          std::max(worst, distance(turned.apply(corner), poses[edge.right.index].apply(corner)));
    }
  }
  return worst;
}

RigidPath::RigidPath(PathRequest request, std::vector<Sample> samples, Stop stop,
                     std::shared_ptr<const Closure> closure)
    : request_(std::move(request)),
      samples_(std::move(samples)),
      stop_(std::move(stop)),
      closure_(std::move(closure)) {
  KIRI_CHECK(!samples_.empty(), "a path has a start");
}

bool RigidPath::arrives() const {
  const auto isThere = [&](EdgeId e) {
    return samples_.back().angles[e.index] == request_.wanted[e.index];
  };
  return isComplete() && std::all_of(request_.driven.begin(), request_.driven.end(), isThere) &&
         std::all_of(request_.free.begin(), request_.free.end(), isThere);
}

FoldAngles RigidPath::at(double part) const {
  KIRI_CHECK(part >= 0 && part <= reach() + kSameMoment,
             "a moment of a path lies between its ends");
  part = std::min(part, reach());
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), part,
                                      [](const Sample& s, double p) { return s.part < p; });
  if (after->part == part) return after->angles;
  const Sample& a = *(after - 1);
  const Sample& b = *after;
  FoldAngles angles = between(a.angles, b.angles, (part - a.part) / (b.part - a.part));
  if (!closure_) return angles;
  drive(angles, samples_.front().angles, request_, part);
  // Halfway between two samples this was tried when they were found; rather a jump than a stretch.
  if (!closure_->close(angles)) return a.angles;
  putFullOnes(angles);
  return angles;
}

RigidPath rigidPath(const FoldedState& state, const PathRequest& request,
                    const Progress& progress) {
  KIRI_CHECK(request.wanted.size() == state.pattern.edges.size(), "a wanted angle for each edge");
  const FoldAngles start = anglesOf(state.pattern);
  std::vector<EdgeId> changing = request.driven;
  changing.insert(changing.end(), request.free.begin(), request.free.end());
  FoldAngles end = start;
  for (const EdgeId e : changing) {
    KIRI_CHECK(state.pattern[e].kind == EdgeKind::Hinge, "only hinges change their angles");
    end[e.index] = request.wanted[e.index];
  }
  const auto closure = std::make_shared<const Closure>(state.pattern, changing, request.free);
  if (closesStraight(*closure, start, end))
    return RigidPath(request, {{0, start}, {1, end}}, {}, nullptr);
  PathRequest bounded = request;
  bounded.wanted = end;
  return continuedPath(start, bounded, closure, Closure(state.pattern, changing, changing),
                       progress);
}

}  // namespace kiri
