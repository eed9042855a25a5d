// Splitting edges, dividing facets, dropping facets.
// SPDX-License-Identifier: MIT
#include "core/paper/pattern_edit.h"

#include <algorithm>
#include <cmath>

namespace kiri {
namespace {

/// Puts `second` behind (or, where the facet runs backwards, before) `first` in the border of a
/// facet.
void insertUse(Facet& facet, EdgeId first, EdgeId second) {
  for (std::size_t i = 0; i < facet.border.size(); ++i) {
    if (facet.border[i].edge != first) continue;
    const bool isReversed = facet.border[i].isReversed;
    const std::size_t at = isReversed ? i : i + 1;
    facet.border.insert(facet.border.begin() + static_cast<std::ptrdiff_t>(at),
                        {second, isReversed});
    for (std::uint32_t& start : facet.holeStarts) {
      if (start > i) ++start;
    }
    ++i;
  }
}

// ---- dividing a facet: the half-edges that bound it are retraced into loops ----

struct HalfEdge {
  EdgeUse use;
  VertexId start;
  VertexId end;
};

using LoopOfUses = std::vector<EdgeUse>;

/// A number in (0, 4] that grows with the clockwise angle from direction `from` to direction `to`.
double clockwiseTurn(Vec2 from, Vec2 to) {
  const Vec2 a = normalized(from);
  const Vec2 b = normalized(to);
  const double s = -cross(a, b);
  const double c = dot(a, b);
  const double quarter = s >= 0 ? 1 - c : 3 + c;
  return quarter > 0 ? quarter : 4;
}

/// True when two arcs, one of them curved, leave their common start in one direction.
bool leaveAlike(const Arc& a, const Arc& b) {
  if (!a.isCurved && !b.isCurved) return false;
  const Vec2 u = startDirection(a);
  const Vec2 v = startDirection(b);
  return std::abs(cross(u, v)) < kParallel && dot(u, v) > 0;
}

/// Clockwise turn from the way back along an arc to an arc that leaves its end, as it is a little
/// farther on: tells arcs apart that leave alike.
double turnAhead(const Arc& back, const Arc& out) {
  constexpr double kAhead = 1.0 / 16;
  return clockwiseTurn(pointAt(back, kAhead) - back.start, pointAt(out, kAhead) - out.start);
}

/// Clockwise turn from the way back along an arc to an arc that leaves its end.
double turnBetween(const Arc& back, const Arc& out) {
  if (leaveAlike(back, out)) return turnAhead(back, out);
  return clockwiseTurn(startDirection(back), startDirection(out));
}

class Retracer {
 public:
  Retracer(const CreasePattern& pattern, std::vector<HalfEdge> halfEdges)
      : pattern_(pattern), halfEdges_(std::move(halfEdges)) {
    for (std::size_t i = 0; i < halfEdges_.size(); ++i)
      byStart_.emplace_back(halfEdges_[i].start, i);
    std::sort(byStart_.begin(), byStart_.end());
  }

  std::vector<LoopOfUses> loops() const {
    std::vector<LoopOfUses> result;
    std::vector<bool> isDone(halfEdges_.size(), false);
    for (std::size_t first = 0; first < halfEdges_.size(); ++first) {
      if (isDone[first]) continue;
      LoopOfUses loop;
      for (std::size_t h = first; !isDone[h]; h = next(h)) {
        isDone[h] = true;
        loop.push_back(halfEdges_[h].use);
      }
      result.push_back(std::move(loop));
    }
    return result;
  }

 private:
  /// The half-edge that keeps the same piece of paper on its left: the first one clockwise from the
  /// way back.
  std::size_t next(std::size_t h) const {
    constexpr double kWayBack = 4.5;  // behind a full turn
    const VertexId at = halfEdges_[h].end;
    auto it =
        std::lower_bound(byStart_.begin(), byStart_.end(), std::make_pair(at, std::size_t{0}));
    KIRI_CHECK(it != byStart_.end() && it->first == at, "the border of a facet is closed");
    const auto second = it + 1;
    if (second == byStart_.end() || second->first != at) return it->second;
    const EdgeUse use = halfEdges_[h].use;
    const Arc back = arcOf(pattern_, EdgeUse{use.edge, !use.isReversed});
    std::size_t best = it->second;
    double bestTurn = 5;
    Arc bestArc;
    for (; it != byStart_.end() && it->first == at; ++it) {
      const EdgeUse out = halfEdges_[it->second].use;
      const bool isWayBack = out.edge == use.edge && out.isReversed != use.isReversed;
      const Arc arc = arcOf(pattern_, out);
      const double turn = isWayBack ? kWayBack : turnBetween(back, arc);
      const bool isTied = turn < kWayBack && bestTurn < kWayBack && leaveAlike(arc, bestArc);
      if (isTied ? turnAhead(back, arc) < turnAhead(back, bestArc) : turn < bestTurn) {
        bestTurn = turn;
        bestArc = arc;
        best = it->second;
      }
    }
    return best;
  }

  const CreasePattern& pattern_;
  std::vector<HalfEdge> halfEdges_;
  std::vector<std::pair<VertexId, std::size_t>> byStart_;
};

double signedDoubleArea(const CreasePattern& pattern, const LoopOfUses& loop) {
  // Relative to a corner of the loop, so that thin loops far from the origin keep their sign.
  const Vec2 base = pattern[startOf(pattern, loop.front())];
  double sum = 0;
  for (const EdgeUse use : loop) {
    Arc arc = arcOf(pattern, use);
    arc.start = arc.start - base;
    arc.end = arc.end - base;
    arc.control1 = arc.control1 - base;
    arc.control2 = arc.control2 - base;
    sum += doubleArea(arc);
  }
  return sum;
}

bool isInside(const CreasePattern& pattern, const LoopOfUses& hole, const LoopOfUses& outer) {
  Region region;
  region.loops.emplace_back();
  for (const EdgeUse use : outer) region.loops[0].push_back(arcOf(pattern, use));
  for (const EdgeUse use : hole) {
    const Where where =
        locate(region, pointAt(arcOf(pattern, use), 0.5), pattern.tolerance.length());
    if (where != Where::OnBorder) return where == Where::Inside;
  }
  return false;
}

/// The smallest of the outer loops that hold the hole: a ring within a facet holds it as well as
/// the facet's own border does.
std::size_t ownerOf(const CreasePattern& pattern, const LoopOfUses& hole,
                    const std::vector<LoopOfUses>& outers) {
  if (outers.size() == 1) return 0;
  std::optional<std::size_t> owner;
  double least = 0;
  for (std::size_t i = 0; i < outers.size(); ++i) {
    if (!isInside(pattern, hole, outers[i])) continue;
    const double area = signedDoubleArea(pattern, outers[i]);
    if (owner && area >= least) continue;
    owner = i;
    least = area;
  }
  return owner.value_or(outers.size() - 1);
}

/// Outer loops with the holes that lie in them; the loop that starts first comes first.
std::vector<Facet> facetsOf(const CreasePattern& pattern, std::vector<LoopOfUses> loops) {
  const double flat = pattern.tolerance.length() * pattern.tolerance.length();
  std::vector<LoopOfUses> holes;
  std::vector<LoopOfUses> outers;
  for (LoopOfUses& loop : loops) {
    const bool isOuter = signedDoubleArea(pattern, loop) > flat;
    (isOuter ? outers : holes).push_back(std::move(loop));
  }
  KIRI_CHECK(!outers.empty(), "a facet has an outer border");
  std::vector<Facet> facets(outers.size());
  for (std::size_t i = 0; i < outers.size(); ++i) facets[i].border = outers[i];
  for (const LoopOfUses& hole : holes) {
    Facet& facet = facets[ownerOf(pattern, hole, outers)];
    facet.holeStarts.push_back(static_cast<std::uint32_t>(facet.border.size()));
    facet.border.insert(facet.border.end(), hole.begin(), hole.end());
  }
  return facets;
}

void claimBorder(CreasePattern& pattern, FacetId id) {
  for (const EdgeUse use : pattern[id].border) {
    (use.isReversed ? pattern[use.edge].right : pattern[use.edge].left) = id;
  }
}

EdgeId appendEdge(CreasePattern& pattern, const NewEdge& spec) {
  Edge edge;
  edge.from = spec.from;
  edge.to = spec.to;
  edge.kind = spec.kind;
  if (spec.curve) {
    edge.curve = static_cast<std::uint32_t>(pattern.curves.size());
    pattern.curves.push_back(*spec.curve);
  }
  pattern.edges.push_back(edge);
  return EdgeId(pattern.edges.size() - 1);
}

}  // namespace

VertexId addVertex(CreasePattern& pattern, Vec2 paper) {
  pattern.vertices.push_back(paper);
  return VertexId(pattern.vertices.size() - 1);
}

VertexId splitEdge(CreasePattern& pattern, EdgeId id, double t) {
  const Arc whole = arcOf(pattern, id);
  const VertexId middle = addVertex(pattern, pointAt(whole, t));
  Edge second = pattern[id];
  second.from = middle;
  if (second.isCurved()) {
    const Arc head = part(whole, 0, t);
    const Arc tail = part(whole, t, 1);
    pattern.curves[pattern[id].curve] = {head.control1, head.control2};
    second.curve = static_cast<std::uint32_t>(pattern.curves.size());
    pattern.curves.push_back({tail.control1, tail.control2});
  }
  pattern[id].to = middle;
  const EdgeId secondId(pattern.edges.size());
  pattern.edges.push_back(second);
  if (second.left.isValid()) insertUse(pattern[second.left], id, secondId);
  if (second.right.isValid() && second.right != second.left) {
    insertUse(pattern[second.right], id, secondId);
  }
  return middle;
}

std::vector<FacetId> divideFacet(CreasePattern& pattern, FacetId id,
                                 const std::vector<NewEdge>& edges) {
  if (edges.empty()) return {id};
  std::vector<HalfEdge> halfEdges;
  const auto add = [&](EdgeUse use) {
    halfEdges.push_back({use, startOf(pattern, use), endOf(pattern, use)});
  };
  for (const EdgeUse use : pattern[id].border) add(use);
  for (const NewEdge& spec : edges) {
    const EdgeId edge = appendEdge(pattern, spec);
    add({edge, false});
    add({edge, true});
  }
  std::vector<Facet> facets = facetsOf(pattern, Retracer(pattern, std::move(halfEdges)).loops());
  std::vector<FacetId> ids;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const FacetId made = i == 0 ? id : FacetId(pattern.facets.size());
    if (i == 0) {
      pattern[id] = std::move(facets[i]);
    } else {
      pattern.facets.push_back(std::move(facets[i]));
    }
    claimBorder(pattern, made);
    ids.push_back(made);
  }
  return ids;
}

namespace {

/// Gives the things that are used new numbers in their old order.
struct Renumbering {
  std::vector<std::uint32_t> newIndex;
  std::uint32_t count = 0;

  explicit Renumbering(const std::vector<bool>& isUsed) : newIndex(isUsed.size(), FacetId::kNone) {
    for (std::size_t i = 0; i < isUsed.size(); ++i) {
      if (isUsed[i]) newIndex[i] = count++;
    }
  }
  template <class AnyId>
  AnyId operator()(AnyId id) const {
    if (!id.isValid() || newIndex[id.index] == FacetId::kNone) return AnyId();
    return AnyId(newIndex[id.index]);
  }
};

}  // namespace

Kept keepFacets(const CreasePattern& pattern, const std::vector<bool>& keep) {
  std::vector<bool> edgeUsed(pattern.edges.size(), false);
  std::vector<bool> vertexUsed(pattern.vertices.size(), false);
  for (std::size_t f = 0; f < pattern.facets.size(); ++f) {
    if (!keep[f]) continue;
    for (const EdgeUse use : pattern.facets[f].border) {
      edgeUsed[use.edge.index] = true;
      vertexUsed[startOf(pattern, use).index] = true;
      vertexUsed[endOf(pattern, use).index] = true;
    }
  }
  const Renumbering newFacet(keep);
  const Renumbering newEdge(edgeUsed);
  const Renumbering newVertex(vertexUsed);
  Kept result{CreasePattern(pattern.tolerance), {}};
  for (std::size_t v = 0; v < vertexUsed.size(); ++v) {
    if (vertexUsed[v]) result.pattern.vertices.push_back(pattern.vertices[v]);
  }
  for (std::size_t e = 0; e < edgeUsed.size(); ++e) {
    if (!edgeUsed[e]) continue;
    Edge edge = pattern.edges[e];
    edge.from = newVertex(edge.from);
    edge.to = newVertex(edge.to);
    edge.left = newFacet(edge.left);
    edge.right = newFacet(edge.right);
    if (!edge.left.isValid() || !edge.right.isValid()) edge.kind = EdgeKind::Border;
    if (edge.isCurved()) {
      result.pattern.curves.push_back(pattern.curves[edge.curve]);
      edge.curve = static_cast<std::uint32_t>(result.pattern.curves.size() - 1);
    }
    result.pattern.edges.push_back(edge);
  }
  for (std::size_t f = 0; f < keep.size(); ++f) {
    if (!keep[f]) continue;
    Facet facet = pattern.facets[f];
    for (EdgeUse& use : facet.border) use.edge = newEdge(use.edge);
    result.pattern.facets.push_back(std::move(facet));
    result.origin.push_back(FacetId(f));
  }
  return result;
}

}  // namespace kiri
