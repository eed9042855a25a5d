// The steps of a model as frames of a FOLD file.
// SPDX-License-Identifier: MIT
#include "io/fold_history.h"

#include <cstddef>
#include <utility>

#include "core/base/check.h"
#include "io/steps_json.h"

namespace kiri {

std::vector<FoldFrame> foldHistoryOf(const Model& model,
                                     const std::vector<std::shared_ptr<const FoldedState>>& after,
                                     std::shared_ptr<const FoldedState> between) {
  KIRI_CHECK(after.size() + (between ? 1 : 0) <= model.steps.size(), "each state has its step");
  std::vector<FoldFrame> frames;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Step& step = model.steps[i];
    frames.push_back(
        {after[i], step.title.empty() ? describeStep(step, i + 1) : step.title, step.notes});
  }
  if (between) {
    const std::size_t under = after.size();
    frames.push_back({std::move(between), "in " + describeStep(model.steps[under], under + 1), ""});
  }
  return frames;
}

}  // namespace kiri
