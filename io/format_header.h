// The first two fields of our own files: "format" and "version".
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "io/json_fields.h"

namespace kiri {

/// Reads "format", which must be `format`, and "version", which may be up to `newest`. `what` names
/// the file in sentences ("a model file"). Says whether it makes sense to read on.
bool readFormatHeader(Fields& fields, const std::string& what, const std::string& format,
                      int newest);

}  // namespace kiri
