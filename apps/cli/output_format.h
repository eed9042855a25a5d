// Which kind of file a command writes: by --format, else by the ending of the name.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace kiri::cli {

/// What follows the last dot of a file's name, in small letters; empty without one.
std::string endingOf(const std::string& path);

/// One of `known` ("svg", "png"...). Errors: BadValue - an ending that is none of them, or standard
/// output without --format; the sentence lists what there is.
Result<std::string> chooseFormat(const std::string& path, const std::string& format,
                                 const std::vector<std::string>& known);

}  // namespace kiri::cli
