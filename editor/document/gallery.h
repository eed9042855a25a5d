// A folder of models to choose from, such as the examples.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "io/gallery.h"
#include "render/scene/image.h"

namespace kiri {

/// The models of a folder in the groups of its gallery.json, those that are there. What it does not
/// name comes last, by name, in a group without a title; so does everything where there is no
/// gallery.json, or none that can be read: then a warning says why. Nothing for a folder that is
/// not there. No model is read.
Gallery galleryIn(const std::string& folder);

/// What is said of a model before it is opened.
struct ModelWords {
  std::string title;   ///< of the model; without one the name of its file
  std::string figure;  ///< "Figure 7.13", "Like Figure 7.17": with which its notes begin; or empty
  std::string notes;
  std::size_t steps = 0;
};

/// Reads the file; nothing is folded. Errors: NotFound, Unreadable, BadFile.
Result<ModelWords> wordsOf(const std::string& file);

/// Reads the model, folds it, and shows its last state that can be reached; see thumbnailOf. May
/// take long. Errors: those of wordsOf; BadValue; Cancelled.
Result<Image> galleryPicture(const std::string& file, int pixels, const Progress& progress = {});

}  // namespace kiri
