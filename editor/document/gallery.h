// A folder of models to choose from, such as the examples.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "render/scene/image.h"

namespace kiri {

struct GalleryEntry {
  std::string file;
  std::string title;  ///< of the model; without one the name of its file
  std::string notes;
  std::size_t steps = 0;
  std::optional<Error> error;  ///< why the file cannot be read
};

/// The .kiri files of a folder, by title; those that cannot be read come last. Nothing for a folder
/// that is not there. Nothing is folded yet.
std::vector<GalleryEntry> galleryOf(const std::string& folder);

/// Reads the model, folds it, and shows its last state that can be reached; see thumbnailOf. May
/// take long. Errors: BadFile; BadValue; Cancelled.
Result<Image> galleryPicture(const GalleryEntry& entry, int pixels, const Progress& progress = {});

}  // namespace kiri
