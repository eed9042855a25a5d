// Lists of panel numbers as people write them: "first,2,4-7,last".
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace kiri::cli {

/// The numbers from 0 to `last` that `text` lists, in its order. "first" is 0, "last" and "all" are
/// what they say. Errors: BadValue - with the part that cannot be understood or is out of range.
Result<std::vector<std::size_t>> parseNumberList(const std::string& text, std::size_t last);

}  // namespace kiri::cli
