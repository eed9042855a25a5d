// Fields of steps: all kinds, each settable, nothing else touched.
// SPDX-License-Identifier: MIT
#include "editor/document/step_fields.h"

#include <gtest/gtest.h>

#include <set>

#include "editor/document/document.h"
#include "io/kiri_reader.h"
#include "io/kiri_writer.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

/// Every kind of step, with every kind of layers, sides and lines.
std::vector<Step> allKinds() {
  std::vector<Step> steps = stepsOf(
      "fold A valley 90 50,0 50,100 left; fold mountain @model 0,0 9,9 right top 2;"
      "fold valley 0,0 9,9 to 1,2 facets 3,4 5,6; fold valley 0,0 9,9 moving 1,2 3,4;"
      "angle A 30; angle 5,6 -30; unfold all; unfold A together; refold A 1,2;"
      "tear 50,0 50,50 20,20 top 1; mend; mend 1,2 3,4; edge 0,0 5,5 facets 1,1;"
      "cut 0,0 100,100 top 1 keep 1,2; cut @model 0,0 100,100 through;"
      "curve 0,0 1,5 9,9 20,1 closed; curve @model 0,0 1,5 9,9 20,1 free through; turn;"
      "turn horizontal; rotate 30; rotate 30 1,2; move 3,4");
  steps[0].title = "a title";
  steps[3].notes = "two\nlines";
  steps[7].unknown = "{\"x\":1}";
  steps[6].action = UnfoldStep{{std::string("mid vein"), std::string("tip")}, Sequence::InOrder};
  return steps;
}

FieldValue valueOf(const Field& field) { return {field.value, field.text}; }

/// Another value that the field takes.
FieldValue otherThan(const Field& field) {
  FieldValue other = valueOf(field);
  other.text += "other";
  other.number = field.value == field.most ? field.least : field.most;
  return other;
}

std::string fileOf(const Step& step) {
  Model model;
  model.steps = {step};
  return writeKiri(model);
}

TEST(StepFields, OfEveryKindHaveTheirOwnIdsAndValuesThatTheyAllow) {
  for (const Step& step : allKinds()) {
    SCOPED_TRACE(fileOf(step));
    std::set<std::string> ids;
    for (const Field& field : fieldsOf(step)) {
      EXPECT_TRUE(ids.insert(field.id).second) << field.id;
      EXPECT_FALSE(field.label.isEmpty());
      if (field.kind == Field::Kind::Text) continue;
      EXPECT_GE(field.value, field.least);
      EXPECT_LE(field.value, field.most);
      EXPECT_EQ(field.kind == Field::Kind::Choice, !field.options.empty());
    }
    EXPECT_TRUE(ids.count("title") == 1 && ids.count("notes") == 1);
    EXPECT_FALSE(summaryOf(step, 3).isEmpty());
  }
}

TEST(StepFields, SettingTheValueThatIsThereChangesNothing) {
  for (const Step& step : allKinds()) {
    for (const Field& field : fieldsOf(step)) {
      const Result<Step> same = withField(step, field.id, valueOf(field));
      ASSERT_TRUE(same.isOk()) << field.id << ": " << same.error().message;
      EXPECT_EQ(fileOf(*same), fileOf(step)) << field.id;
      EXPECT_TRUE(*same == step) << field.id;
    }
  }
}

TEST(StepFields, SettingOneValueIsReadBackAndChangesNoOther) {
  for (const Step& step : allKinds()) {
    SCOPED_TRACE(fileOf(step));
    for (const Field& field : fieldsOf(step)) {
      const FieldValue wanted = otherThan(field);
      const Result<Step> changed = withField(step, field.id, wanted);
      ASSERT_TRUE(changed.isOk()) << field.id << ": " << changed.error().message;
      EXPECT_FALSE(*changed == step) << field.id;
      for (const Field& after : fieldsOf(*changed)) {
        if (after.id == "count") continue;  // comes and goes with the layers
        const std::vector<Field> before = fieldsOf(step);
        const auto same = std::find_if(before.begin(), before.end(),
                                       [&](const Field& one) { return one.id == after.id; });
        ASSERT_NE(same, before.end()) << after.id;
        const FieldValue expected = after.id == field.id ? wanted : valueOf(*same);
        EXPECT_EQ(after.value, expected.number) << after.id;
        if (after.kind == Field::Kind::Text) {
          EXPECT_EQ(after.text, expected.text) << after.id;
        }
      }
      // What a person can set a file can hold.
      const std::string file = fileOf(*changed);
      const Result<LoadedModel> read = readKiri(file, "test");
      ASSERT_TRUE(read.isOk()) << read.error().message;
      EXPECT_EQ(writeKiri(read->model), file);
    }
  }
}

TEST(StepFields, EveryNumberOfAStepCanBeReached) {
  const Step fold = stepOf("fold A valley 90 50,0 50,100 left top 3");
  std::set<double> values;
  for (const Field& field : fieldsOf(fold)) values.insert(field.value);
  for (const double number : {90.0, 50.0, 0.0, 100.0, 3.0})
    EXPECT_EQ(values.count(number), 1u) << number;
  const std::vector<Field> curve = fieldsOf(stepOf("curve 0,0 1,5 9,9 20,1"));
  const auto isControl = [](const Field& field) { return field.id.rfind("control.", 0) == 0; };
  EXPECT_EQ(std::count_if(curve.begin(), curve.end(), isControl), 8);
}

void expectRefused(const Step& step, const std::string& id, const FieldValue& value,
                   const std::string& fragment) {
  const Result<Step> refused = withField(step, id, value);
  ASSERT_FALSE(refused.isOk()) << id;
  EXPECT_EQ(refused.error().code, ErrorCode::BadValue);
  EXPECT_NE(refused.error().message.find(fragment), std::string::npos) << refused.error().message;
}

TEST(StepFields, WhatAFieldDoesNotTakeIsRefusedWithWhatItTakes) {
  const Step fold = stepOf("fold A valley 90 50,0 50,100 left top 3");
  expectRefused(fold, "angle", {200, ""}, "0 to 180°, not 200");
  expectRefused(fold, "angle", {std::nan(""), ""}, "0 to 180");
  expectRefused(fold, "from.x", {HUGE_VAL, ""}, "mm");
  expectRefused(fold, "type", {2, ""}, "\"Valley\", \"Mountain\"");
  expectRefused(fold, "type", {0.5, ""}, "\"Valley\"");
  expectRefused(fold, "count", {0, ""}, "1 to");
  expectRefused(fold, "name", {0, "two\nlines"}, "one line");
  expectRefused(stepOf("angle A 30"), "line", {0, ""}, "name of a fold");
  const Result<Step> unknown = withField(fold, "axis", {0, ""});
  ASSERT_FALSE(unknown.isOk());
  EXPECT_EQ(unknown.error().code, ErrorCode::NotFound);
}

TEST(StepFields, ListsOfFoldsAreNamesPartedByCommas) {
  const Step step = stepOf("unfold A");
  const Step two = withField(step, "lines", {0, " mid vein,tip , "}).value();
  EXPECT_EQ(std::get<UnfoldStep>(two.action).lines,
            (std::vector<FoldLineName>{std::string("mid vein"), std::string("tip")}));
  EXPECT_TRUE(std::get<UnfoldStep>(withField(step, "lines", {0, ""})->action).lines.empty());
}

TEST(StepFields, LayersPickedOneByOneAreKeptUntilOthersAreChosen) {
  const Step step = stepOf("edge 0,0 5,5 facets 1,1 2,2");
  const Step all = withField(step, "layers", {0, ""}).value();
  EXPECT_TRUE(std::holds_alternative<AllLayers>(std::get<AddEdgeStep>(all.action).layers));
  const Step top = withField(step, "layers", {1, ""}).value();
  EXPECT_EQ(std::get<TopLayers>(std::get<AddEdgeStep>(top.action).layers).count, 1);
  expectRefused(step, "layers", {3, ""}, "\"Chosen layers (2)\"");
}

TEST(StepFields, TheMovingSideOfAFoldThatWasMadeCanBeTurned) {
  Document document = Document::create(modelOf("square 100")).value();
  document.become(addStep(stepOf("fold A valley 60,0 60,100 left"))(document.history(), {}).value(),
                  {});
  const Step made = document.model().steps[0];
  const Vec2 right{80, 50};
  EXPECT_TRUE(liesAt(*document.state(), right, {80, 50, 0}));
  const Step turned = withField(made, "moving", {1, ""}).value();
  document.become(editStep(0, turned)(document.history(), {}).value(), {});
  EXPECT_TRUE(liesAt(*document.state(), right, {40, 50, 0}));
}

TEST(StepSummary, SaysWhatAStepIs) {
  EXPECT_EQ(inEnglish(summaryOf(stepOf("fold valley 0,0 5,5 left"), 3)), "fold 3: valley, 180°");
  EXPECT_EQ(inEnglish(summaryOf(stepOf("fold roof mountain 90 0,0 5,5 left"), 3)),
            "roof: mountain, 90°");
  EXPECT_EQ(inEnglish(summaryOf(stepOf("angle A 30"), 1)), "A to 30°");
  EXPECT_EQ(inEnglish(summaryOf(stepOf("unfold all together"), 1)), "unfold all together");
  EXPECT_EQ(inEnglish(summaryOf(stepOf("move 3,4"), 1)), "move by (3, 4) mm");
}

}  // namespace
}  // namespace kiri::test
