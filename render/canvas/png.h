// PNG images from and to bytes.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/base/result.h"
#include "render/scene/image.h"

namespace kiri {

/// The pixels of a PNG file. Errors: BadFile - not a PNG, damaged, or more than 16384 pixels wide
/// or high.
Result<Image> decodePng(const std::string& bytes);

/// A PNG file of the image; `dpi` is noted when above zero.
Result<std::string> encodePng(const Image& image, double dpi);

}  // namespace kiri
