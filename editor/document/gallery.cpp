// SPDX-License-Identifier: MIT
#include "editor/document/gallery.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <tuple>

#include "core/model/history.h"
#include "editor/document/thumbnails.h"
#include "io/file.h"
#include "io/kiri_reader.h"

namespace kiri {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModelEnding = ".kiri";

Result<Model> modelIn(const std::string& file) {
  const Result<std::string> text = readFile(file);
  if (!text) return text.error();
  Result<LoadedModel> loaded = readKiri(*text, file);
  if (!loaded) return loaded.error();
  return std::move(loaded->model);
}

GalleryEntry entryOf(const fs::path& path) {
  GalleryEntry entry;
  entry.file = path.string();
  entry.title = path.stem().string();
  const Result<Model> model = modelIn(entry.file);
  if (!model) {
    entry.error = model.error();
    return entry;
  }
  if (!model->title.empty()) entry.title = model->title;
  entry.notes = model->notes;
  entry.steps = model->steps.size();
  return entry;
}

}  // namespace

std::vector<GalleryEntry> galleryOf(const std::string& folder) {
  std::vector<GalleryEntry> entries;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    if (file.path().extension() == kModelEnding) entries.push_back(entryOf(file.path()));
  }
  std::sort(entries.begin(), entries.end(), [](const GalleryEntry& a, const GalleryEntry& b) {
    const bool isBad = a.error.has_value();
    const bool isOtherBad = b.error.has_value();
    return std::tie(isBad, a.title, a.file) < std::tie(isOtherBad, b.title, b.file);
  });
  return entries;
}

Result<Image> galleryPicture(const GalleryEntry& entry, int pixels, const Progress& progress) {
  const Result<Model> model = modelIn(entry.file);
  if (!model) return model.error();
  const Result<History> history = History::open(*model, progress);
  if (!history) return history.error();
  return thumbnailOf(history->state(), *model, pixels, progress);
}

}  // namespace kiri
