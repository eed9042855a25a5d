// The pictures and files that the gallery shows of one model.
// SPDX-License-Identifier: MIT
#include "apps/cli/gallery_entry.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "apps/cli/film_options.h"
#include "apps/cli/film_output.h"
#include "apps/cli/picture_options.h"
#include "core/layers/layer_count.h"
#include "core/model/apply.h"
#include "io/file.h"
#include "io/fold_history.h"
#include "io/fold_writer.h"
#include "io/kiri_writer.h"
#include "render/canvas/png.h"
#include "render/canvas/rasterise.h"
#include "render/canvas/write.h"
#include "render/scene/model_scene.h"
#include "render/scene/pattern_scene.h"
#include "render/scene/sheet_scene.h"

namespace kiri::cli {

namespace {

constexpr double kHalf = 0.5;
/// How a model that is half open is looked at.
constexpr double kFromTheSide = 20;
constexpr double kFromAbove = 40;

std::string folderNameOf(const ModelInput& input) {
  return std::filesystem::path(input.name).stem().string();
}

/// The number of steps after which most layers lie on each other; of equals the last.
std::size_t mostFolded(const Replay& replay) {
  std::size_t best = 0;
  std::uint32_t layers = 0;
  for (std::size_t i = 0; i < replay.outcomes.size(); ++i) {
    const std::uint32_t here = maxLayerCount(*replay.outcomes[i].state);
    if (here >= layers) best = i + 1;
    layers = std::max(layers, here);
  }
  return best;
}

const FoldedState& stateOf(const Replay& replay, std::size_t steps) {
  return steps == 0 ? *replay.start : *replay.outcomes[steps - 1].state;
}

/// Half way to the unfolded sheet; none where nothing is folded or the paper would have to bend.
std::optional<FoldedState> halfUnfolded(const FoldedState& folded, Sequence opening, int number) {
  for (const Sequence sequence : {opening, Sequence::InOrder}) {
    Movements movements;
    const Step unfold{UnfoldStep{{}, sequence}, "", "", ""};
    const Result<FoldedState> flat = apply(folded, unfold, number, &movements);
    if (flat && !movements.empty()) return stateAlong(movements, kHalf);
  }
  return std::nullopt;
}

/// Writes into one folder; the first error stays.
class EntryWriter {
 public:
  EntryWriter(Console& console, const ModelInput& input, const GalleryOptions& options,
              GalleryEntryFiles& entry)
      : console_(console), input_(input), options_(options), entry_(entry) {}

  Status write(const Replay& replay, const Appearance& appearance);

 private:
  Status file(const std::string& name, const std::string& bytes) {
    return writeFile(options_.out + "/" + entry_.folder + "/" + name, bytes);
  }
  Status picture(const Result<Scene>& scene, const std::string& label, const std::string& name);
  Status views(const Replay& replay, const Appearance& appearance);
  Status drawings(const Replay& replay, const Appearance& appearance);
  Status models(const Replay& replay);
  Status film(const Appearance& appearance);

  Console& console_;
  const ModelInput& input_;
  const GalleryOptions& options_;
  GalleryEntryFiles& entry_;
};

Status EntryWriter::picture(const Result<Scene>& scene, const std::string& label,
                            const std::string& name) {
  if (!scene) return scene.error();
  const Result<Image> image = rasterise(*scene, options_.pixels, options_.pixels);
  if (!image) return image.error();
  const Result<std::string> png = encodePng(*image, 0);
  if (!png) return png.error();
  entry_.pictures.push_back({label, name});
  return file(name, *png);
}

Status EntryWriter::views(const Replay& replay, const Appearance& appearance) {
  const std::size_t count = replay.outcomes.size();
  const std::size_t most = mostFolded(replay);
  const FoldedState& last = stateOf(replay, count);
  const FoldedState& folded = stateOf(replay, most);
  Status status = picture(modelScene(last, appearance, frontSpec()), "finished", "finished.png");
  if (status) status = picture(modelScene(folded, appearance, frontSpec()), "folded", "folded.png");
  const auto half = halfUnfolded(folded, input_.model.opening, static_cast<int>(most) + 1);
  if (status && half) {
    ViewSpec aslant{kFromTheSide, kFromAbove};
    aslant.isShaded = true;
    status = picture(modelScene(*half, appearance, aslant), "half unfolded", "half.png");
  }
  if (status) status = picture(patternScene(last, appearance), "unfolded", "unfolded.png");
  return status;
}

Status EntryWriter::drawings(const Replay& replay, const Appearance& appearance) {
  const FoldedState& folded = stateOf(replay, mostFolded(replay));
  PatternSceneOptions lines;
  lines.fill = PatternFill::None;
  const Result<std::string> pattern = writeSvg(patternScene(folded, appearance, lines));
  if (!pattern) return pattern.error();
  entry_.downloads.push_back({"crease pattern (SVG)", "pattern.svg"});
  Status status = file("pattern.svg", *pattern);
  if (!status) return status;
  const Result<Scene> sheet = sheetScene(input_.model, replay, appearance);
  if (!sheet) return sheet.error();
  const Result<std::string> svg = writeSvg(*sheet);
  if (!svg) return svg.error();
  entry_.downloads.push_back({"step sheet (SVG)", "steps.svg"});
  return file("steps.svg", *svg);
}

Status EntryWriter::models(const Replay& replay) {
  const std::string base = entry_.folder;
  entry_.downloads.push_back({"model (.kiri)", base + ".kiri"});
  Status status = file(base + ".kiri", writeKiri(input_.model));
  if (!status) return status;
  std::vector<std::shared_ptr<const FoldedState>> after;
  for (const StepOutcome& outcome : replay.outcomes) after.push_back(outcome.state);
  const FoldOptions fold{"KiriSim " KIRI_VERSION, entry_.title, entry_.notes};
  const FoldedState& last = stateOf(replay, replay.outcomes.size());
  entry_.downloads.push_back({"FOLD", base + ".fold"});
  return file(base + ".fold",
              writeFold(last, foldHistoryOf(input_.model, after, nullptr), fold).text);
}

Status EntryWriter::film(const Appearance& appearance) {
  const std::string name = "motion.webp";
  FilmOutput output{options_.out + "/" + entry_.folder + "/" + name, "webp", options_.pixels,
                    options_.pixels, options_.framesPerSecond};
  TimelineOptions time;
  time.degreesPerSecond = 2 * time.degreesPerSecond;
  const Result<Timeline> timeline = Timeline::of(input_.model, time);
  if (!timeline) return timeline.error();
  FilmOptions options;
  options.width = options.height = options_.pixels;
  options.framesPerSecond = options_.framesPerSecond;
  options.view = {0, kFromAbove + kFromTheSide};
  options.view.isShaded = true;
  const Result<Film> film = Film::of(*timeline, appearance, options);
  if (!film) return film.error();
  if (writeFilm(console_, *film, output) != kDone) {
    return Error{isCancelled(console_) ? ErrorCode::Cancelled : ErrorCode::Unwritable,
                 entry_.folder + ": the film could not be made; --no-animations leaves films out"};
  }
  entry_.pictures.push_back({"in motion", name});
  return std::monostate{};
}

Status EntryWriter::write(const Replay& replay, const Appearance& appearance) {
  std::error_code error;
  std::filesystem::create_directories(options_.out + "/" + entry_.folder, error);
  if (error) {
    return Error{ErrorCode::Unwritable,
                 options_.out + "/" + entry_.folder + ": " + error.message()};
  }
  Status status = views(replay, appearance);
  if (status) status = drawings(replay, appearance);
  if (status) status = models(replay);
  if (status && options_.hasAnimations) status = film(appearance);
  return status;
}

}  // namespace

Result<GalleryEntryFiles> writeGalleryEntry(Console& console, const ModelInput& input,
                                            const GalleryOptions& options) {
  GalleryEntryFiles entry;
  entry.folder = folderNameOf(input);
  entry.title = titleOf(input);
  entry.notes = input.model.notes;
  for (const Step& step : input.model.steps) entry.steps.emplace_back(step.title, step.notes);
  const Result<Replay> replayed = replay(input.model);
  if (!replayed) return replayed.error();
  const auto last = stateAfter(console, input, *replayed, input.model.steps.size());
  if (!last) return last.error();
  const Result<Appearance> appearance = appearanceFor(console, input, {});
  if (!appearance) return appearance.error();
  const Status status = EntryWriter(console, input, options, entry).write(*replayed, *appearance);
  if (!status) return status.error();
  return entry;
}

}  // namespace kiri::cli
