// Small things that reports in JSON are made of.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/vec.h"
#include "io/json_tree.h"

namespace kiri::cli {

JsonValue countJson(std::size_t count);
JsonValue pointJson(Vec2 point);
JsonValue pointJson(Vec3 point);
JsonValue textsJson(const std::vector<std::string>& texts);

}  // namespace kiri::cli
