// The models of examples/, each read and replayed once.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "core/model/model.h"
#include "core/paper/folded_state.h"

namespace kiri::test {

struct ExampleModel {
  std::string name;  ///< of the file, without its ending
  Model model;
  /// After 0, 1, 2, ... steps, as far as they apply.
  std::vector<std::shared_ptr<const FoldedState>> states;
  std::string problem;  ///< why it cannot be read or a step does not apply; empty: neither

  const FoldedState& last() const { return *states.back(); }
};

/// Names of all models in examples/, sorted; in the build with sanitizers every fifth.
const std::vector<std::string>& exampleNames();

/// Reads and replays a model, or returns what came of it before.
const ExampleModel& exampleModel(const std::string& name);

/// One case for each model. Cases of a model that does not replay fail.
class ExampleTest : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override;
  const ExampleModel& example() const { return exampleModel(GetParam()); }
};

/// "origami_cup step 3" for messages; 0 is the sheet.
std::string momentName(const ExampleModel& example, std::size_t step);

}  // namespace kiri::test

/// Makes a suite of claims run once for each model.
#define KIRI_FOR_EVERY_EXAMPLE(suite)                                                  \
  INSTANTIATE_TEST_SUITE_P(Of, suite, testing::ValuesIn(::kiri::test::exampleNames()), \
                           [](const testing::TestParamInfo<std::string>& i) { return i.param; })
