// Writing .kiri model files (docs/formats/kiri.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/model/model.h"

namespace kiri {

/// The model as text that people can read and change: the same bytes on every run, and readKiri
/// gives the same model back. Fields that the reader did not know are written where they stood.
/// Requires finite numbers.
std::string writeKiri(const Model& model);

}  // namespace kiri
