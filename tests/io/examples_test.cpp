// What the models in examples/ are there to show.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/geometry/rigid.h"
#include "core/model/replay.h"
#include "io/file.h"
#include "io/kiri_reader.h"

namespace kiri {
namespace {

Model modelAt(const std::string& path) {
  const Result<std::string> text = readFile(path);
  EXPECT_TRUE(text.isOk()) << path;
  Result<LoadedModel> loaded = readKiri(*text, path);
  EXPECT_TRUE(loaded.isOk()) << loaded.error().message;
  return loaded->model;
}

Model example(const std::string& name) {
  return modelAt(KIRI_SOURCE_DIR "/examples/" + name + ".kiri");
}

FoldedState finalState(const Model& model) {
  const Result<Replay> steps = replay(model);
  EXPECT_TRUE(steps.isOk());
  return **steps->after(model.steps.size());
}

/// Corners of the paper's border, on the sheet.
std::vector<Vec2> borderCorners(const CreasePattern& pattern) {
  std::vector<Vec2> corners;
  for (const Edge& edge : pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) continue;
    for (const VertexId v : {edge.from, edge.to}) corners.push_back(pattern[v]);
  }
  return corners;
}

/// How far the nearest of some places is from a place.
double nearest(const std::vector<Vec2>& places, Vec2 to) {
  double best = HUGE_VAL;
  for (const Vec2 p : places) best = std::min(best, distance(p, to));
  return best;
}

std::size_t countKind(const CreasePattern& pattern, EdgeKind kind) {
  return static_cast<std::size_t>(
      std::count_if(pattern.edges.begin(), pattern.edges.end(),
                    [kind](const Edge& edge) { return edge.kind == kind; }));
}

TEST(LeafExamples, UnfoldToOnePieceThatIsItsOwnMirrorImage) {
  const struct {
    const char* name;
    double midVein;
  } leaves[] = {{"leaf_three_lobes", 75},
                {"leaf_palmate", 100},
                {"leaf_petiole_inside", 100},
                {"leaf_secondary_lobes", 100}};
  for (const auto& leaf : leaves) {
    const FoldedState state = finalState(example(leaf.name));
    EXPECT_EQ(state.rests.size(), 1u) << leaf.name;
    const std::vector<Vec2> corners = borderCorners(state.pattern);
    EXPECT_GT(corners.size(), 20u) << leaf.name;
    for (const Vec2 p : corners) {
      const Vec2 mirrored{2 * leaf.midVein - p.x, p.y};
      EXPECT_LE(nearest(corners, mirrored), 1e-9 * state.tolerance().sheetSize())
          << leaf.name << " at " << p.x << ", " << p.y;
    }
  }
}

/// Distance from the petiole to the margin along a crease at `degrees` clockwise from the mid-vein.
double veinLength(const FoldedState& state, Vec2 petiole, double degrees) {
  double longest = 0;
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge) continue;
    for (const VertexId v : {edge.from, edge.to}) {
      const Vec2 d = state.pattern[v] - petiole;
      if (length(d) < 1) continue;
      if (std::abs(angleDegrees(d.y, d.x) - degrees) < 1e-3) longest = std::max(longest, length(d));
    }
  }
  return longest;
}

TEST(PalmateLeaf, HasALobeAtEveryVeinAndASinusAtEveryAntiVein) {
  const FoldedState state = finalState(example("leaf_palmate"));
  const Vec2 petiole{100, 0};
  const double veins[] = {0, 25.8, 56.3};
  const double antiVeins[] = {15.1, 44.5, 79.7};
  for (int i = 0; i < 3; ++i) {
    const double vein = veinLength(state, petiole, veins[i]);
    const double sinus = veinLength(state, petiole, antiVeins[i]);
    EXPECT_GT(sinus, 30) << antiVeins[i];
    EXPECT_GT(vein, sinus + 5) << veins[i];
    if (i > 0) {
      EXPECT_GT(vein, veinLength(state, petiole, antiVeins[i - 1]) + 5) << veins[i];
      EXPECT_LT(vein, veinLength(state, petiole, veins[i - 1])) << "side lobes are shorter";
      EXPECT_NEAR(vein, veinLength(state, petiole, -veins[i]), 1e-9);
    }
  }
}

TEST(SecondaryLobes, LeaveNoTearOnceMended) {
  const Model model = example("leaf_secondary_lobes");
  const Result<Replay> steps = replay(model);
  ASSERT_TRUE(steps.isOk());
  EXPECT_GT(countKind((*steps->after(2))->pattern, EdgeKind::Tear), 0u);
  EXPECT_EQ(countKind((*steps->after(model.steps.size()))->pattern, EdgeKind::Tear), 0u);
}

TEST(Ship, IsOneUncutSheetWithATuckedBow) {
  const FoldedState ship = finalState(example("ship"));
  EXPECT_EQ(countKind(ship.pattern, EdgeKind::Tear), 0u);
  EXPECT_EQ(countKind(ship.pattern, EdgeKind::Cut), 0u);
  EXPECT_EQ(ship.rests.size(), 1u);
  EXPECT_NEAR(areaOf(ship.pattern), 100 * 100, 1e-6);
  // An inside reverse fold: at its vertex three creases go one way and one the other (Maekawa).
  int valleys = 0;
  int mountains = 0;
  for (const Edge& edge : ship.pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) ++(edge.angle > 0 ? valleys : mountains);
  }
  EXPECT_EQ(valleys, 3);
  EXPECT_EQ(mountains, 1);
}

TEST(Kirigami, HasTheSymmetryOfItsFolds) {
  const FoldedState snowflake = finalState(example("kirigami_snowflake"));
  const std::vector<Vec2> corners = borderCorners(snowflake.pattern);
  EXPECT_GT(corners.size(), 60u);
  const Rigid sixth = rotationAbout({60, 60, 0}, {0, 0, 1}, 60);
  for (const Vec2 p : corners) {
    const Vec2 turned = flatten(sixth.apply(p));
    // The drawn lines meet the sixths of the disc to 1e-9 mm.
    EXPECT_LE(nearest(corners, turned), 1e-7) << p.x << ", " << p.y;
  }
}

}  // namespace
}  // namespace kiri
