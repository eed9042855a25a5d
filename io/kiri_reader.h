// Reading .kiri model files (docs/formats/kiri.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/model/model.h"

namespace kiri {

/// The newest version of the format that is understood.
inline constexpr int kKiriVersion = 1;

struct LoadedModel {
  Model model;
  /// Sentences about what looks odd but does no harm, such as a field name with a typing error.
  std::vector<std::string> warnings;
};

/// The model that `text` describes; `fileName` is used in sentences only. Whether the steps can be
/// applied to the paper is not looked at (see core/model/replay.h). Errors: BadFile - with file,
/// line and column, the step and its name, the field, and what to write instead.
Result<LoadedModel> readKiri(std::string_view text, std::string_view fileName);

}  // namespace kiri
