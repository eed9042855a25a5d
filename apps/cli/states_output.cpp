// Folded states as files: FOLD, models, pictures.
// SPDX-License-Identifier: MIT
#include "apps/cli/states_output.h"

#include <algorithm>
#include <utility>

#include "apps/cli/numbered_files.h"
#include "apps/cli/pattern_import.h"
#include "apps/cli/picture_options.h"
#include "core/flatfold/polish.h"
#include "core/paper/boxes.h"
#include "io/kiri_writer.h"
#include "io/patterns/states_fold.h"
#include "render/scene/model_scene.h"
#include "render/scene/pattern_check_scene.h"

namespace kiri::cli {

namespace {

std::string titleOf(const ChosenState& state, const StatesAnswer& answer) {
  return "state " + state.number + (answer.total ? " of " + answer.total->str() : "");
}

/// Millimetres that a picture takes for a unit of the pattern: what has no size is drawn with the
/// longest side of the folded model at 150 mm.
double pictureScale(const PatternInput& input, const FoldedState& folded) {
  if (input.unit == "mm") return 1;
  const ModelBox box = modelBoxOf(folded);
  const double longest = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  constexpr double kSide = 150;
  return longest > 0 ? kSide / longest : 1;
}

Result<std::string> pictureOf(const PatternInput& input, const AssignedPattern& exact,
                              const StatesAnswer& answer, const ChosenState& state,
                              const StatesFile& file, const Progress& progress) {
  const FoldedState folded = foldedStateOf(exact, answer.states->problem(), state.values);
  constexpr double kMargin = 5;
  const double scale = pictureScale(input, folded);
  Result<Scene> scene =
      modelScene(folded, Appearance{}, frontSpec(),
                 {kMargin, scale, input.title + ", " + titleOf(state, answer), {}, {}, progress});
  if (!scene.isOk()) return scene.error();
  return pictureBytes(*scene, file.format, file.dpi);
}

int writePictures(Console& console, const PatternInput& input, const StatesAnswer& answer,
                  const std::vector<ChosenState>& states, const StatesFile& file,
                  const Progress& progress) {
  const Result<Polished> exact = polished(input.creases, progress);
  if (!exact.isOk()) return fail(console, exact.error());
  const std::optional<NumberedPath> path = numberedPath(file.path);
  if (!path) {
    const Result<std::string> bytes =
        pictureOf(input, exact->creases, answer, states.front(), file, progress);
    if (!bytes.isOk()) return fail(console, bytes.error());
    return writeResult(console, file.path, *bytes);
  }
  NumberedFiles files(*path, 0);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Result<std::string> bytes = pictureOf(input, exact->creases, answer, states[i], file, {});
    if (!bytes.isOk()) return fail(console, bytes.error());
    const Status written = files.add(*bytes);
    if (!written.isOk()) return fail(console, written.error());
    const double done = static_cast<double>(i + 1) / static_cast<double>(states.size());
    if (!goesOn(progress, done)) return fail(console, Error{ErrorCode::Cancelled, "", {}});
  }
  files.keep();
  return kDone;
}

int writeFrames(Console& console, const PatternInput& input, const StatesAnswer& answer,
                const std::vector<ChosenState>& states, const StatesFile& file) {
  StatesFoldOptions options;
  options.creator = "KiriSim " KIRI_VERSION;
  options.title = input.title;
  options.unit = input.unit == "mm" ? "mm" : "unit";
  if (input.file) options.description = input.file->description;
  std::vector<StateFrame> frames;
  for (const ChosenState& state : states) frames.push_back({titleOf(state, answer), state.values});
  const WrittenPattern written =
      writeStates(input.creases, *answer.report.map, answer.states->problem(), frames, options);
  for (const std::string& loss : written.losses) console.err << "note: " << loss << '\n';
  return writeResult(console, file.path, written.text);
}

}  // namespace

namespace {

int writeModel(Console& console, const PatternInput& input, const StatesAnswer& answer,
               const ChosenState& state, const StatesFile& file, const Progress& progress) {
  const Result<Model> model = modelInState(console, input, *answer.report.map,
                                           answer.states->problem(), state.values, progress);
  if (!model.isOk()) return fail(console, model.error());
  return writeResult(console, file.path, writeKiri(*model));
}

}  // namespace

bool isPicture(const std::string& format) { return format != "fold" && format != "kiri"; }

int writeConflictPicture(Console& console, const PatternInput& input, const StatesAnswer& answer,
                         const StatesFile& file) {
  PatternCheckOptions options;
  options.title = input.title;
  options.verdict = verdictOf(answer.report);
  if (!answer.report.map) options.verdict += "; " + closingOf(answer.report, input.unit);
  const Appearance appearance;
  Scene scene = answer.states && answer.report.map
                    ? orderConflictScene(input.creases, *answer.report.map,
                                         answer.states->conflict(), appearance, options)
                    : patternCheckScene(input.creases, answer.report.faults, input.repairs,
                                        appearance, options);
  scene.background = Color{255, 255, 255};
  const Result<std::string> bytes = pictureBytes(scene, file.format, file.dpi);
  if (!bytes.isOk()) return fail(console, bytes.error());
  const std::optional<NumberedPath> path = numberedPath(file.path);
  return writeResult(console, path ? path->at(0) : file.path, *bytes);
}

std::vector<std::string> stateFormats() { return {"fold", "kiri", "svg", "png", "pdf"}; }

Status checkStatesFile(const StatesFile& file, bool isSeveral) {
  if (file.format == "fold" || !isSeveral) return std::monostate{};
  if (file.format == "kiri")
    return Error{ErrorCode::BadValue, "a .kiri file takes one state; choose it with --state"};
  if (numberedPath(file.path)) return std::monostate{};
  return Error{ErrorCode::BadValue,
               file.path +
                   " has no place for the numbers of the states; write one like state_%04d." +
                   file.format};
}

int writeStatesFile(Console& console, const PatternInput& input, const StatesAnswer& answer,
                    const std::vector<ChosenState>& states, const StatesFile& file,
                    SearchWatch& watch) {
  return watch.part("writing", [&](const Progress& progress) {
    if (file.format == "fold") return writeFrames(console, input, answer, states, file);
    if (file.format == "kiri")
      return writeModel(console, input, answer, states.front(), file, progress);
    return writePictures(console, input, answer, states, file, progress);
  });
}

}  // namespace kiri::cli
