// States to draw: random ones and those of the examples; pictures kept when a test fails.
// SPDX-License-Identifier: MIT
#include "tests/render/gl/states.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/model/replay.h"
#include "io/file.h"
#include "io/kiri_reader.h"
#include "render/canvas/png.h"
#include "tests/support/model_text.h"

namespace kiri::test {

FoldedState randomFolded(Random& random) {
  FoldedState state = startOf(randomSheet(random));
  for (int i = 0; i < 10; ++i) {
    const Step step = randomStep(random, state, {});
    if (Result<FoldedState> next = tryAfter(state, textOf(step))) state = std::move(*next);
  }
  for (int i = 0; i < 3 && !state.lines.empty(); ++i) {
    const std::string& name = state.lines[random.below(state.lines.size())].name;
    const std::string angle = std::to_string(random.between(-175, 175));
    if (Result<FoldedState> next = tryAfter(state, "angle " + name + " " + angle))
      state = std::move(*next);
  }
  return state;
}

std::vector<Example> allExamples() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(KIRI_SOURCE_DIR) + "/examples")) {
    if (entry.path().extension() == ".kiri") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Example> out;
  for (const std::filesystem::path& file : files) {
    const LoadedModel loaded = *readKiri(*readFile(file.string()), file.string());
    const Replay steps = *replay(loaded.model);
    const std::size_t count = loaded.model.steps.size();
    Example& example = out.emplace_back();
    example.name = file.stem().string();
    for (const std::size_t done : {count / 2, count}) example.states.push_back(**steps.after(done));
  }
  return out;
}

void keepPicture(const Image& image, const std::string& name) {
  const char* folder = std::getenv("KIRI_FAILED_PICTURES");
  if (folder == nullptr) return;
  const std::string path = std::string(folder) + "/" + name + ".png";
  EXPECT_TRUE(writeFile(path, *encodePng(image, 0))) << path;
}

}  // namespace kiri::test
