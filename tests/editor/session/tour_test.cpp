// The tour: what it waits for, and what it makes of hands that do other things.
// SPDX-License-Identifier: MIT
#include "editor/session/tour.h"

#include <gtest/gtest.h>

#include "tests/support/model_text.h"

namespace kiri {
namespace {

const char* const kHalf = "fold valley m:0,0 m:150,150 moving m:120,20";
const char* const kAgain = "fold valley m:0,0 m:62.132034,150 moving m:10,140";
const char* const kCut =
    "curve m:116,88 m:104,110 m:66,112 m:50,92 m:38,82 m:12,74 @model through keep m:20,25";

/// A document with these steps done.
Document documentOf(const std::vector<std::string>& steps) {
  std::string text = "square 150";
  for (const std::string& step : steps) text += "; " + step;
  return Document::create(test::modelOf(text)).value();
}

/// What the tour says of a document with these steps.
Tour tourAt(const std::vector<std::string>& steps) {
  Tour tour;
  tour.look(documentOf(steps), frontView());
  return tour;
}

void expectNoProblems(const Document& document) {
  for (std::size_t i = 0; i < document.model().steps.size(); ++i)
    EXPECT_FALSE(document.problemOf(i)) << document.problemOf(i)->message;
}

TEST(Tour, GoesOnWithEachMovementThatItWaitsFor) {
  const std::vector<std::string> all = {kHalf, kAgain, kCut, "unfold all"};
  expectNoProblems(documentOf(all));
  Tour tour;
  for (std::size_t done = 0; done <= all.size(); ++done) {
    const std::vector<std::string> steps(all.begin(), all.begin() + static_cast<int>(done));
    tour.look(documentOf(steps), frontView());
    EXPECT_EQ(tour.step(), done);
    EXPECT_FALSE(tour.isAstray());
    EXPECT_FALSE(tour.isFinished());
    EXPECT_FALSE(tour.title().isEmpty());
    EXPECT_FALSE(tour.text().isEmpty());
  }
  EXPECT_FALSE(tour.look(documentOf(all), frontView())) << "nothing new";
  EXPECT_TRUE(tour.look(documentOf(all), viewFrom(30, 50)));
  EXPECT_TRUE(tour.isFinished());
  tour.look(documentOf(all), frontView());
  EXPECT_TRUE(tour.isFinished()) << "looking back does not undo it";
}

TEST(Tour, AnUndoTakesItBack) {
  Tour tour;
  Document document = documentOf({kHalf, kAgain});
  tour.look(document, frontView());
  EXPECT_EQ(tour.step(), 2U);
  ASSERT_TRUE(document.undo() || document.jumpTo(1));
  EXPECT_TRUE(tour.look(document, frontView()));
  EXPECT_EQ(tour.step(), 1U);
}

TEST(Tour, AHandThatIsAFewMillimetresOffIsGoodEnough) {
  const Tour tour = tourAt({"fold valley m:2,0 m:148,150 moving m:120,20"});
  EXPECT_EQ(tour.step(), 1U);
  EXPECT_FALSE(tour.isAstray());
}

TEST(Tour, AnotherFoldIsToldAndDrawsNoGhost) {
  const Tour sideways = tourAt({"fold valley m:75,0 m:75,150 moving m:120,20"});
  EXPECT_EQ(sideways.step(), 0U);
  EXPECT_TRUE(sideways.isAstray());
  EXPECT_TRUE(sideways.ghost(0.5).empty());
  const Tour oneLayer = tourAt({kHalf, std::string(kAgain) + " top 1"});
  EXPECT_EQ(oneLayer.step(), 1U);
  EXPECT_TRUE(oneLayer.isAstray());
  const Tour half = tourAt({"fold valley 90 m:0,0 m:150,150 moving m:120,20"});
  EXPECT_TRUE(half.isAstray()) << "a fold that is half open is not there yet";
}

TEST(Tour, TheGhostEndsWhereTheHandShall) {
  const Tour tour = tourAt({});
  const auto handAt = [&](double part) {
    for (const Mark& mark : tour.ghost(part)) {
      if (const auto* point = std::get_if<PointMark>(&mark)) return std::get<Vec3>(point->at);
    }
    ADD_FAILURE() << "no hand";
    return Vec3{};
  };
  EXPECT_LT(distance(handAt(0), Vec3{150, 0, 0}), 1e-9);
  EXPECT_LT(distance(handAt(1), Vec3{0, 150, 0}), 1e-9);
  EXPECT_LT(distance(handAt(7), Vec3{0, 150, 0}), 1e-9) << "beyond its end it rests";
}

TEST(Tour, OpeningFoldByFoldIsAsGood) {
  const Tour under = tourAt({kHalf, kAgain, kCut, "angle 20,20 90"});
  EXPECT_EQ(under.step(), 3U);
  EXPECT_FALSE(under.isAstray());
}

TEST(Tour, TheLeafIsLobedAndInOnePiece) {
  const Document document = documentOf({kHalf, kAgain, kCut, "unfold all"});
  const FoldedState& leaf = *document.state();
  EXPECT_EQ(leaf.rests.size(), 1U);
  const double share = areaOf(leaf.pattern) / (150.0 * 150);
  EXPECT_GT(share, 0.2);
  EXPECT_LT(share, 0.9);
}

}  // namespace
}  // namespace kiri
