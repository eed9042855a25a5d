// Paper that stands in other paper.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/sweep/pierced.h"
#include "tests/support/crossing_check.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

TEST(Pierced, PaperThatStandsInPaperIsFoundWhereItDoes) {
  // A flap laid down through a post: carried out, for the user may, and then it stands in it.
  const FoldedState state =
      run("rectangle 130 20; fold Post valley 90 80,0 80,20 right; fold Flap valley 1 50,0 50,20 "
          "left; angle Flap 140");
  const std::optional<Pierced> found = firstPierced(state);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->isCertain);
  EXPECT_NEAR(found->place.x, 80, 1e-3);
  EXPECT_FALSE(crossingViolations(state).empty());
}

TEST(Pierced, PaperThatOnlyTouchesIsNotFound) {
  for (const char* text :
       {"square 100; fold A valley 90 50,0 50,100 left; fold B valley 60 @model 80,-5 80,105 right",
        "polygon 20,0 80,0 80,20 100,20 100,80 80,80 80,100 20,100 20,80 0,80 0,20 20,20;"
        "fold E valley 90 80,20 80,80 right; fold N valley 90 80,80 20,80 right;"
        "fold W valley 90 20,80 20,20 right; fold S valley 90 20,20 80,20 right"}) {
    const FoldedState state = run(text);
    EXPECT_FALSE(firstPierced(state).has_value()) << text;
    EXPECT_TRUE(crossingViolations(state).empty()) << text;
  }
}

}  // namespace
}  // namespace kiri::test
