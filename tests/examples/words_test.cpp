// What the models of examples/ tell the reader: the figure that they show, and what each step does.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "tests/examples/example_models.h"

namespace kiri::test {
namespace {

class EveryExampleSays : public ExampleTest {};

bool startsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

/// One or more sentences: a capital letter or a digit first, a full stop last.
bool areSentences(const std::string& text) {
  if (text.empty()) return false;
  const auto first = static_cast<unsigned char>(text.front());
  return (std::isupper(first) != 0 || std::isdigit(first) != 0) &&
         (text.back() == '.' || text.back() == '!') && text.find('\n') == std::string::npos;
}

TEST_P(EveryExampleSays, WhichFigureItIs) {
  const Model& model = example().model;
  EXPECT_NE(model.title, "");
  EXPECT_TRUE(areSentences(model.notes)) << model.notes;
  if (startsWith(example().name, "pattern_")) return;
  const std::initializer_list<const char*> starts = {"Figure ", "Figures ", "Like Figure ",
                                                     "The traditional "};
  EXPECT_TRUE(std::any_of(starts.begin(), starts.end(), [&](const char* start) {
    return startsWith(model.notes, start);
  })) << model.notes;
}

TEST_P(EveryExampleSays, WhatEachStepDoes) {
  const Model& model = example().model;
  for (std::size_t i = 0; i < model.steps.size(); ++i) {
    const Step& step = model.steps[i];
    EXPECT_NE(step.title, "") << momentName(example(), i + 1);
    EXPECT_TRUE(areSentences(step.notes))
        << momentName(example(), i + 1) << " (" << step.title << "): \"" << step.notes << '"';
  }
}

KIRI_FOR_EVERY_EXAMPLE(EveryExampleSays);

TEST(AreSentences, WantsACapitalLetterAndAFullStop) {
  EXPECT_FALSE(areSentences("the paper bends."));
  EXPECT_FALSE(areSentences("The paper bends"));
  EXPECT_FALSE(areSentences(""));
  EXPECT_TRUE(areSentences("The paper bends."));
}

}  // namespace
}  // namespace kiri::test
