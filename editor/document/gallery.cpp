// SPDX-License-Identifier: MIT
#include "editor/document/gallery.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include "core/model/history.h"
#include "editor/document/thumbnails.h"
#include "io/file.h"
#include "io/kiri_reader.h"

namespace kiri {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModelEnding = ".kiri";
/// A model's notes begin with its figure and a colon; whatever is longer is no name of a figure.
constexpr std::size_t kLongestFigure = 40;

Result<Model> modelIn(const std::string& file) {
  const Result<std::string> text = readFile(file);
  if (!text) return text.error();
  Result<LoadedModel> loaded = readKiri(*text, file);
  if (!loaded) return loaded.error();
  return std::move(loaded->model);
}

std::set<std::string> modelsIn(const std::string& folder) {
  std::set<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& file : fs::directory_iterator(folder, error)) {
    if (file.path().extension() == kModelEnding) names.insert(file.path().filename().string());
  }
  return names;
}

Gallery groupsIn(const fs::path& folder) {
  const fs::path file = folder / kGalleryFile;
  std::error_code error;
  if (!fs::exists(file, error)) return {};
  const Result<std::string> text = readFile(file.string());
  if (!text) return {"", {}, {text.error().message}};
  Result<Gallery> read = readGallery(*text, file.string());
  if (!read) return {"", {}, {read.error().message}};
  return std::move(*read);
}

std::string figureIn(const std::string& notes) {
  const std::size_t colon = notes.find(':');
  if (colon > kLongestFigure) return "";  // npos too
  std::string start = notes.substr(0, colon);
  return start.find("Figure ") == std::string::npos ? "" : start;
}

}  // namespace

Gallery galleryIn(const std::string& folder) {
  std::set<std::string> rest = modelsIn(folder);
  if (rest.empty()) return {};
  Gallery gallery = groupsIn(folder);
  for (GalleryGroup& group : gallery.groups) {
    std::vector<std::string> there;
    for (std::string& name : group.models) {
      if (rest.erase(name) > 0) there.push_back(std::move(name));
    }
    group.models = std::move(there);
  }
  if (!rest.empty()) gallery.groups.push_back({"", "", {rest.begin(), rest.end()}});
  const auto isEmpty = [](const GalleryGroup& group) { return group.models.empty(); };
  gallery.groups.erase(std::remove_if(gallery.groups.begin(), gallery.groups.end(), isEmpty),
                       gallery.groups.end());
  return gallery;
}

Result<ModelWords> wordsOf(const std::string& file) {
  const Result<Model> model = modelIn(file);
  if (!model) return model.error();
  ModelWords words;
  words.title = model->title.empty() ? fs::path(file).stem().string() : model->title;
  words.figure = figureIn(model->notes);
  words.notes = model->notes;
  words.steps = model->steps.size();
  return words;
}

Result<Image> galleryPicture(const std::string& file, int pixels, const Progress& progress) {
  const Result<Model> model = modelIn(file);
  if (!model) return model.error();
  const Result<History> history = History::open(*model, progress);
  if (!history) return history.error();
  return thumbnailOf(history->state(), *model, pixels, progress);
}

}  // namespace kiri
