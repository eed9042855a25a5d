// Drawn by hand from the guide's coordinates. SPDX-License-Identifier: MIT
#include "tests/core/flatfold/flat_patterns.h"

#include "core/creases/repair.h"

namespace kiri::test {

AssignedPattern unassignedPattern(const std::vector<Vec2>& vertices,
                                  const std::vector<DrawnEdge>& edges,
                                  const std::vector<Vec2>& holes) {
  AssignedPattern creases(drawnState(vertices, edges, holes).pattern);
  for (const Edge& edge : creases.pattern.edges) {
    const bool isHinge = edge.kind == EdgeKind::Hinge;
    creases.assignments.push_back(isHinge && edge.angle != 0   ? Assignment::Unassigned
                                  : isHinge                    ? Assignment::Flat
                                  : edge.kind == EdgeKind::Cut ? Assignment::Cut
                                                               : Assignment::Border);
  }
  return creases;
}

AssignedPattern mapPattern(int columns, int rows) {
  std::vector<Vec2> vertices;
  std::vector<DrawnEdge> edges;
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * (columns + 1) + x); };
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) {
      vertices.push_back({static_cast<double>(x), static_cast<double>(y)});
      if (x < columns) edges.push_back({at(x, y), at(x + 1, y), EdgeKind::Hinge, 180});
      if (y < rows) edges.push_back({at(x, y), at(x, y + 1), EdgeKind::Hinge, 180});
    }
  }
  return unassignedPattern(vertices, edges);
}

AssignedPattern plusPattern(double length) {
  const double far = 1 + length;
  const std::vector<Vec2> vertices{{-1, -1},  {1, -1},    {1, 1},     {-1, 1},
                                   {far, -1}, {far, 1},   {1, far},   {-1, far},
                                   {-far, 1}, {-far, -1}, {-1, -far}, {1, -far}};
  std::vector<DrawnEdge> edges;
  for (std::size_t i = 0; i < 4; ++i) edges.push_back({i, (i + 1) % 4, EdgeKind::Hinge, 180});
  for (const std::vector<std::size_t>& rim :
       {std::vector<std::size_t>{1, 4, 5, 2}, {2, 6, 7, 3}, {3, 8, 9, 0}, {0, 10, 11, 1}}) {
    for (std::size_t i = 0; i + 1 < rim.size(); ++i) edges.push_back({rim[i], rim[i + 1]});
  }
  return unassignedPattern(vertices, edges);
}

AssignedPattern squareTwist() {
  const std::vector<Vec2> vertices{{1, 0},  {0, 1},   {-1, 0},  {0, -1}, {3, 0}, {1, -3},
                                   {0, -3}, {-3, -1}, {-3, 0},  {-1, 3}, {0, 3}, {3, 1},
                                   {3, 3},  {-3, 3},  {-3, -3}, {3, -3}};
  std::vector<DrawnEdge> edges;
  for (std::size_t i = 0; i < 4; ++i) edges.push_back({i, (i + 1) % 4, EdgeKind::Hinge, 180});
  for (const auto& [from, to] : std::vector<std::pair<std::size_t, std::size_t>>{
           {0, 4}, {0, 5}, {3, 6}, {3, 7}, {2, 8}, {2, 9}, {1, 10}, {1, 11}})
    edges.push_back({from, to, EdgeKind::Hinge, 180});
  const std::vector<std::size_t> rim{4, 11, 12, 10, 9, 13, 8, 7, 14, 6, 5, 15};
  for (std::size_t i = 0; i < rim.size(); ++i) edges.push_back({rim[i], rim[(i + 1) % rim.size()]});
  return unassignedPattern(vertices, edges);
}

AssignedPattern twistTessellation(int tiles) {
  const double lines[12][4] = {{1, 0, 0, 1},   {0, 1, -1, 0},  {-1, 0, 0, -1}, {0, -1, 1, 0},
                               {1, 0, 3, 0},   {1, 0, 1, -3},  {0, -1, 0, -3}, {0, -1, -3, -1},
                               {-1, 0, -3, 0}, {-1, 0, -1, 3}, {0, 1, 0, 3},   {0, 1, 3, 1}};
  CreaseDrawing drawing;
  for (int i = 0; i < tiles; ++i) {
    for (int j = 0; j < tiles; ++j) {
      const Vec2 middle{6.0 * i + 3, 6.0 * j + 3};
      const Vec2 turn{i % 2 == 0 ? 1.0 : -1.0, j % 2 == 0 ? 1.0 : -1.0};
      for (const double(&l)[4] : lines)
        drawing.lines.push_back({middle + Vec2{turn.x * l[0], turn.y * l[1]},
                                 middle + Vec2{turn.x * l[2], turn.y * l[3]},
                                 Assignment::Unassigned, std::nullopt});
    }
  }
  const double side = 6.0 * tiles;
  const Vec2 corners[4] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  for (std::size_t i = 0; i < 4; ++i)
    drawing.lines.push_back({corners[i], corners[(i + 1) % 4], Assignment::Border, std::nullopt});
  return patternOf(drawing)->creases;
}

AssignedPattern windowPattern() {
  CreaseDrawing drawing;
  const auto addSquare = [&](Vec2 low, Vec2 high) {
    const Vec2 corners[4] = {low, {high.x, low.y}, high, {low.x, high.y}};
    for (std::size_t i = 0; i < 4; ++i)
      drawing.lines.push_back({corners[i], corners[(i + 1) % 4], Assignment::Border, std::nullopt});
  };
  addSquare({0, 0}, {4, 4});
  addSquare({0.5, 1}, {1.5, 2});
  drawing.lines.push_back({{2, 0}, {2, 4}, Assignment::Valley, std::nullopt});
  return patternOf(drawing)->creases;
}

void assign(AssignedPattern& creases, EdgeId edge, Assignment assignment) {
  creases.assignments[edge.index] = assignment;
  creases.pattern[edge].angle = assignment == Assignment::Valley     ? 180
                                : assignment == Assignment::Mountain ? -180
                                : assignment == Assignment::Flat     ? 0
                                                                     : 180;
}

}  // namespace kiri::test
