// Which models a gallery shows, in which groups and order.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "core/base/result.h"

namespace kiri::cli {

struct GalleryPlanGroup {
  std::string title;  ///< empty: nothing stands above it
  std::string notes;
  std::vector<std::string> files;  ///< paths of models
};

struct GalleryPlan {
  std::string title;
  std::vector<GalleryPlanGroup> groups;
};

/// What the arguments of kiri gallery mean: a gallery's file, a folder (by its gallery.json;
/// without one all its .kiri files by name), a model. None: the examples in `examples`. Prints what
/// looks odd in a gallery. Errors: NotFound - no folder of examples, a folder without models;
/// BadValue - two models of one name; BadFile - a gallery that cannot be read.
Result<GalleryPlan> galleryPlanOf(Console& console, const std::vector<std::string>& arguments,
                                  const std::string& examples);

/// The name of a model's folder in the gallery: that of its file without folder and ending.
std::string galleryFolderOf(const std::string& file);

}  // namespace kiri::cli
