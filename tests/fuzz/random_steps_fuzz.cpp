// Steps chosen by the bytes of the input: nothing may crash, and every state must hold together.
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/model/apply.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kiri;
  using namespace kiri::test;
  if (size < 2) return 0;
  Random sheet(data[0]);
  Model model = randomSheet(sheet);
  FoldedState state = startOf(model);
  RandomStepOptions options;
  options.facetLimit = 24;
  for (std::size_t i = 1; i + 1 < size && i < 64; i += 2) {
    Random random(data[i] * 256u + data[i + 1]);
    model.steps.push_back(randomStep(random, state, options));
    Result<FoldedState> next =
        apply(state, model.steps.back(), static_cast<int>(model.steps.size()));
    if (!next) {
      model.steps.pop_back();
      continue;
    }
    state = std::move(next).value();
    std::vector<std::string> found = patternViolations(state.pattern);
    if (found.empty()) found = poseViolations(state);
    if (found.empty()) continue;
    std::fprintf(stderr, "%s%s\n", textOf(model).c_str(), joined(found).c_str());
    std::abort();
  }
  return 0;
}
