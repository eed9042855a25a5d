// The mesh is what is seen of every plane: areas, windings, no cracks.
// SPDX-License-Identifier: MIT
#include "render/mesh/paper_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/mesh/moved_mesh.h"
#include "render/visibility/plane_regions.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri::test {
namespace {

FoldedState randomState(Random& random) {
  FoldedState state = startOf(randomSheet(random));
  for (int i = 0; i < 10; ++i) {
    const Step step = randomStep(random, state, {});
    if (Result<FoldedState> next = tryAfter(state, textOf(step))) state = std::move(*next);
  }
  for (int i = 0; i < 3 && !state.lines.empty(); ++i) {
    const std::string& name = state.lines[random.below(state.lines.size())].name;
    const std::string angle = std::to_string(random.between(-175, 175));
    if (Result<FoldedState> next = tryAfter(state, "angle " + name + " " + angle))
      state = std::move(*next);
  }
  return state;
}

Vec3 vec(const std::array<float, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

struct Triangle {
  std::array<const MeshVertex*, 3> corners;
  Vec3 doubleArea() const {
    const Vec3 a = vec(corners[0]->position);
    return cross(vec(corners[1]->position) - a, vec(corners[2]->position) - a);
  }
};

std::vector<Triangle> trianglesOf(const PaperMesh& mesh) {
  std::vector<Triangle> out;
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    out.push_back({{&mesh.vertices[mesh.triangles[i]], &mesh.vertices[mesh.triangles[i + 1]],
                    &mesh.vertices[mesh.triangles[i + 2]]}});
  }
  return out;
}

void expectNumbersValid(const PaperMesh& mesh, const FoldedState& state) {
  EXPECT_EQ(mesh.facetCount, state.pattern.facets.size());
  EXPECT_EQ(mesh.triangles.size() % 3, 0U);
  for (const std::uint32_t i : mesh.triangles) ASSERT_LT(i, mesh.vertices.size());
  for (const MeshVertex& v : mesh.vertices) ASSERT_LT(v.facet, mesh.facetCount);
  for (const MeshSegment& s : mesh.segments) ASSERT_LT(s.facet, mesh.facetCount);
}

/// Each corner is where the pose of its facet takes its paper, and its normal is that of the side.
void expectOnPaper(const PaperMesh& mesh, const FoldedState& state) {
  const double small = 1e-6 * state.tolerance().sheetSize();
  for (const MeshVertex& v : mesh.vertices) {
    const Rigid& pose = state.poses[v.facet];
    const Vec3 expected =
        pose.apply(Vec2{static_cast<double>(v.paper[0]), static_cast<double>(v.paper[1])});
    ASSERT_LT(distance(mesh.origin + vec(v.position), expected), small);
    const Vec3 normal = v.isFront == 1 ? pose.normal() : -pose.normal();
    ASSERT_LT(distance(vec(v.normal), normal), 1e-6);
    ASSERT_NEAR(static_cast<double>(v.height), dot(vec(v.position), vec(v.normal)), small);
  }
}

double longestSideOf(const Triangle& t) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 d = vec(t.corners[i]->position) - vec(t.corners[(i + 1) % 3]->position);
    longest = std::max(longest, length(d));
  }
  return longest;
}

void expectWindings(const PaperMesh& mesh) {
  for (const Triangle& t : trianglesOf(mesh)) {
    const Vec3 area = t.doubleArea();
    const double side = dot(area, vec(t.corners[0]->normal));
    // Corners are rounded to floats: a needle may be turned over by as much.
    EXPECT_GE(side, -2e-5 * (1 + longestSideOf(t)));
    for (const MeshVertex* v : t.corners) {
      EXPECT_EQ(v->facet, t.corners[0]->facet);
      EXPECT_EQ(v->isFront, t.corners[0]->isFront);
    }
  }
}

using FacetSide = std::pair<std::uint32_t, bool>;

std::map<FacetSide, double> areasOf(const PaperMesh& mesh) {
  std::map<FacetSide, double> out;
  for (const Triangle& t : trianglesOf(mesh)) {
    const MeshVertex& v = *t.corners[0];
    out[{v.facet, v.isFront == 1}] += dot(t.doubleArea(), vec(v.normal)) / 2;
  }
  return out;
}

double perimeterOf(const VisibleFacet& facet) {
  double sum = 0;
  for (const auto& loop : facet.loops) {
    for (const BoundaryPiece& piece : loop) sum += lengthOf(piece.arc, 0.01);
  }
  return sum;
}

/// What is seen of each side of each facet has the area of its triangles, but for flattened curves.
void expectAreas(const PaperMesh& mesh, const FoldedState& state) {
  std::map<FacetSide, double> got = areasOf(mesh);
  for (const PlaneRegions& plane : planeRegions(state)) {
    for (const VisibleRegions* regions : {&plane.fromAbove, &plane.fromBelow}) {
      for (const VisibleFacet& facet : regions->facets) {
        const double small = 5e-5 * state.tolerance().sheetSize() * (1 + perimeterOf(facet));
        const FacetSide key{facet.facet.index, facet.showsFront};
        EXPECT_NEAR(got[key], areaOf(facet), small) << "facet " << key.first;
        got.erase(key);
      }
    }
  }
  for (const auto& [key, area] : got) EXPECT_NEAR(area, 0, 1e-3) << "facet " << key.first;
}

using Place = std::array<float, 3>;
using Side = std::pair<Place, Place>;

/// Every side of a triangle runs once more backwards in the same plane, or is part of the outline
/// of what is seen of the plane.
void expectNoCracks(const PaperMesh& mesh) {
  std::map<std::pair<Place, Side>, int> sides;  // by normal: planes are told apart by it
  for (const Triangle& t : trianglesOf(mesh)) {
    for (std::size_t i = 0; i < 3; ++i) {
      const MeshVertex& a = *t.corners[i];
      const MeshVertex& b = *t.corners[(i + 1) % 3];
      if (a.position == b.position) continue;
      ++sides[{a.normal, {a.position, b.position}}];
    }
  }
  // A side that nobody shares is drawn as a line, whole: there paper ends.
  std::map<Side, bool> outline;
  for (const MeshSegment& s : mesh.segments) {
    outline[{s.from, s.to}] = outline[{s.to, s.from}] = true;
  }
  int cracks = 0;
  for (const auto& [key, count] : sides) {
    const auto back = sides.find({key.first, {key.second.second, key.second.first}});
    const int returning = back == sides.end() ? 0 : back->second;
    if (returning >= count) continue;
    cracks += outline.contains(key.second) ? 0 : 1;
  }
  EXPECT_EQ(cracks, 0);
}

TEST(PaperMesh, OfRandomStatesIsWhatIsSeenOfEachPlane) {
  int curved = 0;
  int inSpace = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed * 6151);
    const FoldedState state = randomState(random);
    const PaperMesh mesh = meshOf(state);
    expectNumbersValid(mesh, state);
    expectOnPaper(mesh, state);
    expectWindings(mesh);
    expectAreas(mesh, state);
    expectNoCracks(mesh);
    if (HasFailure()) return;
    curved += state.pattern.curves.empty() ? 0 : 1;
    inSpace += state.layers.sets().size() > 2 ? 1 : 0;
  }
  EXPECT_GT(curved, 20);
  EXPECT_GT(inSpace, 40);
}

TEST(SheetMesh, OfRandomStatesIsTheWholeSheetFromBothSides) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed * 104729);
    const FoldedState state = randomState(random);
    const PaperMesh mesh = sheetMeshOf(state);
    expectNumbersValid(mesh, state);
    expectWindings(mesh);
    expectNoCracks(mesh);
    const std::map<FacetSide, double> areas = areasOf(mesh);
    for (std::uint32_t f = 0; f < mesh.facetCount; ++f) {
      const Region region = regionOf(state.pattern, FacetId(f));
      const double small =
          5e-5 * state.tolerance().sheetSize() * (1 + kiri::perimeterOf(region, 0.01));
      for (const bool isFront : {true, false}) {
        EXPECT_NEAR(areas.at({f, isFront}), kiri::areaOf(region), small);
      }
    }
    for (const MeshVertex& v : mesh.vertices) {
      EXPECT_EQ(v.position[2], 0);
      EXPECT_NEAR(mesh.origin.x + static_cast<double>(v.position[0]), v.paper[0], 1e-4);
      EXPECT_NEAR(mesh.origin.y + static_cast<double>(v.position[1]), v.paper[1], 1e-4);
      EXPECT_EQ(v.normal[2], v.isFront == 1 ? 1 : -1);
    }
    if (HasFailure()) return;
  }
}

TEST(PaperMesh, StopsWhenNobodyWantsItAnyMore) {
  const FoldedState state = run("square 100; fold a valley 90 0,50 100,50 right");
  int asked = 0;
  const PaperMesh mesh = meshOf(state, [&](double) { return ++asked < 2; });
  EXPECT_TRUE(mesh.vertices.empty());
  EXPECT_EQ(asked, 2);
}

double strengthOf(const PaperMesh& mesh) {
  double sum = 0;
  for (const MeshShade& s : mesh.shades) {
    const double own = distance(vec(s.from), vec(s.to));
    sum += own * static_cast<double>(s.strength);
  }
  return sum;
}

/// The same lines: of each kind as many, as long, and turned the same way.
void expectSameLines(const PaperMesh& got, const PaperMesh& expected) {
  const auto sums = [](const PaperMesh& mesh) {
    std::map<std::pair<MeshLine, bool>, std::array<double, 4>> out;
    for (const MeshSegment& s : mesh.segments) {
      const Vec3 middle = mesh.origin + (vec(s.from) + vec(s.to)) / 2;
      std::array<double, 4>& sum = out[{s.kind, s.isCovered}];
      sum[0] += 1;
      sum[1] += distance(vec(s.from), vec(s.to));
      sum[2] += dot(vec(s.normal) + vec(s.otherNormal), middle);
      sum[3] += dot(vec(s.normal), vec(s.otherNormal));
    }
    return out;
  };
  const auto a = sums(got);
  const auto b = sums(expected);
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [kind, sum] : a) {
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(sum[i], b.at(kind)[i], 0.05) << i;
  }
}

TEST(MovedMesh, IsTheMeshOfTheMovedState) {
  int moved = 0;
  int refused = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed * 2221);
    const FoldedState before = randomState(random);
    if (before.lines.empty()) continue;
    const std::string& name = before.lines[random.below(before.lines.size())].name;
    const std::string angle = std::to_string(random.between(-175, 175));
    const Result<FoldedState> after = tryAfter(before, "angle " + name + " " + angle);
    if (!after) continue;
    const std::optional<PaperMesh> got = movedMesh(meshOf(before), before, *after);
    if (got) {
      const PaperMesh expected = meshOf(*after);
      expectNumbersValid(*got, *after);
      expectOnPaper(*got, *after);
      expectWindings(*got);
      expectAreas(*got, *after);
      expectSameLines(*got, expected);
      EXPECT_NEAR(strengthOf(*got), strengthOf(expected), 0.01);
    } else {
      EXPECT_NE(before.layers.sets().size(), 0U);
      ++refused;
    }
    moved += got ? 1 : 0;
    if (HasFailure()) return;
  }
  EXPECT_GT(moved, 12);
  EXPECT_GT(refused, 0);
}

TEST(MovedMesh, FollowsASliderButNotIntoAnotherPlane) {
  const std::string folded =
      "square 100; fold a valley 90 0,50 100,50 right; fold b valley 40 0,80 100,80 left";
  const FoldedState base = run(folded);
  const PaperMesh mesh = meshOf(base);
  for (const char* angle : {"10", "89.5", "170", "-60"}) {
    EXPECT_TRUE(movedMesh(mesh, base, after(base, std::string("angle a ") + angle))) << angle;
  }
  EXPECT_FALSE(movedMesh(mesh, base, after(base, "angle a 180")));
  EXPECT_FALSE(movedMesh(mesh, base, after(base, "angle a 0")));
  EXPECT_FALSE(movedMesh(mesh, base, after(base, "fold c valley 30 0,80 20,100 right")));
}

std::map<MeshLine, int> linesOf(const PaperMesh& mesh) {
  std::map<MeshLine, int> out;
  for (const MeshSegment& s : mesh.segments) ++out[s.kind];
  return out;
}

TEST(PaperMesh, DrawsAHingeOfTwoPlanesOnceForEachSideOfThePaper) {
  const PaperMesh mesh = meshOf(run("square 100; fold a valley 90 0,50 100,50 right"));
  std::vector<MeshSegment> hinges;
  for (const MeshSegment& s : mesh.segments) {
    if (s.kind == MeshLine::Edge) hinges.push_back(s);
  }
  ASSERT_EQ(hinges.size(), 2U);
  for (const MeshSegment& s : hinges) {
    EXPECT_NEAR(length(vec(s.otherNormal)), 1, 1e-6);
    EXPECT_NEAR(dot(vec(s.normal), vec(s.otherNormal)), 0, 1e-6);
  }
  EXPECT_EQ(linesOf(mesh)[MeshLine::Border], 12);
}

bool hasSlits(const CreasePattern& pattern) {
  return std::any_of(pattern.edges.begin(), pattern.edges.end(), [](const Edge& e) {
    return e.left.isValid() && e.left == e.right && e.kind != EdgeKind::Hinge;
  });
}

TEST(PaperMesh, PaperLiesOnTheLeftOfItsLines) {
  int checked = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed * 31337);
    const FoldedState state = randomState(random);
    if (hasSlits(state.pattern)) continue;  // those have no end of paper beside them
    ++checked;
    const PaperMesh mesh = meshOf(state);
    std::map<std::pair<Place, Side>, bool> sides;
    for (const Triangle& t : trianglesOf(mesh)) {
      for (std::size_t i = 0; i < 3; ++i) {
        const MeshVertex& a = *t.corners[i];
        sides[{a.normal, {a.position, t.corners[(i + 1) % 3]->position}}] = true;
      }
    }
    for (const MeshSegment& s : mesh.segments) {
      EXPECT_TRUE(sides.contains({s.normal, {s.from, s.to}}));
      if (length(vec(s.otherNormal)) > 0 && !s.isCovered) {
        EXPECT_TRUE(sides.contains({s.otherNormal, {s.to, s.from}}));
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(checked, 15);
}

TEST(PaperMesh, DrawsATearThatEndsInsideAFacet) {
  const PaperMesh mesh = meshOf(run("square 100; cut 50,-10 50,40"));
  int inside = 0;
  for (const MeshSegment& s : mesh.segments) {
    inside += mesh.origin.x + static_cast<double>(s.from[0]) == 50 &&
                      mesh.origin.x + static_cast<double>(s.to[0]) == 50
                  ? 1
                  : 0;
  }
  EXPECT_EQ(inside, 2);  // one on each side of the paper
}

TEST(PaperMesh, KnowsWhichLinesLieUnderALayerOfTheirOwnPlane) {
  // The upper half lies on the lower one; of that a corner is bent down, away from what covers it.
  const PaperMesh mesh = meshOf(
      run("square 100; fold a valley 180 0,50 100,50 moving 50,75; fold b mountain 60 30,0 0,30 "
          "moving 5,5 facets 5,5"));
  int covered = 0;
  for (const MeshSegment& s : mesh.segments) {
    if (!s.isCovered) continue;
    ++covered;
    EXPECT_EQ(s.kind, MeshLine::Edge);
    EXPECT_NEAR(std::abs(vec(s.otherNormal).z), 1, 1e-6);
    EXPECT_NEAR(std::abs(vec(s.normal).z), 0.5, 1e-6);
  }
  EXPECT_EQ(covered, 1);
}

TEST(PaperMesh, DarkensValleysAndWhatLiesUnderOtherLayers) {
  const auto shadesOf = [](const char* text) { return meshOf(run(text)).shades.size(); };
  EXPECT_EQ(shadesOf("square 100"), 0U);
  // A valley from the front is a mountain from the back: two shades, one on either side of it.
  EXPECT_EQ(shadesOf("square 100; fold a valley 90 0,50 100,50 right"), 2U);
  // A narrow flap on a wide sheet: its rim and its two short sides.
  EXPECT_EQ(shadesOf("square 100; fold a valley 180 0,30 100,30 right"), 1U);
}

TEST(SheetMesh, ShowsMountainsOfTheFrontAsValleysOfTheBack) {
  const PaperMesh mesh = sheetMeshOf(run("square 100; fold a valley 180 0,50 100,50 right"));
  for (const MeshSegment& s : mesh.segments) {
    if (s.kind == MeshLine::Border) continue;
    EXPECT_EQ(s.kind, s.normal[2] > 0 ? MeshLine::Valley : MeshLine::Mountain);
    EXPECT_FALSE(s.isThin);
  }
  EXPECT_EQ(linesOf(mesh)[MeshLine::Valley], 1);
  EXPECT_EQ(linesOf(mesh)[MeshLine::Mountain], 1);
}

}  // namespace
}  // namespace kiri::test
