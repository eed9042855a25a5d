// Bytes as text, for images inside SVG.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace kiri {

std::string base64(const std::string& bytes);

}  // namespace kiri
