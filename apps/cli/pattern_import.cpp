// A crease pattern as a model: what every command that takes MODEL does with a pattern.
// SPDX-License-Identifier: MIT
#include "apps/cli/pattern_import.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "apps/cli/search_watch.h"
#include "apps/cli/state_number.h"
#include "core/flatfold/polish.h"
#include "core/model/pattern_model.h"
#include "core/paper/boxes.h"
#include "io/patterns/pattern_model_file.h"
#include "io/patterns/states_fold.h"

namespace kiri::cli {

namespace {

/// Unassigned creases get the directions that they have in a state.
void assign(AssignedPattern& creases, const FlatMap& map, const OrderProblem& problem,
            const LayerValues& values) {
  for (std::size_t i = 0; i < creases.assignments.size(); ++i) {
    if (creases.assignments[i] != Assignment::Unassigned || !creases.isFolded(EdgeId(i))) continue;
    creases.assignments[i] = foldedAs(creases, map, problem, values, EdgeId(i));
    constexpr double kFold = 180;
    creases.pattern.edges[i].angle =
        creases.assignments[i] == Assignment::Mountain ? -kFold : kFold;
  }
}

/// The creases made exact and assigned as in a state, and that state in them.
struct ChosenFolding {
  AssignedPattern creases;
  std::shared_ptr<const FoldedState> state;
};

Result<ChosenFolding> chooseState(const AssignedPattern& creases, const std::string& number,
                                  SearchWatch& watch) {
  Result<Polished> exact =
      watch.part("folding", [&](const Progress& progress) { return polished(creases, progress); });
  if (!exact.isOk()) return exact.error();
  const Result<FlatFolding> folding = watch.part("searching", [&](const Progress& progress) {
    return flatFold(exact->creases, {}, progress);
  });
  if (!folding.isOk()) return folding.error();
  const LayerStates& states = folding->states;
  if (!states.exist()) return Error{ErrorCode::NotFound, states.conflict().message};
  const Result<LayerValues> values = watch.part(
      "searching state " + number,
      [&](const Progress& progress) { return states.state(stateNumber(number), progress); });
  if (!values.isOk()) return values.error();
  assign(exact->creases, folding->map, states.problem(), *values);
  auto state =
      std::make_shared<const FoldedState>(foldedStateOf(exact->creases, states.problem(), *values));
  return ChosenFolding{std::move(exact->creases), std::move(state)};
}

/// The model folded in the state that was asked for.
Result<PatternModel> modelByNumber(const PatternFile& file, PatternModelOptions wanted,
                                   const std::string& number, SearchWatch& watch) {
  Result<PatternOfFile> pattern = watch.part(
      "reading", [&](const Progress& progress) { return patternOfFile(file, progress); });
  if (!pattern.isOk()) return pattern.error();
  flattenAngles(pattern->repaired.creases);
  Result<ChosenFolding> chosen = chooseState(pattern->repaired.creases, number, watch);
  if (!chosen.isOk()) return chosen.error();
  wanted.chosen = chosen->state;
  Result<PatternModel> made = watch.part("folding", [&](const Progress& progress) {
    return modelOf(chosen->creases, wanted, progress);
  });
  if (!made.isOk()) return made;
  made->notes.insert(made->notes.begin(), pattern->notes.begin(), pattern->notes.end());
  return made;
}

Error named(const std::string& name, Error error) {
  if (error.code != ErrorCode::Cancelled) error.message = name + ": " + error.message;
  return error;
}

}  // namespace

void addImportOptions(CLI::App& command, ImportOptions& options) {
  command
      .add_option("--size", options.size,
                  "pattern to model: mm of the longest side (default: what the file says)")
      ->type_name("MM");
  command.add_flag("--flat", options.isFlat, "pattern to model: draw the creases, fold nothing");
  command
      .add_option("--state", options.state,
                  "pattern to model: which folded state, from 0 (kiri states counts them)")
      ->type_name("N");
}

Status checkImport(const ImportOptions& options) {
  constexpr double kLargest = 1e6;
  if (!(options.size >= 0 && options.size <= kLargest))
    return Error{ErrorCode::BadValue, "--size must be above 0 and at most 1000000 mm"};
  if (!options.state.empty() && !isStateNumber(options.state)) {
    return Error{ErrorCode::BadValue,
                 "--state " + options.state + " is no number; states count from 0"};
  }
  if (options.isFlat && !options.state.empty())
    return Error{ErrorCode::BadValue, "--flat folds nothing, --state chooses a folded state"};
  return std::monostate{};
}

Result<ModelInput> modelFromPattern(Console& console, const InputText& text,
                                    const ImportOptions& options) {
  const Result<PatternFile> file = readPattern(text.text, text.name);
  if (!file.isOk()) return file.error();
  SearchWatch watch(console, 0);
  PatternModelOptions wanted;
  wanted.title = file->title.empty() ? bareName(text) : file->title;
  wanted.isFolded = !options.isFlat;
  wanted.longestSide = options.size;
  Result<PatternModel> made = options.state.empty()
                                  ? watch.part("folding",
                                               [&](const Progress& progress) {
                                                 return modelOfFile(*file, wanted, progress);
                                               })
                                  : modelByNumber(*file, wanted, options.state, watch);
  if (!made.isOk()) return named(text.name, made.error());
  for (const std::string& note : made->notes) console.err << "note: " << note << '\n';
  return ModelInput{text.name, text.folder, std::move(made->model)};
}

Result<Model> modelInState(Console& console, const PatternInput& input, const FlatMap& map,
                           const OrderProblem& problem, const LayerValues& values,
                           const Progress& progress) {
  Result<Polished> exact = polished(input.creases, progress);
  if (!exact.isOk()) return exact.error();
  assign(exact->creases, map, problem, values);
  PatternModelOptions wanted;
  wanted.title = input.title;
  wanted.chosen =
      std::make_shared<const FoldedState>(foldedStateOf(exact->creases, problem, values));
  if (input.file && !input.file->mmPerUnit) {
    const PatternScale scale = scaleOf(*input.file);
    const Box box = paperBoxOf(exact->creases.pattern);
    const double longest = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    if (scale.mmPerUnit != 1) wanted.longestSide = longest * scale.mmPerUnit;
    if (!scale.note.empty()) console.err << "note: " << scale.note << '\n';
  }
  Result<PatternModel> made = modelOf(exact->creases, wanted, progress);
  if (!made.isOk()) return made.error();
  for (const std::string& note : made->notes) console.err << "note: " << note << '\n';
  return std::move(made->model);
}

}  // namespace kiri::cli
