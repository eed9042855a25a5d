// Cuts straight down through paper that is partly folded.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "core/geometry/rigid.h"
#include "core/paper/contours.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

/// Points of the margin that the cut left, paper frame, by their direction from the origin.
double marginRadius(const FoldedState& state, double degrees) {
  const CosSin turn = cosSinDegrees(degrees);
  const Arc ray = Arc::line({0, 0}, Vec2{turn.cos, turn.sin} * 1000);
  double nearest = HUGE_VAL;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    if (state.pattern.edges[e].kind == EdgeKind::Hinge) continue;
    const Arc arc = arcOf(state.pattern, EdgeId(e));
    for (const Meeting& m : meetings(ray, arc, state.tolerance())) {
      const double r = m.t * 1000;
      if (r > 1e-3) nearest = std::min(nearest, r);
    }
  }
  return nearest;
}

/// A half disc about the origin with radial creases at the angles, each folded by its amount.
std::string openFan(const std::vector<double>& degrees, const std::vector<double>& amounts) {
  std::string steps = "polygon -200,0 200,0 200,200 -200,200";
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const CosSin turn = cosSinDegrees(degrees[i]);
    const std::string name = "f" + std::to_string(i);
    // Each crease is made on flat paper, so that it runs radially on the sheet, and opened again.
    steps += "; fold " + name + (i % 2 == 0 ? " valley" : " mountain") +
             " p:0,0 p:" + std::to_string(400 * turn.cos) + "," + std::to_string(400 * turn.sin) +
             " left; unfold " + name;
  }
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    steps += "; angle f" + std::to_string(i) + " " + std::to_string(amounts[i]);
  }
  return steps;
}

TEST(ThroughCut, OfAFlatSheetIsAStraightCut) {
  const FoldedState state = run("square 100; cut @model m:-5,40 m:105,40 through keep m:50,10");
  EXPECT_NEAR(areaOf(state.pattern), 4000, 1e-9);
}

TEST(ThroughCut, OfASlopeIsShortenedByItsCosine) {
  const FoldedState state =
      run("square 100; fold a valley 60 50,-5 50,105 left; unfold a; angle a 60;"
          "cut @model m:40,-5 m:40,105 through keep m:90,50");
  // The moving left half rises by 60 degrees: 10 mm seen from the front are 20 mm of paper.
  EXPECT_NEAR(areaOf(state.pattern), 100 * (50 + 20), 1e-7);
  EXPECT_EQ(violationsOf(state), std::vector<std::string>{});
}

TEST(ThroughCut, GoesThroughTheHingeBetweenSlopes) {
  const FoldedState state =
      run("square 100; fold a valley 60 50,-5 50,105 left; cut @model m:-5,30 m:105,60 through "
          "keep m:90,0");
  EXPECT_EQ(violationsOf(state), std::vector<std::string>{});
  EXPECT_EQ(state.pattern.facets.size(), 2u);
  EXPECT_EQ(piecesOf(state.pattern), (std::vector<std::uint32_t>{0, 0}));
}

TEST(ThroughCut, RefusesPaperThatStandsUpright) {
  const Result<FoldedState> result = tryRun(
      "square 100; fold a valley 90 50,-5 50,105 left; cut @model m:-5,30 m:105,30 through keep "
      "m:90,0");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::BadValue);
  EXPECT_NE(result.error().message.find("upright"), std::string::npos);
}

TEST(ThroughCut, IsForCutsOnTheModelOnly) {
  EXPECT_FALSE(tryRun("square 100; cut p:-5,40 p:105,40 through keep p:50,10"));
  EXPECT_FALSE(tryRun("square 100; fold a valley 50,-5 50,105 left through"));
}

TEST(ThroughCut, CurvesStayExactOnSlopes) {
  const FoldedState state =
      run("square 100; fold a valley 60 50,-5 50,105 left;"
          "curve @model m:20,50 m:40,20 m:70,30 m:75,60 m:50,80 m:30,70 closed through keep p:1,1");
  EXPECT_EQ(violationsOf(state), std::vector<std::string>{});
  // The hole is symmetric to nothing, but its area on the slope is twice what is seen of it.
  double curved = 0;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e)
    curved += state.pattern.edges[e].isCurved() ? 1 : 0;
  EXPECT_GE(curved, 6);
}

/// The cutting law of a partly opened fan: R_k = D / (n . u_k), for a cut in the plane n.x = D.
class OpenFan : public ::testing::TestWithParam<int> {};

TEST_P(OpenFan, IsCutAtTheRadiusThatTheLawSays) {
  Random random(static_cast<std::uint64_t>(GetParam()) * 977);
  std::vector<double> degrees;
  std::vector<double> amounts;
  double at = 0;
  const std::size_t count = 2 + random.below(4);
  for (std::size_t i = 0; i < count; ++i) {
    at += random.between(20, 32);
    degrees.push_back(at);
    amounts.push_back(random.between(5, 70));
  }
  const FoldedState fan = run(openFan(degrees, amounts));
  const double distance = random.between(20, 40);
  const FoldedState cut = after(fan, "cut @model m:-900," + std::to_string(distance) + " m:900," +
                                         std::to_string(distance) + " through");
  EXPECT_EQ(violationsOf(cut), std::vector<std::string>{});
  int checked = 0;
  for (const double angle : degrees) {
    const CosSin turn = cosSinDegrees(angle);
    const std::optional<FacetId> facet = facetAt(fan.pattern, Vec2{turn.cos, turn.sin} * 10);
    ASSERT_TRUE(facet);
    const Vec3 u = fan.poseOf(*facet).direction(Vec2{turn.cos, turn.sin});
    const Vec3 origin = fan.poseOf(*facet).apply(Vec2{0, 0});
    const double law = (std::stod(std::to_string(distance)) - origin.y) / u.y;
    if (u.y <= 0.2 || law > 180) continue;
    EXPECT_NEAR(marginRadius(cut, angle), law, 1e-6) << angle;
    ++checked;
  }
  EXPECT_GT(checked, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, OpenFan, ::testing::Range(1, 41));

}  // namespace
}  // namespace kiri::test
