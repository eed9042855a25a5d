// A gallery: which models are shown, in which groups and order (docs/formats/gallery.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace kiri {

/// The newest version of the format that is understood.
inline constexpr int kGalleryVersion = 1;
/// What a folder's gallery is called.
inline constexpr const char* kGalleryFile = "gallery.json";

struct GalleryGroup {
  std::string title;
  std::string notes;                ///< a sentence about the group; may be empty
  std::vector<std::string> models;  ///< names of .kiri files beside the gallery's file
};

struct Gallery {
  std::string title;
  std::vector<GalleryGroup> groups;   ///< those that hold a model
  std::vector<std::string> warnings;  ///< sentences, such as a field name with a typing error
};

/// The gallery that `text` describes; `fileName` is used in sentences only. Whether the models are
/// there is not looked at. Errors: BadFile - with file, line and column, the field, and what to
/// write instead: another format, a model that stands there twice, a name with a path.
Result<Gallery> readGallery(std::string_view text, std::string_view fileName);

}  // namespace kiri
