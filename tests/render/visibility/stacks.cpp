// States put together by hand, and brute-force answers to what is seen of them.
// SPDX-License-Identifier: MIT
#include "tests/render/visibility/stacks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace kiri::testing {
namespace {

/// True when a hides b at p, by the stored relation or the depth there.
bool hides(const FoldedState& state, const ViewFrame& view, FacetId a, FacetId b, double depthA,
           double depthB) {
  if (!state.layers.areCoplanar(a, b)) return depthA > depthB;
  const LayerSet& set = state.layers.sets()[state.layers.setOf(a)];
  const Vec3 toEye = view.eyeDistance > 0
                         ? view.centre + view.toEye * view.eyeDistance - state.poseOf(a).origin
                         : view.toEye;
  return state.layers.isAbove(a, b) == (dot(set.normal, toEye) > 0);
}

/// Where the line of sight through p meets the plane of the facet.
std::optional<Vec3> pointOn(const FoldedState& state, const ViewFrame& view, FacetId f, Vec2 p) {
  const Rigid& pose = state.poseOf(f);
  if (view.eyeDistance > 0) {  // from the eye through the point's place in the plane of the centre
    const Vec3 eye = view.centre + view.toEye * view.eyeDistance;
    const Vec3 place = view.centre + view.right * (p.x - dot(view.centre, view.right)) +
                       view.up * (p.y - dot(view.centre, view.up));
    const double along = dot(pose.normal(), place - eye);
    if (std::abs(along) < 1e-4 * view.eyeDistance) return std::nullopt;
    return eye + (place - eye) * (dot(pose.normal(), pose.origin - eye) / along);
  }
  const double towards = dot(pose.normal(), view.toEye);
  if (std::abs(towards) < 1e-4) return std::nullopt;
  const Vec3 onScreen = view.right * p.x + view.up * p.y;
  const double depth = dot(pose.normal(), pose.origin - onScreen) / towards;
  return onScreen + view.toEye * depth;
}

struct Segment {
  Vec2 a, b;
  double at(double x) const { return a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x)); }
};

}  // namespace

FacetId StackBuilder::add(const std::vector<Loop>& loops, const Rigid& pose) {
  CreasePattern& pattern = state_.pattern;
  const FacetId id(pattern.facets.size());
  Facet facet;
  for (const Loop& loop : loops) {
    if (!facet.border.empty())
      facet.holeStarts.push_back(static_cast<std::uint32_t>(facet.border.size()));
    const std::size_t first = pattern.vertices.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      pattern.vertices.push_back(loop[i].start);
      Edge edge;
      edge.from = VertexId(first + i);
      edge.to = VertexId(first + (i + 1) % loop.size());
      edge.left = id;
      if (loop[i].isCurved) {
        edge.curve = static_cast<std::uint32_t>(pattern.curves.size());
        pattern.curves.push_back({loop[i].control1, loop[i].control2});
      }
      facet.border.push_back({EdgeId(pattern.edges.size()), false});
      pattern.edges.push_back(edge);
    }
  }
  pattern.facets.push_back(facet);
  state_.poses.push_back(pose);
  state_.rests.push_back({id, pose});
  return id;
}

FacetId StackBuilder::add(const std::vector<Vec2>& polygon, const Rigid& pose) {
  Loop loop;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    loop.push_back(Arc::line(polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  return add(std::vector<Loop>{loop}, pose);
}

FacetId StackBuilder::addBackUp(const std::vector<Vec2>& polygon) {
  std::vector<Vec2> onPaper;
  for (const Vec2 p : polygon) onPaper.insert(onPaper.begin(), {-p.x, p.y});
  return add(onPaper, Rigid{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 0}});
}

FoldedState StackBuilder::stacked(std::vector<std::pair<FacetId, FacetId>> exceptions) {
  LayerSet all{{0, 0, 1}, {}, {exceptions.begin(), exceptions.end()}};
  for (std::size_t i = 0; i < state_.pattern.facets.size(); ++i) all.upward.emplace_back(i);
  sets_ = {all};
  return state();
}

FoldedState StackBuilder::state() {
  state_.layers = LayerOrder(sets_);
  return state_;
}

std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

std::vector<Vec2> square(double x, double y, double side) {
  return rectangle(x, y, x + side, y + side);
}

FoldedState pinwheel() {
  StackBuilder stack(6);
  const FacetId centre = stack.addBackUp(rectangle(-1, -1, 1, 1));
  const FacetId w = stack.add(rectangle(-1, -1, 0, 1));
  const FacetId s = stack.add(rectangle(-1, -1, 1, 0));
  const FacetId e = stack.add(rectangle(0, -1, 1, 1));
  const FacetId n = stack.add(rectangle(-1, 0, 1, 1));
  (void)centre, (void)s, (void)e;
  return stack.stacked({{w, n}});  // the list says centre < W < S < E < N; W over N closes the ring
}

std::optional<std::optional<FacetId>> seenAt(const FoldedState& state, const ViewFrame& view,
                                             Vec2 p, double margin) {
  std::vector<std::pair<FacetId, double>> there;
  for (std::size_t i = 0; i < state.pattern.facets.size(); ++i) {
    const FacetId f(i);
    const auto point = pointOn(state, view, f, p);
    if (!point) continue;
    const Where where =
        locate(kiri::regionOf(state.pattern, f), state.poseOf(f).pullBack(*point), margin);
    if (where == Where::OnBorder) return std::nullopt;
    const double near = view.eyeDistance > 0
                            ? -distance(*point, view.centre + view.toEye * view.eyeDistance)
                            : view.depth(*point);
    if (where == Where::Inside) there.emplace_back(f, near);
  }
  std::vector<FacetId> top;
  for (const auto& [f, depth] : there) {
    const bool isHidden =
        std::any_of(there.begin(), there.end(), [&, f = f, depth = depth](const auto& other) {
          return other.first != f && hides(state, view, other.first, f, other.second, depth);
        });
    if (!isHidden) top.push_back(f);
  }
  if (there.empty()) return std::optional<FacetId>{};
  if (top.size() != 1) return std::nullopt;  // layers that contradict each other here
  return std::optional<FacetId>{top.front()};
}

std::vector<double> areasByTrapezoids(const FoldedState& state, const ViewFrame& view) {
  const std::size_t n = state.pattern.facets.size();
  std::vector<std::vector<Segment>> borders(n);
  std::vector<Segment> all;
  for (std::size_t i = 0; i < n; ++i) {
    for (const Loop& loop : kiri::regionOf(state.pattern, FacetId(i)).loops) {
      for (const Arc& arc : loop) {
        Vec2 a = view.project(state.poses[i].apply(arc.start));
        Vec2 b = view.project(state.poses[i].apply(arc.end));
        if (a.x > b.x) std::swap(a, b);
        borders[i].push_back({a, b});
        all.push_back({a, b});
      }
    }
  }
  std::vector<double> xs;
  for (std::size_t i = 0; i < all.size(); ++i) {
    xs.insert(xs.end(), {all[i].a.x, all[i].b.x});
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 d = all[i].b - all[i].a;
      const Vec2 e = all[j].b - all[j].a;
      const double det = cross(d, e);
      if (std::abs(det) <= 1e-12 * length(d) * length(e)) continue;
      const double t = cross(all[j].a - all[i].a, e) / det;
      const double u = cross(all[j].a - all[i].a, d) / det;
      if (t > 0 && t < 1 && u > 0 && u < 1) xs.push_back(all[i].a.x + t * d.x);
    }
  }
  std::sort(xs.begin(), xs.end());
  std::vector<double> areas(n, 0.0);
  for (std::size_t k = 1; k < xs.size(); ++k) {
    const double width = xs[k] - xs[k - 1];
    if (width <= 0) continue;
    const double x = (xs[k] + xs[k - 1]) / 2;
    std::vector<std::pair<double, double>>
        spans;  // y in the middle, and the mean of the two sides is the same
    std::vector<std::vector<double>> crossings(n);
    std::vector<double> ys;
    for (std::size_t i = 0; i < n; ++i) {
      for (const Segment& s : borders[i]) {
        if (s.a.x <= xs[k - 1] && s.b.x >= xs[k] && s.b.x > s.a.x) crossings[i].push_back(s.at(x));
      }
      std::sort(crossings[i].begin(), crossings[i].end());
      ys.insert(ys.end(), crossings[i].begin(), crossings[i].end());
    }
    std::sort(ys.begin(), ys.end());
    for (std::size_t m = 1; m < ys.size(); ++m) {
      const double y = (ys[m] + ys[m - 1]) / 2;
      std::vector<FacetId> there;
      for (std::size_t i = 0; i < n; ++i) {
        const auto below = std::count_if(crossings[i].begin(), crossings[i].end(),
                                         [&](double c) { return c < y; });
        if (below % 2 != 0) there.emplace_back(i);
      }
      for (const FacetId f : there) {
        const bool isTop = std::all_of(there.begin(), there.end(), [&](FacetId g) {
          return g == f || hides(state, view, f, g, 0, 0);
        });
        if (isTop) areas[f.index] += width * (ys[m] - ys[m - 1]);
      }
    }
  }
  return areas;
}

Region regionOf(const VisibleFacet& facet) {
  Region region;
  for (const auto& loop : facet.loops) {
    Loop& arcs = region.loops.emplace_back();
    for (const BoundaryPiece& piece : loop) arcs.push_back(piece.arc);
  }
  return region;
}

void expectSound(const FoldedState& state, const ViewFrame& view, const VisibleRegions& regions) {
  const double eps = 8 * state.tolerance().match();
  std::map<std::tuple<double, double, double, double, std::uint32_t, std::uint32_t>, int> seams;
  for (const VisibleFacet& facet : regions.facets) {
    for (const auto& loop : facet.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const BoundaryPiece& piece = loop[i];
        EXPECT_EQ(piece.arc.end, loop[(i + 1) % loop.size()].arc.start) << "loops close exactly";
        if (piece.edge.isValid()) {
          const Arc edge = arcOf(state.pattern, piece.edge);
          const Rigid& pose = state.poseOf(piece.facet);
          EXPECT_LE(distance(view.project(pose.apply(pointAt(edge, piece.from))), piece.arc.start),
                    eps);
          EXPECT_LE(distance(view.project(pose.apply(pointAt(edge, piece.to))), piece.arc.end),
                    eps);
          const Vec2 middle = view.project(pose.apply(pointAt(edge, (piece.from + piece.to) / 2)));
          // In perspective the nearer half of a straight line looks longer.
          EXPECT_LE(view.eyeDistance > 0 ? nearestOn(piece.arc, middle).distance
                                         : distance(middle, pointAt(piece.arc, 0.5)),
                    eps);
        }
        if (piece.isSilhouette()) continue;
        const Vec2 s = piece.arc.start;
        const Vec2 e = piece.arc.end;
        ++seams[{s.x, s.y, e.x, e.y, facet.facet.index, piece.beyond.index}];
        --seams[{e.x, e.y, s.x, s.y, piece.beyond.index, facet.facet.index}];
      }
    }
  }
  for (const auto& [seam, surplus] : seams) EXPECT_EQ(surplus, 0) << "each seam has its other side";
}

void expectEqualsPixels(const FoldedState& state, const ViewFrame& view,
                        const VisibleRegions& regions, int n) {
  const Box box = boundsOf(regions);
  const Vec2 size = box.high - box.low;
  std::vector<std::pair<FacetId, Region>> parts;
  for (const VisibleFacet& facet : regions.facets) parts.emplace_back(facet.facet, regionOf(facet));
  int asked = 0;
  for (int iy = 0; iy < n; ++iy) {
    for (int ix = 0; ix < n; ++ix) {
      // A little more than the box, and no row of pixels on a round number.
      const Vec2 p{box.low.x + size.x * ((ix + 0.5123) / n * 1.1 - 0.05),
                   box.low.y + size.y * ((iy + 0.4871) / n * 1.1 - 0.05)};
      const auto expected = seenAt(state, view, p, 1e-5 * state.tolerance().sheetSize());
      if (!expected) continue;
      ++asked;
      std::vector<FacetId> found;
      for (const auto& [facet, region] : parts) {
        if (locate(region, p, 0) != Where::Outside) found.push_back(facet);
      }
      ASSERT_LE(found.size(), 1U) << "disjoint at " << p.x << ", " << p.y;
      const std::optional<FacetId> got =
          found.empty() ? std::nullopt : std::optional<FacetId>(found.front());
      ASSERT_EQ(got.has_value(), expected->has_value()) << "silhouette at " << p.x << ", " << p.y;
      if (got) {
        ASSERT_EQ(got->index, (*expected)->index) << "at " << p.x << ", " << p.y;
      }
    }
  }
  EXPECT_GT(asked, n * n / 2) << "the oracle must have an opinion on most pixels";
}

}  // namespace kiri::testing
