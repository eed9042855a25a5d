// Reads examples/ once.
// SPDX-License-Identifier: MIT
#include "tests/examples/example_models.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/model/replay.h"
#include "io/file.h"
#include "io/kiri_reader.h"
#include "tests/support/example_files.h"

namespace kiri::test {
namespace {

ExampleModel replayed(const std::string& name) {
  ExampleModel out;
  out.name = name;
  const std::string path = KIRI_SOURCE_DIR "/examples/" + name + ".kiri";
  const Result<std::string> text = readFile(path);
  if (!text) return out.problem = text.error().message, out;
  Result<LoadedModel> loaded = readKiri(*text, name + ".kiri");
  if (!loaded) return out.problem = loaded.error().message, out;
  for (const std::string& warning : loaded->warnings) out.problem += warning;
  out.model = std::move(loaded->model);
  const Result<Replay> steps = replay(out.model);
  if (!steps) return out.problem = steps.error().message, out;
  out.states.push_back(steps->start);
  for (const StepOutcome& outcome : steps->outcomes) {
    if (!outcome.state) {
      out.problem = momentName(out, out.states.size()) + ": " + outcome.error->message;
      break;
    }
    out.states.push_back(outcome.state);
  }
  return out;
}

}  // namespace

const std::vector<std::string>& exampleNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    for (const std::filesystem::path& file : exampleFilesThatTakeLong())
      found.push_back(file.stem().string());
    return found;
  }();
  return names;
}

const ExampleModel& exampleModel(const std::string& name) {
  static std::map<std::string, ExampleModel> known;
  const auto found = known.find(name);
  return found != known.end() ? found->second : known.emplace(name, replayed(name)).first->second;
}

void ExampleTest::SetUp() { ASSERT_EQ(example().problem, "") << GetParam(); }

std::string momentName(const ExampleModel& example, std::size_t step) {
  return example.name + " step " + std::to_string(step);
}

}  // namespace kiri::test
