// The sheet and the look of the paper as they stand in a .kiri file.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "core/model/model.h"
#include "io/json_fields.h"
#include "io/json_tree.h"

namespace kiri {

/// The colour that "#5a8c46" or "#fff" names; none when the text is no colour.
std::optional<Color> colorFromText(const std::string& text);

SheetSpec readSheet(const Field& field);
JsonValue writeSheet(const SheetSpec& sheet);

/// Reads {"front": {...}, "back": {...}} over what the model has.
void readPaper(const Field& field, Model& model);
JsonValue writePaper(const Model& model);

}  // namespace kiri
