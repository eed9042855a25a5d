// The pictures and files that the gallery shows of one model.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/model_input.h"

namespace kiri::cli {

/// A file of an entry, by its name in the entry's folder.
struct GalleryFile {
  std::string label;  ///< for people
  std::string name;
};

/// One model in the gallery.
struct GalleryEntryFiles {
  std::string folder;  ///< below the gallery's
  std::string title;
  std::string notes;
  std::vector<std::pair<std::string, std::string>> steps;  ///< title and notes
  std::vector<GalleryFile> pictures;                       ///< the first is the thumbnail
  std::vector<GalleryFile> downloads;
};

struct GalleryOptions {
  std::string out;
  int pixels = 400;           ///< side of a picture
  bool hasAnimations = true;  ///< needs ffmpeg
  double framesPerSecond = 12;
};

/// Writes the pictures and files of a model into OUT/FOLDER: the finished model, folded, half
/// unfolded and unfolded, the crease pattern, the step sheet, a film, the model and FOLD. Errors:
/// the first step that does not apply, naming the file; Unwritable; Cancelled.
Result<GalleryEntryFiles> writeGalleryEntry(Console& console, const ModelInput& input,
                                            const GalleryOptions& options);

}  // namespace kiri::cli
