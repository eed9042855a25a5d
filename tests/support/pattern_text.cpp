// Faces are traced by turning as far left as an edge allows, at each vertex.
// SPDX-License-Identifier: MIT
#include "tests/support/pattern_text.h"
#include "core/geometry/bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace kiri::test {
namespace {

bool holds(const std::vector<Vec2>& corners, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i];
    const Vec2 b = corners[(i + 1) % corners.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
      inside = !inside;
  }
  return inside;
}

double cornersArea(const std::vector<Vec2>& corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    twice += cross(corners[i], corners[(i + 1) % corners.size()]);
  return twice / 2;
}

/// Half-edge 2e runs from `from` to `to`, 2e + 1 back.
class Drawing {
 public:
  Drawing(const std::vector<Vec2>& vertices, const std::vector<DrawnEdge>& edges)
      : vertices_(vertices), edges_(edges), around_(vertices.size()) {
    for (std::size_t h = 0; h < 2 * edges.size(); ++h) around_[start(h)].push_back(h);
    for (std::vector<std::size_t>& out : around_) {
      std::sort(out.begin(), out.end(),
                [&](std::size_t a, std::size_t b) { return direction(a) < direction(b); });
    }
  }

  std::size_t start(std::size_t h) const {
    return h % 2 == 0 ? edges_[h / 2].from : edges_[h / 2].to;
  }

  /// The half-edge that follows around the face on the left: the next one clockwise of the way
  /// back.
  std::size_t next(std::size_t h) const {
    const std::size_t back = h ^ 1U;
    const std::vector<std::size_t>& out = around_[start(back)];
    const auto at = std::find(out.begin(), out.end(), back);
    return at == out.begin() ? out.back() : *(at - 1);
  }

 private:
  double direction(std::size_t h) const {
    const Vec2 d = vertices_[start(h ^ 1U)] - vertices_[start(h)];
    return std::atan2(d.y, d.x);
  }

  const std::vector<Vec2>& vertices_;
  const std::vector<DrawnEdge>& edges_;
  std::vector<std::vector<std::size_t>> around_;  ///< half-edges that leave a vertex, by direction
};

double sizeOf(const std::vector<Vec2>& vertices) {
  const Box box = boundsOf(vertices);
  return distance(box.low, box.high);
}

/// One layer-set for each facet: enough for what does not ask how they lie.
void spreadOut(FoldedState& state) {
  state.poses = derivePoses(state.pattern, state.rests);
  std::vector<LayerSet> sets;
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f)
    sets.push_back({state.poses[f].normal(), {FacetId(f)}, {}});
  state.layers = LayerOrder(std::move(sets));
}

}  // namespace

FoldedState drawnState(const std::vector<Vec2>& vertices, const std::vector<DrawnEdge>& edges,
                       const std::vector<Vec2>& holes) {
  CreasePattern pattern{Tolerance(sizeOf(vertices))};
  pattern.vertices = vertices;
  for (const DrawnEdge& e : edges) {
    Edge edge;
    edge.from = VertexId(e.from);
    edge.to = VertexId(e.to);
    pattern.edges.push_back(edge);
  }
  const Drawing drawing(vertices, edges);
  std::vector<bool> isSeen(2 * edges.size(), false);
  for (std::size_t first = 0; first < isSeen.size(); ++first) {
    if (isSeen[first]) continue;
    Facet facet;
    std::vector<Vec2> corners;
    for (std::size_t h = first; !isSeen[h]; h = drawing.next(h)) {
      isSeen[h] = true;
      facet.border.push_back({EdgeId(h / 2), h % 2 == 1});
      corners.push_back(vertices[drawing.start(h)]);
    }
    const bool isHole =
        std::any_of(holes.begin(), holes.end(), [&](Vec2 p) { return holds(corners, p); });
    if (cornersArea(corners) <= 0 || isHole) continue;
    const FacetId id(pattern.facets.size());
    for (const EdgeUse use : facet.border)
      (use.isReversed ? pattern[use.edge].right : pattern[use.edge].left) = id;
    pattern.facets.push_back(std::move(facet));
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    Edge& edge = pattern.edges[e];
    if (!edge.left.isValid() || !edge.right.isValid()) continue;
    edge.kind = edges[e].kind;
    if (edge.kind == EdgeKind::Hinge) edge.angle = edges[e].angle;
  }
  if (pattern.facets.empty()) throw std::invalid_argument("the drawing encloses no paper");
  FoldedState state(std::move(pattern));
  const std::vector<std::uint32_t> piece = piecesOf(state.pattern);
  std::uint32_t count = 0;
  for (std::size_t f = 0; f < piece.size(); ++f) {
    if (piece[f] != count) continue;
    state.rests.push_back({FacetId(f), Rigid{}});
    ++count;
  }
  spreadOut(state);
  return state;
}

FoldedState starOf(const std::vector<double>& sectors, double radius) {
  double sum = 0;
  for (const double s : sectors) sum += s;
  const bool isClosed = std::abs(sum - 2 * std::numbers::pi) < 1e-9;
  const std::size_t creases = sectors.size() + (isClosed ? 0 : 1);
  std::vector<Vec2> vertices{{0, 0}};
  std::vector<DrawnEdge> edges;
  double angle = 0;
  for (std::size_t i = 0; i < creases; ++i) {
    vertices.push_back(Vec2{std::cos(angle), std::sin(angle)} * radius);
    edges.push_back({0, i + 1});
    if (i < sectors.size()) angle += sectors[i];
  }
  for (std::size_t i = 0; i < sectors.size(); ++i) edges.push_back({i + 1, (i + 1) % creases + 1});
  return drawnState(vertices, edges);
}

Corrugation corrugationOf(int columns, int rows, double degrees, double width, double height) {
  const double lean = height / std::tan(degrees * std::numbers::pi / 180);
  const auto at = [&](int i, int j) { return static_cast<std::size_t>(j * (columns + 1) + i); };
  std::vector<Vec2> vertices;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i)
      vertices.push_back({i * width + (j % 2 == 1 ? lean : 0), j * height});
  }
  std::vector<DrawnEdge> edges;
  std::vector<std::size_t> straight;
  std::vector<std::size_t> zigzag;
  std::vector<double> folded;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const bool isHinge = j > 0 && j < rows;
      if (isHinge) straight.push_back(edges.size());
      edges.push_back({at(i, j), at(i + 1, j)});
      folded.push_back(isHinge ? ((i + j) % 2 == 0 ? -180 : 180) : 0);
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const bool isHinge = i > 0 && i < columns;
      if (isHinge) zigzag.push_back(edges.size());
      edges.push_back({at(i, j), at(i, j + 1)});
      folded.push_back(isHinge ? (i % 2 == 0 ? 180 : -180) : 0);
    }
  }
  return {drawnState(vertices, edges), columns, rows, straight, zigzag, folded};
}

}  // namespace kiri::test
