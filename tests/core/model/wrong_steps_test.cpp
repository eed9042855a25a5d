// Every mistake that a step can hold gets its code and a sentence that says what, where, and what
// to do. SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/text.h"
#include "core/model/apply.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

struct Mistake {
  const char* text;  // the last step is wrong
  ErrorCode code;
  const char* fragment;
};

class WrongSteps : public testing::TestWithParam<Mistake> {};

TEST_P(WrongSteps, AreRefusedWithASentence) {
  const Mistake& mistake = GetParam();
  EXPECT_TRUE(failsWith(tryRun(mistake.text), mistake.code, mistake.fragment)) << mistake.text;
}

const Mistake kBadValues[] = {
    {"square 100; fold valley 200 50,0 50,100 left", ErrorCode::BadValue, "200"},
    {"square 100; fold valley -10 50,0 50,100 left", ErrorCode::BadValue, "0 to 180"},
    {"square 100; fold valley 50,50 50,50 left", ErrorCode::BadValue, "no length"},
    {"square 100; fold valley 50,0 50,100 to 50,50", ErrorCode::BadValue, "lies on the fold line"},
    {"square 100; fold valley 50,0 50,100 moving", ErrorCode::BadValue, "no facet is named"},
    {"square 100; edge 50,0 50,100; fold valley 50,0 50,100 moving 20,50 80,50",
     ErrorCode::BadValue, "both sides"},
    {"square 100; fold A valley 50,0 50,100 left; fold A valley 80,0 80,100 right",
     ErrorCode::BadValue, "another name"},
    {"square 100; fold valley 50,0 50,100 left top 0", ErrorCode::BadValue, "1 or more"},
    {"square 100; fold A valley 90 50,0 50,100 left; fold B valley 80,0 80,100 right facets 20,50",
     ErrorCode::BadValue, "plane of the line"},
    {"square 100; fold A valley 50,0 50,100 left; angle A 181", ErrorCode::BadValue, "-180 to 180"},
    {"square 100; edge 50,0 50,100; tear 50,0", ErrorCode::BadValue, "only one point"},
    {"square 100; edge 50,0 50,100; tear 50,0 50,0", ErrorCode::BadValue, "are the same"},
    {"square 100; edge 50,0 50,100; tear 50,0 50,100 top 0", ErrorCode::BadValue, "1 or more"},
    {"square 100; curve @model 0,0 50,60 100,0 keep m:50,5", ErrorCode::BadValue,
     "needs at least 4"},
    {"square 100; curve @model 20,20 80,80 closed", ErrorCode::BadValue, "needs at least 3"},
    {"square 100; rotate nan", ErrorCode::BadValue, "number"},
    {"square 100; rotate inf", ErrorCode::BadValue, "number"},
    {"square 100; move nan,0", ErrorCode::BadValue, "number"},
    {"square 100; fold valley nan 50,0 50,100 left", ErrorCode::BadValue, "number"},
    {"square 100; fold valley nan,0 50,100 left", ErrorCode::BadValue, "number"},
    {"square 100; fold valley @model inf,0 50,100 left", ErrorCode::BadValue, "number"},
    {"square 100; edge nan,0 50,100", ErrorCode::BadValue, "number"},
    {"square 100; cut nan,0 50,100", ErrorCode::BadValue, "number"},
    {"square 100; curve @model nan,0 50,100 20,20 30,30", ErrorCode::BadValue, "number"},
    {"square 100; edge 50,0 50,100; tear nan,0 50,100", ErrorCode::BadValue, "number"},
    {"square 100; fold A valley 50,0 50,100 left; angle A nan", ErrorCode::BadValue, "degrees"},
};

const Mistake kNotFound[] = {
    {"square 100; angle A 90", ErrorCode::NotFound, "nothing has been folded yet"},
    {"square 100; fold B valley 50,0 50,100 left; angle A 90", ErrorCode::NotFound, "\"B\""},
    {"square 100; fold B valley 50,0 50,100 left; angle 10,10 90", ErrorCode::NotFound, "(10, 10)"},
    {"square 100; fold B valley 50,0 50,100 left; unfold A", ErrorCode::NotFound, "\"A\""},
    {"square 100; fold valley 50,0 50,100 left in 200,200", ErrorCode::NotFound, "(200, 200)"},
    {"square 100; fold valley 50,0 50,100 to 300,50", ErrorCode::NotFound, "(300, 50)"},
    {"square 100; fold valley 50,0 50,100 left facets 300,50", ErrorCode::NotFound, "(300, 50)"},
    {"square 100; cut 50,0 50,100 keep 300,50", ErrorCode::NotFound, "(300, 50)"},
    {"square 100; cut 50,-1 50,101 keep m:300,50", ErrorCode::NotFound, "(300, 50)"},
};

const Mistake kOthers[] = {
    {"square 100; fold valley 150,0 150,100 left", ErrorCode::MissesPaper,
     "draw it across the paper"},
    {"square 100; fold valley @model 150,0 150,100 left", ErrorCode::MissesPaper, "on the model"},
    {"square 100; edge 150,0 150,100", ErrorCode::MissesPaper, "no paper under the line"},
    {"square 100; cut 150,0 150,100", ErrorCode::MissesPaper, "no paper under the line"},
    {"square 100; curve @model 150,0 160,50 170,60 180,100", ErrorCode::MissesPaper,
     "cutting curve"},
    {"square 100; fold valley 0.0005,-10 0.0005,110 left", ErrorCode::TooThin, "sliver"},
    {"square 100; edge -10,0.0005 110,0.0005", ErrorCode::TooThin, "sliver"},
    {"disc 100; fold valley 0.000001,0 0.000001,100 left", ErrorCode::TooThin, "sliver"},
    {"square 100; edge 50,0 50,100; fold A valley 100,40 50,60 to 90,90 facets 75,50",
     ErrorCode::WouldStretch, "(50, 60)"},
    {"square 100; fold A valley 50,0 50,100 left; fold B valley 60 @model 40,50 110,50 left; angle "
     "A 90",
     ErrorCode::Locked, "\"B\""},
    {"square 100; curve @model -20,50 110,50 110,90 20,90 20,10 50,-30",
     ErrorCode::CurveCrossesItself, "crosses itself at"},
    {"square 100; cut 50,-10 50,50 keep m:25,50", ErrorCode::DoesNotSeparate, "still joined"},
    {"square 100; mend", ErrorCode::NothingToDo, "torn"},
    {"square 100; tear 50,0 50,100", ErrorCode::NothingToDo, "(50, 0)"},
    {"square 100; edge 50,0 50,100; edge 50,0 50,100", ErrorCode::MissesPaper, "there already"},
    {"square 100; fold valley 30,0 30,100 left; tear 30,0 30,100;"
     "fold valley @model 20,50 70,50 left facets p:10,50; mend 30,70 30,100",
     ErrorCode::CannotMend, "moved apart"},
};

INSTANTIATE_TEST_SUITE_P(BadValue, WrongSteps, testing::ValuesIn(kBadValues));
INSTANTIATE_TEST_SUITE_P(NotFound, WrongSteps, testing::ValuesIn(kNotFound));
INSTANTIATE_TEST_SUITE_P(Others, WrongSteps, testing::ValuesIn(kOthers));

TEST(Errors, LeaveTheStateAsItWas) {
  const FoldedState state = run("square 100; fold A valley 50,0 50,100 left");
  const FoldedState before = state;
  EXPECT_FALSE(tryAfter(state, "fold B valley 0.0005,-10 0.0005,110 left in 20,50").isOk());
  EXPECT_TRUE(isSameState(state, before));
}

TEST(Errors, PointAtThePaper) {
  const Result<FoldedState> thin = tryRun("square 100; edge -10,0.0005 110,0.0005");
  ASSERT_FALSE(thin.isOk());
  EXPECT_FALSE(thin.error().witness.points.empty());
  const Result<FoldedState> missing = tryRun("square 100; fold valley 50,0 50,100 to 300,50");
  ASSERT_FALSE(missing.isOk());
  EXPECT_FALSE(missing.error().witness.points.empty());
}

TEST(Sentences, TellPlacesWithoutTheirRounding) {
  EXPECT_EQ(text(Vec2{-1.85777e-14, -25}), "(0, -25)");
  EXPECT_EQ(text(Vec2{52.125, 3e-16}), "(52.125, 0)");
  EXPECT_EQ(text(Vec2{1e-5, 25}), "(1e-05, 25)");
  EXPECT_EQ(text(Vec2{2e-15, 3e-15}), "(2e-15, 3e-15)");
}

}  // namespace
}  // namespace kiri::test
