// Leaf recipes as files (docs/formats/leaf.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/leaf/leaf_recipe.h"

namespace kiri {

struct LoadedRecipe {
  LeafRecipe recipe;
  std::vector<std::string> warnings;  ///< sentences, one for each field that is not known
};

/// The recipe that `text` describes; `fileName` is used in sentences only. Whether a leaf can be
/// made of it is not looked at (see core/leaf/leaf_model.h). Errors: BadFile - with file, line and
/// column, the field, and what to write instead.
Result<LoadedRecipe> readLeafRecipe(std::string_view text, std::string_view fileName);

}  // namespace kiri
