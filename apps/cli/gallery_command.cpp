// kiri gallery: a page of models with pictures, films, step sheets and downloads.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "apps/cli/commands.h"
#include "apps/cli/gallery_entry.h"
#include "apps/cli/gallery_page.h"
#include "io/file.h"

namespace kiri::cli {

namespace {

namespace fs = std::filesystem;

struct GalleryCommandOptions {
  std::vector<std::string> models;
  GalleryOptions gallery;
  bool hasNoAnimations = false;
};

/// The model files named, folders replaced by the models in them, by name.
Result<std::vector<std::string>> modelFiles(const std::vector<std::string>& named) {
  std::vector<std::string> files;
  for (const std::string& name : named) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      files.push_back(name);
      continue;
    }
    std::vector<std::string> inFolder;
    for (const fs::directory_entry& file : fs::directory_iterator(name, error)) {
      if (file.path().extension() == ".kiri") inFolder.push_back(file.path().string());
    }
    if (inFolder.empty()) {
      return Error{ErrorCode::NotFound, name + ": the folder holds no .kiri files"};
    }
    std::sort(inFolder.begin(), inFolder.end());
    files.insert(files.end(), inFolder.begin(), inFolder.end());
  }
  std::vector<std::string> stems;
  for (const std::string& file : files) stems.push_back(fs::path(file).stem().string());
  std::sort(stems.begin(), stems.end());
  const auto twice = std::adjacent_find(stems.begin(), stems.end());
  if (twice == stems.end()) return files;
  return Error{ErrorCode::BadValue, "two models are named " + *twice +
                                        ", and each gets a folder of its name; rename one"};
}

Status writePages(const std::vector<GalleryEntryFiles>& entries, const std::string& out) {
  for (const GalleryEntryFiles& entry : entries) {
    Status status = writeFile(out + "/" + entry.folder + "/index.html", galleryPage(entry));
    if (!status) return status;
  }
  return writeFile(out + "/index.html", galleryIndex(entries));
}

int run(Console& console, GalleryCommandOptions options) {
  options.gallery.hasAnimations = !options.hasNoAnimations;
  const Result<std::vector<std::string>> files = modelFiles(options.models);
  if (!files) return fail(console, files.error(), kBadUsage);
  std::vector<GalleryEntryFiles> entries;
  ProgressLine line(console, "gallery");
  for (std::size_t i = 0; i < files->size(); ++i) {
    if (!line.update(static_cast<double>(i) / static_cast<double>(files->size()))) {
      return fail(console, Error{ErrorCode::Cancelled, "", {}});
    }
    const Result<ModelInput> input = loadModel(console, (*files)[i]);
    if (!input) return fail(console, input.error());
    Result<GalleryEntryFiles> entry = writeGalleryEntry(console, *input, options.gallery);
    if (!entry) return fail(console, entry.error());
    entries.push_back(std::move(*entry));
  }
  const Status status = writePages(entries, options.gallery.out);
  if (!status) return fail(console, status.error());
  return kDone;
}

}  // namespace

void addGalleryCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command =
      app.add_subcommand("gallery", "Make a page of models with pictures, films and downloads");
  const auto options = std::make_shared<GalleryCommandOptions>();
  command->add_option("MODELS", options->models, ".kiri files, or folders of them")->required();
  command->add_option("-o,--output", options->gallery.out, "folder to write into")
      ->type_name("DIR")
      ->required();
  command->add_flag("--no-animations", options->hasNoAnimations,
                    "leave out the films, which need ffmpeg");
  command->footer(
      "Writes DIR/index.html and a folder for each model. The pages need no server.\n\n"
      "Examples:\n"
      "  kiri gallery examples -o gallery\n"
      "  kiri gallery leaf.kiri ship.kiri -o gallery --no-animations");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
