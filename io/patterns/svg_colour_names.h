// The names of colours in CSS.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace kiri {

/// 0xRRGGBB of a name in lower case; none when CSS has no such colour.
std::optional<std::uint32_t> namedColour(std::string_view name);

}  // namespace kiri
