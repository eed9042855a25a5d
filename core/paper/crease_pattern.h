// The sheet divided into facets by creases, tears and cuts: a planar map in the paper frame.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/ids.h"
#include "core/base/vec.h"
#include "core/geometry/region.h"
#include "core/geometry/tolerance.h"
#include "core/paper/sheet.h"

namespace kiri {

enum class EdgeKind : std::uint8_t {
  Border,  ///< paper on one side only: the rim of the sheet, or a cut whose other side was thrown
           ///< away
  Hinge,   ///< joins two facets, carries a fold angle; always straight
  Tear,    ///< torn hinge: two facets that no longer hold together here; can be mended
  Cut,  ///< a cut with paper on both sides; both sides may be one facet where the cut ends inside
        ///< it
};

/// A side shared by the facets left and right of it (seen from `from` to `to`, on the front of the
/// paper).
struct Edge {
  VertexId from;
  VertexId to;
  FacetId left;   ///< none where there is no paper
  FacetId right;  ///< none where there is no paper
  EdgeKind kind = EdgeKind::Border;
  bool leftMoves =
      false;  ///< hinge of a fold line: the left facet is on the side that its fold moved
  std::int8_t sign =
      1;             ///< hinge of a fold line: +1 when the fold's own direction makes this a valley
  FoldLineId line;   ///< the fold line that drives this hinge; none for an added edge
  double angle = 0;  ///< hinge: fold angle in degrees, valley positive, in [-180, 180]
  std::uint32_t curve =
      kStraight;  ///< index of its controls in CreasePattern::curves, or kStraight

  static constexpr std::uint32_t kStraight = 0xFFFFFFFF;
  bool isCurved() const { return curve != kStraight; }
};

/// An edge as one facet's border runs along it.
struct EdgeUse {
  EdgeId edge;
  bool isReversed = false;
  constexpr bool operator==(const EdgeUse&) const = default;
};

/// A connected piece of paper that stays flat. Its border runs with the facet on the left: `border`
/// lists the outer loop, then the holes; `holeStarts` says where in `border` each hole begins.
struct Facet {
  std::vector<EdgeUse> border;
  std::vector<std::uint32_t> holeStarts;
};

/// Control points of a curved edge, in the direction from `from` to `to`.
struct CurveControls {
  Vec2 control1;
  Vec2 control2;
};

/// The planar map. Invariants: facets are disjoint inside; both facets of a hinge run along the
/// same edge, so they share its two vertices; no two vertices are nearer than tolerance.length().
/// Ids are positions in the arrays: they hold for one state only.
struct CreasePattern {
  explicit CreasePattern(Tolerance t) : tolerance(t) {}

  Tolerance tolerance;
  std::vector<Vec2> vertices;  ///< paper frame, mm
  std::vector<Edge> edges;
  std::vector<Facet> facets;
  std::vector<CurveControls> curves;

  const Vec2& operator[](VertexId v) const { return vertices[v.index]; }
  const Edge& operator[](EdgeId e) const { return edges[e.index]; }
  Edge& operator[](EdgeId e) { return edges[e.index]; }
  const Facet& operator[](FacetId f) const { return facets[f.index]; }
  Facet& operator[](FacetId f) { return facets[f.index]; }
};

/// The pattern of an untouched sheet: one facet.
CreasePattern patternOf(const Sheet& sheet);

VertexId startOf(const CreasePattern& pattern, EdgeUse use);
VertexId endOf(const CreasePattern& pattern, EdgeUse use);
/// The facet on the other side of the edge; none at a border.
FacetId across(const Edge& edge, FacetId facet);
/// The geometry of an edge, in its own direction or in that of a use.
Arc arcOf(const CreasePattern& pattern, EdgeId edge);
Arc arcOf(const CreasePattern& pattern, EdgeUse use);
/// The paper of a facet, in the paper frame. Arc i of the region is border[i] of the facet.
Region regionOf(const CreasePattern& pattern, FacetId facet);
/// A point well inside the facet; names it in steps and messages.
Vec2 interiorPointOf(const CreasePattern& pattern, FacetId facet);
/// The facet that holds the point, or lies nearest to it within tolerance.pick(); the lowest id
/// when several do.
std::optional<FacetId> facetAt(const CreasePattern& pattern, Vec2 paper);
/// Area of all facets, mm^2.
double areaOf(const CreasePattern& pattern);

}  // namespace kiri
