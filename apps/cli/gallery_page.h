// The gallery as static HTML.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/cli/gallery_entry.h"

namespace kiri::cli {

/// The page of all models: thumbnails, titles, and links to their pages.
std::string galleryIndex(const std::vector<GalleryEntryFiles>& entries);

/// The page of one model, for its own folder: pictures, steps in words, downloads.
std::string galleryPage(const GalleryEntryFiles& entry);

}  // namespace kiri::cli
