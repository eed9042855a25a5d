// The SVG files that models are exported as are patterns again.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "io/patterns/svg_reader.h"
#include "io/svg_pattern_writer.h"
#include "tests/support/pattern_text.h"

namespace kiri {
namespace {

TEST(SvgOfStates, IsReadBackWithItsLinesAssignmentsAndAngles) {
  test::Corrugation sheet = test::corrugationOf(4, 3, 60);
  FoldedState state = sheet.state;
  // Mountains, valleys, flat creases; full folds and parts.
  const double angles[] = {180, -180, 90, -45, 0, 120.5};
  std::size_t next = 0;
  for (Edge& edge : state.pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) edge.angle = angles[next++ % 6];
  }
  const Result<PatternFile> file = readSvgPattern(writeSvgPattern(state), "a.svg");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->mmPerUnit, 1);
  EXPECT_TRUE(file->notes.empty()) << file->notes.front();
  ASSERT_EQ(file->drawing.lines.size(), state.pattern.edges.size());
  // The page starts at the corner of the sheet, y downwards from its upper edge.
  double left = state.pattern.vertices[0].x;
  double top = state.pattern.vertices[0].y;
  for (const Vec2 v : state.pattern.vertices) {
    left = std::min(left, v.x);
    top = std::max(top, v.y);
  }
  for (const Edge& edge : state.pattern.edges) {
    const Vec2 from = state.pattern[edge.from] - Vec2{left, top};
    const Vec2 to = state.pattern[edge.to] - Vec2{left, top};
    const Assignment wanted = edge.kind == EdgeKind::Border ? Assignment::Border
                              : edge.angle > 0              ? Assignment::Valley
                              : edge.angle < 0              ? Assignment::Mountain
                                                            : Assignment::Flat;
    std::size_t found = 0;
    for (const DrawnCrease& line : file->drawing.lines) {
      const double miss = std::min(distance(line.from, from) + distance(line.to, to),
                                   distance(line.from, to) + distance(line.to, from));
      if (miss > 1e-5 || line.assignment != wanted) continue;
      EXPECT_EQ(line.angle.value_or(0), edge.kind == EdgeKind::Border ? 0 : edge.angle);
      ++found;
    }
    EXPECT_EQ(found, 1U);
  }
}

}  // namespace
}  // namespace kiri
