// Whole files in and out.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <istream>
#include <string>

#include "core/base/result.h"

namespace kiri {

/// The most bytes that are read from one file or stream.
inline constexpr std::size_t kLargestFile = std::size_t{256} << 20;

/// The bytes of a file. Errors: BadFile - it is not there, is a folder, may not be read, or is
/// larger than `limit`.
Result<std::string> readFile(const std::string& path, std::size_t limit = kLargestFile);

/// What is left in a stream; `name` is used in sentences. Errors: BadFile - more than `limit`
/// bytes, or reading fails.
Result<std::string> readStream(std::istream& in, const std::string& name,
                               std::size_t limit = kLargestFile);

/// Puts `bytes` into the file: written under a temporary name beside it, synced, and renamed, so
/// that the file is whole at every moment. What is no ordinary file (a pipe, a device) is written
/// to directly. Errors: Unwritable - with the reason; an existing file is unchanged then.
Status writeFile(const std::string& path, const std::string& bytes);

}  // namespace kiri
