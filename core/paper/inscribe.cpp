// Where lines and curves cross a facet.
// SPDX-License-Identifier: MIT
#include "core/paper/inscribe.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace kiri {
namespace {

/// A vertex on the chain: arc number plus parameter, and the vertex there.
struct Stop {
  std::size_t arc = 0;
  double t = 0;
  VertexId vertex;
};

/// Where the chain meets one edge of the border, before that edge is split.
struct Crossing {
  double u = 0;  ///< parameter on the edge, in its own direction
  std::size_t arc = 0;
  double t = 0;
};

std::vector<Crossing> crossingsOf(const Arc& border, const std::vector<Arc>& chain,
                                  const Tolerance& tolerance) {
  std::vector<Crossing> found;
  for (std::size_t a = 0; a < chain.size(); ++a) {
    for (const Meeting& m : meetings(chain[a], border, tolerance)) found.push_back({m.u, a, m.t});
  }
  std::sort(found.begin(), found.end(), [](const Crossing& x, const Crossing& y) {
    return x.u != y.u ? x.u < y.u : (x.arc != y.arc ? x.arc < y.arc : x.t < y.t);
  });
  return found;
}

/// Makes vertices of the places where the chain meets an edge, splitting the edge from its end
/// backwards so that the parameters of what is left stay simple.
void stopAtEdge(CreasePattern& pattern, EdgeId edge, const std::vector<Arc>& chain,
                std::vector<Stop>& stops) {
  const Arc whole = arcOf(pattern, edge);
  const double tol = pattern.tolerance.length();
  std::vector<Crossing> crossings = crossingsOf(whole, chain, pattern.tolerance);
  const VertexId from = pattern[edge].from;
  VertexId lastVertex = pattern[edge].to;
  Vec2 lastPoint = pattern[lastVertex];
  double scale = 1;  // the edge now ends at parameter `scale` of `whole`
  for (auto c = crossings.rbegin(); c != crossings.rend(); ++c) {
    const Vec2 p = pointAt(whole, c->u);
    if (distance(p, pattern[from]) <= tol) {
      stops.push_back({c->arc, c->t, from});
      continue;
    }
    if (distance(p, lastPoint) > tol) {
      lastVertex = splitEdge(pattern, edge, c->u / scale);
      lastPoint = pattern[lastVertex];
      scale = c->u;
    }
    stops.push_back({c->arc, c->t, lastVertex});
  }
}

/// Joints and free ends of the chain that are not on the border become vertices too.
void stopAtJoints(CreasePattern& pattern, const Region& region, const std::vector<Arc>& chain,
                  std::vector<Stop>& stops) {
  const double tol = pattern.tolerance.length();
  const bool isClosed = distance(chain.front().start, chain.back().end) <= tol;
  for (std::size_t a = 0; a <= chain.size(); ++a) {
    if (a == chain.size() && isClosed) break;
    const Vec2 p = a < chain.size() ? chain[a].start : chain.back().end;
    VertexId vertex;
    for (const Stop& stop : stops) {
      if (distance(pattern[stop.vertex], p) <= tol) vertex = stop.vertex;
    }
    if (!vertex.isValid()) {
      if (locate(region, p, tol) != Where::Inside) continue;
      vertex = addVertex(pattern, p);
    }
    if (a < chain.size()) stops.push_back({a, 0, vertex});
    if (a > 0) stops.push_back({a - 1, 1, vertex});
    if (a == 0 && isClosed) stops.push_back({chain.size() - 1, 1, vertex});
  }
}

bool isLess(const Stop& x, const Stop& y) {
  if (x.arc != y.arc) return x.arc < y.arc;
  if (x.t != y.t) return x.t < y.t;
  return x.vertex < y.vertex;
}

// ---- the frequent case: a straight line through a convex facet with straight sides ----

/// Signed distances of the border's corners from the line; positive on its left. Within tolerance:
/// exactly 0.
std::vector<double> heights(const CreasePattern& pattern, const Facet& facet, Vec2 from,
                            Vec2 direction) {
  std::vector<double> result;
  result.reserve(facet.border.size());
  for (const EdgeUse use : facet.border) {
    const double h = cross(direction, pattern[startOf(pattern, use)] - from);
    result.push_back(std::abs(h) <= pattern.tolerance.length() ? 0 : h);
  }
  return result;
}

bool isSimple(const CreasePattern& pattern, const Facet& facet, const std::vector<double>& h) {
  if (!facet.holeStarts.empty()) return false;
  int meetings = 0;  // corners on the line count, for a line may run along several sides of a facet
  for (std::size_t i = 0; i < h.size(); ++i) {
    if (pattern[facet.border[i].edge].isCurved()) return false;
    if (h[i] == 0 || h[i] * h[(i + 1) % h.size()] < 0) ++meetings;
  }
  return meetings <= 2;
}

/// Parameters along the line, in mm, at which the border of a simple facet meets it; two when the
/// line divides it.
std::vector<double> simpleMeetings(const CreasePattern& pattern, const Facet& facet,
                                   const std::vector<double>& h, Vec2 from, Vec2 direction) {
  const std::size_t n = h.size();
  double low = 0;
  double high = 0;
  for (const double v : h) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  std::vector<double> at;
  if (low == 0 || high == 0) return at;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const Vec2 a = pattern[startOf(pattern, facet.border[i])];
    const Vec2 b = pattern[startOf(pattern, facet.border[j])];
    if (h[i] == 0) {
      at.push_back(dot(a - from, direction));
    } else if (h[i] * h[j] < 0) {
      at.push_back(dot(lerp(a, b, h[i] / (h[i] - h[j])) - from, direction));
    }
  }
  std::sort(at.begin(), at.end());
  return at;
}

/// Meetings of any facet's border with the line, in mm along it.
std::vector<double> generalMeetings(const CreasePattern& pattern, const Facet& facet, Vec2 from,
                                    Vec2 direction) {
  std::vector<double> at;
  const double tol = pattern.tolerance.length();
  for (const EdgeUse use : facet.border) {
    const Arc arc = arcOf(pattern, use);
    for (const double t : lineMeetings(arc, from, direction, pattern.tolerance)) {
      at.push_back(dot(pointAt(arc, t) - from, direction));
    }
    for (const Vec2 end : {arc.start, arc.end}) {
      if (std::abs(cross(direction, end - from)) <= tol) at.push_back(dot(end - from, direction));
    }
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end(), [tol](double a, double b) { return b - a <= tol; }),
           at.end());
  return at;
}

/// The corner that lies beside the chord, nearer than a crease may come to it, if there is one.
std::optional<Vec2> cornerBeside(const CreasePattern& pattern, const Facet& facet, Vec2 from,
                                 Vec2 to) {
  const Vec2 direction = normalized(to - from);
  for (const EdgeUse use : facet.border) {
    const Vec2 p = pattern[startOf(pattern, use)];
    const double side = std::abs(cross(direction, p - from));
    const double along = dot(p - from, direction);
    const bool isBeside =
        along > -pattern.tolerance.thin() && along < distance(from, to) + pattern.tolerance.thin();
    if (isBeside && side > pattern.tolerance.length() && side < pattern.tolerance.thin()) return p;
  }
  return std::nullopt;
}

/// The corner at a simple facet's chord end, splitting the edge where there is none.
VertexId simpleEnd(CreasePattern& pattern, FacetId id, Vec2 p) {
  const double tol = pattern.tolerance.length();
  std::size_t best = 0;
  double bestDistance = pattern.tolerance.sheetSize();
  for (std::size_t i = 0; i < pattern[id].border.size(); ++i) {
    const EdgeUse use = pattern[id].border[i];
    const Vec2 a = pattern[startOf(pattern, use)];
    if (distance(a, p) <= 2 * tol) return startOf(pattern, use);
    const Vec2 b = pattern[endOf(pattern, use)];
    const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    const double away = distance(lerp(a, b, t), p);
    if (away < bestDistance) {
      bestDistance = away;
      best = i;
    }
  }
  const EdgeId edge = pattern[id].border[best].edge;
  const Vec2 a = pattern[pattern[edge].from];
  const Vec2 b = pattern[pattern[edge].to];
  return splitEdge(pattern, edge, dot(p - a, b - a) / dot(b - a, b - a));
}

}  // namespace

std::vector<NewEdge> inscribe(CreasePattern& pattern, FacetId facet, const std::vector<Arc>& chain,
                              EdgeKind kind) {
  const Region region = regionOf(pattern, facet);
  const double tol = pattern.tolerance.length();
  std::vector<Stop> stops;
  std::vector<EdgeId> edges;
  for (const EdgeUse use : pattern[facet].border) edges.push_back(use.edge);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const EdgeId edge : edges) stopAtEdge(pattern, edge, chain, stops);
  stopAtJoints(pattern, region, chain, stops);
  std::sort(stops.begin(), stops.end(), isLess);
  std::vector<NewEdge> result;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const Stop& a = stops[i];
    const Stop& b = stops[i + 1];
    if (a.arc != b.arc || b.t - a.t < kParallel) continue;
    const Arc& arc = chain[a.arc];
    if (locate(region, pointAt(arc, (a.t + b.t) / 2), tol) != Where::Inside) continue;
    NewEdge edge{a.vertex, b.vertex, kind, std::nullopt};
    if (arc.isCurved) {
      const Arc piece = part(arc, a.t, b.t);
      edge.curve = CurveControls{piece.control1, piece.control2};
    } else if (a.vertex == b.vertex) {
      continue;
    }
    result.push_back(edge);
  }
  return result;
}

std::vector<Chord> chordsOf(const CreasePattern& pattern, FacetId id, Vec2 from, Vec2 to) {
  const double span = distance(from, to);
  const Vec2 direction = (to - from) / span;
  const Facet& facet = pattern[id];
  const double tol = pattern.tolerance.length();
  const std::vector<double> h = heights(pattern, facet, from, direction);
  const bool simple = isSimple(pattern, facet, h);
  const std::vector<double> at = simple ? simpleMeetings(pattern, facet, h, from, direction)
                                        : generalMeetings(pattern, facet, from, direction);
  if (at.size() < 2) return {};
  if (simple) {
    if (std::min(at.back(), span) - std::max(at.front(), 0.0) <= tol) return {};
    return {{at.front() / span, at.back() / span}};
  }
  std::vector<Chord> chords;
  const Region region = regionOf(pattern, id);
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    if (std::min(at[i + 1], span) - std::max(at[i], 0.0) <= tol) continue;
    const Vec2 middle = from + direction * ((at[i] + at[i + 1]) / 2);
    if (locate(region, middle, tol) == Where::Inside)
      chords.push_back({at[i] / span, at[i + 1] / span});
  }
  return chords;
}

Result<std::vector<NewEdge>> inscribeChords(CreasePattern& pattern, FacetId id, Vec2 from, Vec2 to,
                                            EdgeKind kind) {
  std::vector<NewEdge> result;
  const std::vector<Chord> chords = chordsOf(pattern, id, from, to);
  const Vec2 direction = normalized(to - from);
  const bool simple =
      isSimple(pattern, pattern[id], heights(pattern, pattern[id], from, direction));
  for (const Chord& chord : chords) {
    const Vec2 a = lerp(from, to, chord.t0);
    const Vec2 b = lerp(from, to, chord.t1);
    if (const std::optional<Vec2> corner = cornerBeside(pattern, pattern[id], a, b)) {
      return Error{ErrorCode::TooThin,
                   "the line passes so close beside the corner at " + text(*corner) +
                       " mm that only a sliver of paper would be left; draw it through the corner "
                       "or farther away",
                   {{*corner}, {{a, b}}, {}}};
    }
    if (simple) {
      const VertexId start = simpleEnd(pattern, id, a);
      const VertexId end = simpleEnd(pattern, id, b);
      if (start != end) result.push_back({start, end, kind, std::nullopt});
      continue;
    }
    for (NewEdge& edge : inscribe(pattern, id, {Arc::line(a, b)}, kind)) result.push_back(edge);
  }
  return result;
}

}  // namespace kiri
