// Which models a gallery shows, in which groups and order.
// SPDX-License-Identifier: MIT
#include "apps/cli/gallery_plan.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include "io/file.h"
#include "io/gallery.h"

namespace kiri::cli {

namespace {

namespace fs = std::filesystem;

constexpr const char* kUsualTitle = "KiriSim gallery";

/// Adds the groups of a gallery's file.
Status addGallery(Console& console, const std::string& path, GalleryPlan& plan) {
  const Result<std::string> text = readFile(path);
  if (!text) return text.error();
  const Result<Gallery> gallery = readGallery(*text, path);
  if (!gallery) return gallery.error();
  for (const std::string& warning : gallery->warnings) warn(console, warning);
  if (gallery->groups.empty()) return Error{ErrorCode::NotFound, path + ": it names no models"};
  if (plan.title.empty()) plan.title = gallery->title;
  const fs::path folder = fs::path(path).parent_path();
  for (const GalleryGroup& group : gallery->groups) {
    GalleryPlanGroup planned{group.title, group.notes, {}};
    for (const std::string& name : group.models) planned.files.push_back((folder / name).string());
    plan.groups.push_back(std::move(planned));
  }
  return std::monostate{};
}

Status addFolder(Console& console, const std::string& path, GalleryPlan& plan) {
  std::error_code error;
  const fs::path gallery = fs::path(path) / kGalleryFile;
  if (fs::exists(gallery, error)) return addGallery(console, gallery.string(), plan);
  GalleryPlanGroup group;
  fs::directory_iterator files(path, error);
  if (error) return Error{ErrorCode::BadFile, path + ": " + error.message()};
  for (const fs::directory_entry& file : files) {
    if (file.path().extension() == ".kiri") group.files.push_back(file.path().string());
  }
  if (group.files.empty()) {
    return Error{ErrorCode::NotFound,
                 path + ": the folder holds neither " + kGalleryFile + " nor .kiri files"};
  }
  std::sort(group.files.begin(), group.files.end());
  plan.groups.push_back(std::move(group));
  return std::monostate{};
}

/// Models that are named one by one stand together.
void addModel(const std::string& path, GalleryPlan& plan, bool& isAfterModel) {
  if (!isAfterModel) plan.groups.emplace_back();
  plan.groups.back().files.push_back(path);
  isAfterModel = true;
}

Status checkNames(const GalleryPlan& plan) {
  std::map<std::string, std::string> files;
  for (const GalleryPlanGroup& group : plan.groups) {
    for (const std::string& file : group.files) {
      const std::string folder = galleryFolderOf(file);
      const auto [old, isNew] = files.emplace(folder, file);
      if (isNew) continue;
      std::string sentence = "two models are named " + folder;
      sentence.append(" (").append(old->second).append(" and ").append(file);
      sentence += "), and each gets a folder of its name; rename one";
      return Error{ErrorCode::BadValue, sentence};
    }
  }
  return std::monostate{};
}

}  // namespace

std::string galleryFolderOf(const std::string& file) { return fs::path(file).stem().string(); }

Result<GalleryPlan> galleryPlanOf(Console& console, const std::vector<std::string>& arguments,
                                  const std::string& examples) {
  std::vector<std::string> wanted = arguments;
  if (wanted.empty() && examples.empty()) {
    return Error{ErrorCode::NotFound,
                 "the examples are not found; name models or a folder of them, or say in "
                 "KIRI_EXAMPLES where the examples are"};
  }
  if (wanted.empty()) wanted.push_back(examples);
  GalleryPlan plan;
  bool isAfterModel = false;
  for (const std::string& path : wanted) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
      isAfterModel = false;
      if (const Status added = addFolder(console, path, plan); !added) return added.error();
    } else if (fs::path(path).extension() == ".json") {
      isAfterModel = false;
      if (const Status added = addGallery(console, path, plan); !added) return added.error();
    } else {
      addModel(path, plan, isAfterModel);
    }
  }
  if (const Status checked = checkNames(plan); !checked) return checked.error();
  if (plan.title.empty()) plan.title = kUsualTitle;
  return plan;
}

}  // namespace kiri::cli
