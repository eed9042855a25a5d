// The gallery as static HTML: no scripts, nothing from elsewhere, light and dark.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/cli/gallery_entry.h"

namespace kiri::cli {

struct GalleryPageGroup {
  std::string title;  ///< empty: nothing stands above it
  std::string notes;
  std::vector<GalleryEntryFiles> entries;
};

struct GalleryPages {
  std::string title;
  std::vector<GalleryPageGroup> groups;
};

/// The page of all models: thumbnails under the headings of their groups, and links to the models.
std::string galleryIndex(const GalleryPages& pages);

/// The page of one model, for its own folder: pictures, steps in words, downloads, and links to its
/// neighbours in the gallery. `group` and `entry` count from 0.
std::string galleryPage(const GalleryPages& pages, std::size_t group, std::size_t entry);

}  // namespace kiri::cli
