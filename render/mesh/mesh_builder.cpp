// Puts regions of planes into a mesh, triangle by triangle.
// SPDX-License-Identifier: MIT
#include "render/mesh/mesh_builder.h"

#include <cmath>
#include <cstddef>
#include <limits>

#include "core/geometry/region.h"

namespace kiri {
namespace {

double doubleAreaOf(const Points& loop) {
  double sum = 0;
  Vec2 last = loop.back();
  for (const Vec2 p : loop) {
    sum += cross(last - loop[0], p - loop[0]);
    last = p;
  }
  return sum;
}

/// How often the loop winds around p.
int windingOf(const Points& loop, Vec2 p) {
  int winding = 0;
  Vec2 a = loop.back();
  for (const Vec2 b : loop) {
    const double side = cross(b - a, p - a);
    if (a.y <= p.y && b.y > p.y && side > 0) ++winding;
    if (a.y > p.y && b.y <= p.y && side < 0) --winding;
    a = b;
  }
  return winding;
}

Loop asLoop(const Points& points) {
  Loop loop;
  loop.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    loop.push_back(Arc::line(points[i], points[i + 1 < points.size() ? i + 1 : 0]));
  }
  return loop;
}

/// A convex polygon that turns at three of its points at least.
bool isConvex(const Points& points) {
  int turnsOfY = 0;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = points[i];
    const Vec2 b = points[(i + 1) % n];
    const Vec2 c = points[(i + 2) % n];
    if (!(cross(b - a, c - b) >= 0)) return false;
    const auto pointsUp = [](Vec2 d) { return d.y > 0 || (d.y == 0 && d.x > 0); };
    if (pointsUp(b - a) != pointsUp(c - b)) ++turnsOfY;
  }
  return turnsOfY == 2;
}

}  // namespace

Vec3 asVec(const std::array<float, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

std::array<float, 3> floats(Vec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

MeshBuilder::MeshBuilder(PaperMesh& mesh, const Tolerance& tolerance)
    : mesh_(mesh), tolerance_(tolerance), grain_(std::ldexp(1.0, std::ilogb(tolerance.match()))) {}

std::array<float, 3> MeshBuilder::rounded(Vec3 place) const {
  const Vec3 grains = (place - mesh_.origin) / grain_;
  return floats(Vec3{std::round(grains.x), std::round(grains.y), std::round(grains.z)} * grain_);
}

std::array<float, 3> MeshBuilder::placeOf(const MeshSide& side, Vec2 p) const {
  return rounded(side.frame.onPlane(p, side.point, side.frame.toEye));
}

void MeshBuilder::addPaper(const MeshSide& side, const std::vector<Points>& loops) {
  if (loops.size() == 1) {
    addRegion(side, loops[0], {});
    return;
  }
  std::vector<double> areas;
  for (const Points& loop : loops) areas.push_back(doubleAreaOf(loop));
  std::vector<std::vector<const Points*>> holes(loops.size());
  for (std::size_t h = 0; h < loops.size(); ++h) {
    if (areas[h] > 0) continue;
    // The smallest border around it. A hole may touch its border at corners, so ask in the middle
    // of a side.
    const Vec2 p = lerp(loops[h][0], loops[h][1], 0.5);
    double best = std::numeric_limits<double>::infinity();
    std::size_t owner = loops.size();
    for (std::size_t b = 0; b < loops.size(); ++b) {
      if (areas[b] <= 0 || areas[b] >= best || windingOf(loops[b], p) == 0) continue;
      best = areas[b];
      owner = b;
    }
    if (owner < loops.size()) holes[owner].push_back(&loops[h]);
  }
  for (std::size_t b = 0; b < loops.size(); ++b) {
    if (areas[b] > 0) addRegion(side, loops[b], holes[b]);
  }
}

void MeshBuilder::addRegion(const MeshSide& side, const Points& border,
                            const std::vector<const Points*>& holes) {
  if (border.size() < 3) return;
  if (holes.empty() && isConvex(border)) {
    addConvex(side, border);
    return;
  }
  Region region;
  region.loops.push_back(asLoop(border));
  for (const Points* hole : holes) region.loops.push_back(asLoop(*hole));
  for (const ConvexPart& part : convexParts(region, tolerance_)) addConvex(side, part.points);
}

void MeshBuilder::addConvex(const MeshSide& side, const Points& points) {
  const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
  const Vec3 toEye = side.frame.toEye;
  const std::array<float, 3> normal = floats(toEye);
  const auto height = static_cast<float>(dot(toEye, side.point - mesh_.origin));
  for (const Vec2 p : points) {
    const Vec3 place = side.frame.onPlane(p, side.point, side.frame.toEye);
    const Vec2 paper = side.pose.pullBack(place);
    mesh_.vertices.push_back({rounded(place),
                              normal,
                              height,
                              {static_cast<float>(paper.x), static_cast<float>(paper.y)},
                              side.facet.index,
                              side.showsFront ? 1U : 0U});
  }
  // By halves, not as a fan: no needles where the border is round.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> chains{
      {0, static_cast<std::uint32_t>(points.size() - 1)}};
  while (!chains.empty()) {
    const auto [from, to] = chains.back();
    chains.pop_back();
    if (to - from < 2) continue;
    const std::uint32_t middle = (from + to) / 2;
    for (const std::uint32_t i : {from, middle, to}) mesh_.triangles.push_back(first + i);
    chains.emplace_back(from, middle);
    chains.emplace_back(middle, to);
  }
}

void MeshBuilder::addShades(const MeshSide& side, const Points& points) {
  constexpr float kBesideALayer = 0.6F;
  double behind = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) behind += distance(points[i], points[i + 1]);
  double before = 0;
  std::array<float, 3> from = placeOf(side, points[0]);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double own = distance(points[i], points[i + 1]);
    behind -= own;
    const std::array<float, 3> to = placeOf(side, points[i + 1]);
    mesh_.shades.push_back({from, to, floats(side.frame.toEye), static_cast<float>(before),
                            static_cast<float>(behind), kBesideALayer, side.facet.index, false});
    from = to;
    before += own;
  }
}

void MeshBuilder::addValleys(const std::vector<MeshSegment>& lines) {
  for (const MeshSegment& line : lines) {
    const Vec3 run = asVec(line.to) - asVec(line.from);
    const Vec3 left = asVec(line.normal);
    const Vec3 right = asVec(line.otherNormal);
    // The paper on the right rises above the plane of that on the left. Within one plane it does
    // not, but for rounding.
    const double rise = dot(cross(right, -run), left);
    if (line.isCovered || rise <= kSamePlane * length(run)) continue;
    const auto strength = static_cast<float>((1 - dot(left, right)) / 2);
    mesh_.shades.push_back({line.from, line.to, line.normal, 0, 0, strength, line.facet, true});
    mesh_.shades.push_back(
        {line.to, line.from, line.otherNormal, 0, 0, strength, line.otherFacet, true});
  }
}

std::size_t MeshBuilder::addLine(const MeshSide& side, const Points& points, MeshSegment first,
                                 std::vector<MeshSegment>& out) const {
  const std::size_t number = out.size();
  double along = 0;
  std::array<float, 3> from = placeOf(side, points[0]);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    MeshSegment segment = first;
    segment.from = from;
    segment.to = from = placeOf(side, points[i + 1]);
    segment.along = static_cast<float>(along);
    segment.isFromJoined = i > 0;
    segment.isToJoined = i + 2 < points.size();
    along += distance(points[i], points[i + 1]);
    out.push_back(segment);
  }
  return number;
}

}  // namespace kiri
