// The pictures and files that the gallery shows of one model.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/model_input.h"
#include "core/base/result.h"

namespace kiri::cli {

/// A file to take away, by its name in the entry's folder.
struct GalleryFile {
  std::string label;  ///< for people
  std::string name;
  std::size_t bytes = 0;
};

/// A picture on a page, by its name in the entry's folder.
struct GalleryPicture {
  std::string label;  ///< what it shows, "half unfolded"
  std::string name;
  int width = 0;  ///< pixels
  int height = 0;
};

struct GalleryMeasure {
  std::string words;
  std::string value;  ///< with its unit
};

/// One model in the gallery.
struct GalleryEntryFiles {
  std::string folder;  ///< below the gallery's
  std::string title;
  std::string notes;
  std::vector<std::pair<std::string, std::string>> steps;  ///< title and notes
  std::vector<GalleryPicture> pictures;                    ///< the first is the finished model
  std::size_t emblem = 0;                                  ///< which picture stands for the model
  GalleryPicture thumbnail;                                ///< the same, small
  std::string remark;   ///< a sentence about what no picture shows; may be empty
  GalleryPicture film;  ///< without a name: none was made
  GalleryPicture stepSheet;
  std::vector<GalleryMeasure> measures;  ///< of leaves
  std::vector<GalleryMeasure> margin;    ///< of leaves: lobes and sinuses
  GalleryPicture measured;               ///< of leaves
  std::vector<GalleryFile> downloads;
};

struct GalleryOptions {
  std::string out;
  int pixels = 480;  ///< side of a picture
  int thumbnailPixels = 240;
  bool hasAnimations = true;  ///< needs ffmpeg
  int filmPixels = 400;
  double framesPerSecond = 12;
};

/// Writes the pictures and files of a model into OUT/FOLDER: the finished model from both sides,
/// folded, half unfolded and unfolded, the crease pattern, the step sheet, a film, of a leaf its
/// measures, the model in other formats. Every file is whole at every moment. Errors: the first
/// step that does not apply, naming the file; Unwritable; Cancelled.
Result<GalleryEntryFiles> writeGalleryEntry(Console& console, const ModelInput& input,
                                            const GalleryOptions& options);

}  // namespace kiri::cli
