// SPDX-License-Identifier: MIT
#include "core/paper/boxes.h"

#include <gtest/gtest.h>

#include "tests/support/model_text.h"

namespace kiri {
namespace {

TEST(ModelBox, OfAFoldedDiscHoldsItsCurvedRim) {
  // Folded along a chord: the moved cap reaches 30 mm beyond the chord, the rim 50 mm around.
  const ModelBox box = modelBoxOf(test::run("disc 100\nfold a valley 80,0 80,100 right"));
  EXPECT_NEAR(box.low.x, 0, 1e-6);
  EXPECT_NEAR(box.high.x, 80, 1e-6);
  EXPECT_NEAR(box.low.y, 0, 1e-6);
  EXPECT_NEAR(box.high.y, 100, 1e-6);
  EXPECT_NEAR(box.low.z, 0, 1e-9);
  EXPECT_NEAR(box.high.z, 0, 1e-9);
}

TEST(ModelBox, ReachesUpWhereAFlapStands) {
  const ModelBox box = modelBoxOf(test::run("square 100\nfold a valley 90 70,0 70,100 right"));
  EXPECT_NEAR(box.high.x, 70, 1e-9);
  EXPECT_NEAR(box.high.z, 30, 1e-9);
}

TEST(PaperBox, IsThatOfThePaperThatIsLeft) {
  const Box box =
      paperBoxOf(test::run("square 100\ncut @model m:40,-5 m:40,105 keep m:20,50").pattern);
  EXPECT_NEAR(box.high.x, 40, 1e-9);
  EXPECT_NEAR(box.high.y, 100, 1e-9);
}

TEST(TurnOver, OfACurvedPieceStaysInItsBox) {
  const char* const piece = "disc 100\ncut @model m:30,-5 m:30,105 keep m:60,50";
  const ModelBox before = modelBoxOf(test::run(piece));
  const ModelBox after = modelBoxOf(test::run(std::string(piece) + "\nturn vertical"));
  EXPECT_NEAR(after.low.x, before.low.x, 1e-9);
  EXPECT_NEAR(after.high.x, before.high.x, 1e-9);
}

}  // namespace
}  // namespace kiri
