// The pictures and files that the gallery shows of one model.
// SPDX-License-Identifier: MIT
#include "apps/cli/gallery_entry.h"

#include <cmath>
#include <filesystem>
#include <utility>

#include "apps/cli/export_formats.h"
#include "apps/cli/film_options.h"
#include "apps/cli/film_output.h"
#include "apps/cli/gallery_leaf.h"
#include "apps/cli/gallery_plan.h"
#include "apps/cli/gallery_scenes.h"
#include "apps/cli/picture_options.h"
#include "apps/cli/timeline_replay.h"
#include "core/model/moments.h"
#include "io/file.h"
#include "io/fold_history.h"
#include "io/gltf_animation.h"
#include "io/kiri_writer.h"
#include "render/canvas/png.h"
#include "render/canvas/rasterise.h"
#include "render/canvas/write.h"
#include "render/scene/next_line.h"
#include "render/scene/sheet_scene.h"

namespace kiri::cli {

namespace {

/// From where the film is taken.
constexpr double kFilmElevation = 60;
/// Twice as fast as films are by themselves: who leafs through a gallery has little time.
constexpr double kFilmSpeed = 240;

/// What is downloaded to be looked at may be a little coarser than what is exported: 0.02 mm on a
/// sheet of 20 cm, and in motion 0.2 mm.
constexpr double kCurveError = 0.0001;
constexpr double kMotionError = 0.001;
constexpr int kDecimals = 6;

/// A drawing in its true size on a screen.
GalleryPicture pictureOf(const Scene& scene, const std::string& label, const std::string& name) {
  constexpr double kPixelsPerMm = 96 / 25.4;
  return {label, name, static_cast<int>(std::round(scene.width * kPixelsPerMm)),
          static_cast<int>(std::round(scene.height * kPixelsPerMm))};
}

/// Writes into one folder; the first error stays.
class EntryWriter {
 public:
  EntryWriter(Console& console, const ModelInput& input, const GalleryOptions& options,
              GalleryEntryFiles& entry)
      : console_(console), input_(input), options_(options), entry_(entry) {}

  Status write(const Timeline& timeline, const Appearance& appearance);

 private:
  Status file(const std::string& name, const std::string& bytes) {
    if (isCancelled(console_)) return Error{ErrorCode::Cancelled, "", {}};
    return writeFile(options_.out + "/" + entry_.folder + "/" + name, bytes);
  }
  Status download(const std::string& label, const std::string& name, const std::string& bytes) {
    entry_.downloads.push_back({label, name, bytes.size()});
    return file(name, bytes);
  }
  Status download(const std::string& label, const std::string& name,
                  const Result<std::string>& bytes) {
    return bytes ? download(label, name, *bytes) : Status(bytes.error());
  }
  Result<GalleryPicture> picture(const Scene& scene, const std::string& label,
                                 const std::string& name, int pixels);
  Status pictures(const Timeline& timeline, const Moments& moments, const Appearance& appearance);
  Status stepSheet(const Timeline& timeline, const Appearance& appearance);
  Status leaf(const Timeline& timeline, const Moments& moments, const Appearance& appearance);
  /// The model with its textures beside it, whose paths become those of the copies.
  Result<Model> withTextures();
  Status texture(PaperSide& side, const std::string& name);
  Status models(const Timeline& timeline, const Moments& moments, const Appearance& appearance);
  std::string fold(const Timeline& timeline, const Moments& moments) const;
  Status film(const Timeline& timeline, const Appearance& appearance);
  std::size_t steps() const { return input_.model.steps.size(); }
  Progress progress() {
    return [this](double) { return !isCancelled(console_); };
  }

  Console& console_;
  const ModelInput& input_;
  const GalleryOptions& options_;
  GalleryEntryFiles& entry_;
};

Result<GalleryPicture> EntryWriter::picture(const Scene& scene, const std::string& label,
                                            const std::string& name, int pixels) {
  const Result<Image> image = rasterise(scene, pixels, pixels);
  if (!image) return image.error();
  const Result<std::string> png = encodePng(*image, 0);
  if (!png) return png.error();
  const Status written = file(name, *png);
  if (!written) return written.error();
  return GalleryPicture{label, name, pixels, pixels};
}

Status EntryWriter::pictures(const Timeline& timeline, const Moments& moments,
                             const Appearance& appearance) {
  const auto scenes = galleryScenesOf(timeline, steps(), moments, appearance, progress());
  if (!scenes) return scenes.error();
  for (const GalleryScene& scene : *scenes) {
    Result<GalleryPicture> shown =
        picture(scene.scene, scene.label, scene.file + ".png", options_.pixels);
    if (!shown) return shown.error();
    entry_.pictures.push_back(std::move(*shown));
  }
  entry_.emblem = galleryEmblemOf(*scenes, input_.model, moments);
  const Result<GalleryPicture> small =
      picture((*scenes)[entry_.emblem].scene, "", "thumbnail.png", options_.thumbnailPixels);
  if (!small) return small.error();
  entry_.thumbnail = *small;
  entry_.remark = halfWayRemark(moments.halfWay);
  return std::monostate{};
}

Status EntryWriter::stepSheet(const Timeline& timeline, const Appearance& appearance) {
  const Result<Scene> sheet = sheetScene(input_.model, replayOf(timeline, steps()), appearance);
  if (!sheet) return sheet.error();
  entry_.stepSheet = pictureOf(*sheet, "the steps", "steps.svg");
  Status status = download("step sheet to print (PDF)", "steps.pdf", writePdf(*sheet));
  if (status) status = download("step sheet (SVG)", "steps.svg", writeSvg(*sheet));
  return status;
}

Status EntryWriter::leaf(const Timeline& timeline, const Moments& moments,
                         const Appearance& appearance) {
  const auto measures =
      galleryLeafOf(input_.model, timeline.stateAfter(steps()), moments.isOpenAtTheEnd);
  if (!measures) return std::monostate{};
  entry_.measures = galleryMeasuresOf(*measures);
  entry_.margin = galleryMarginOf(*measures);
  const Scene scene = galleryMeasureScene(timeline.stateAfter(steps()), *measures, appearance);
  entry_.measured = pictureOf(scene, "measured: axis, lobes and sinuses", "measured.svg");
  return download("measures drawn in (SVG)", "measured.svg", writeSvg(scene));
}

Result<Model> EntryWriter::withTextures() {
  Model model = input_.model;
  Status status = texture(model.front, "paper-front.png");
  if (status) status = texture(model.back, "paper-back.png");
  if (!status) return status.error();
  return model;
}

Status EntryWriter::texture(PaperSide& side, const std::string& name) {
  if (side.texture.empty()) return std::monostate{};
  const Result<std::string> bytes = readFile(texturePath(input_, side.texture));
  if (!bytes) return std::monostate{};  // appearanceFor has warned of it
  side.texture = name;
  return download("paper of the model (PNG)", name, *bytes);
}

std::string EntryWriter::fold(const Timeline& timeline, const Moments& moments) const {
  const Replay replay = replayOf(timeline, steps());
  std::vector<std::shared_ptr<const FoldedState>> after;
  for (const StepOutcome& outcome : replay.outcomes) after.push_back(outcome.state);
  const std::vector<FoldFrame> all = foldHistoryOf(input_.model, after);
  std::vector<FoldFrame> frames;
  if (moments.folded > 0) frames.push_back(all[moments.folded - 1]);
  if (moments.folded < steps() && !moments.isOpenAtTheEnd) frames.push_back(all.back());
  FoldOptions options{"KiriSim " KIRI_VERSION, entry_.title, entry_.notes};
  const FoldedState& folded = timeline.stateAfter(moments.folded);
  options.chordError = kCurveError * folded.tolerance().sheetSize();
  options.decimals = kDecimals;
  return writeFold(folded, frames, options).text;
}

Status EntryWriter::models(const Timeline& timeline, const Moments& moments,
                           const Appearance& appearance) {
  const std::string base = entry_.folder;
  const Result<Model> model = withTextures();
  if (!model) return model.error();
  Status status = download("the model, for KiriSim (.kiri)", base + ".kiri", writeKiri(*model));
  if (!status) return status;
  status = download("crease pattern and folded form, for other origami programs (.fold)",
                    base + ".fold", fold(timeline, moments));
  if (!status) return status;
  GltfOptions looks = gltfLooksOf(input_, appearance);
  looks.chordError = kCurveError * timeline.stateAfter(0).tolerance().sheetSize();
  looks.motionError = kMotionError;
  const Result<Exported> solid = writeAnimatedGlb(timeline, looks, progress());
  if (!solid) return solid.error();
  return download("in motion, in space, for 3D viewers (.glb)", base + ".glb", solid->text);
}

Status EntryWriter::film(const Timeline& timeline, const Appearance& appearance) {
  const std::string name = "motion.mp4";
  FilmOptions options;
  options.width = options.height = options_.filmPixels;
  options.framesPerSecond = options_.framesPerSecond;
  options.view = {0, kFilmElevation};
  options.view.isShaded = true;
  const Result<Film> film = Film::of(timeline, appearance, options, progress());
  if (!film) return film.error();
  const FilmOutput output{options_.out + "/" + entry_.folder + "/" + name,
                          "mp4",
                          options_.filmPixels,
                          options_.filmPixels,
                          options_.framesPerSecond,
                          true};
  entry_.film = {"film of all steps", name, options_.filmPixels, options_.filmPixels};
  return shootInto(*film, output, progress());
}

Status EntryWriter::write(const Timeline& timeline, const Appearance& appearance) {
  const std::string folder = options_.out + "/" + entry_.folder;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return Error{ErrorCode::Unwritable, folder + ": " + error.message()};
  const Moments moments = momentsOf(input_.model, timeline);
  Status status = pictures(timeline, moments, appearance);
  if (status) {
    status = download("crease pattern in true size (SVG)", "pattern.svg",
                      writeSvg(galleryPattern(timeline.stateAfter(moments.folded), appearance)));
  }
  if (status) status = stepSheet(timeline, appearance);
  if (status) status = leaf(timeline, moments, appearance);
  if (status) status = models(timeline, moments, appearance);
  if (status && options_.hasAnimations) status = film(timeline, appearance);
  return status;
}

}  // namespace

Result<GalleryEntryFiles> writeGalleryEntry(Console& console, const ModelInput& input,
                                            const GalleryOptions& options) {
  GalleryEntryFiles entry;
  entry.folder = galleryFolderOf(input.name);
  entry.title = titleOf(input);
  entry.notes = input.model.notes;
  for (const Step& step : input.model.steps) {
    entry.steps.emplace_back(step.title.empty() ? wordsFor(step) : step.title, step.notes);
  }
  TimelineOptions time;
  time.degreesPerSecond = kFilmSpeed;
  time.lastStep = input.model.steps.size();
  const Result<Timeline> timeline = timelineOf(console, input, time);
  if (!timeline) return timeline.error();
  const Result<Appearance> appearance = appearanceFor(console, input, {});
  if (!appearance) return appearance.error();
  const Status status = EntryWriter(console, input, options, entry).write(*timeline, *appearance);
  if (!status) return status.error();
  return entry;
}

}  // namespace kiri::cli
