// What FOLD files are made of, for all who write them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "io/json_tree.h"

namespace kiri {

/// [a, b]
JsonValue jsonPair(JsonValue a, JsonValue b);

/// ["a", "b", ...]
JsonValue jsonTexts(const std::vector<std::string>& texts);

/// Adds a text unless it is empty.
void addJsonText(JsonValue& out, const char* name, const std::string& text);

/// The frame_attributes of a sheet of paper. `dimension`: "2D" or "3D".
JsonValue foldAttributes(const char* dimension, bool isConvex, bool hasCuts, bool hasJoins);

}  // namespace kiri
