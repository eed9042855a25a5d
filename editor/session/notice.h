// What the status bar says after something happened.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "editor/base/phrase.h"

namespace kiri {

/// The sentence for the status bar after something happened, and how grave it is.
struct Notice {
  enum class Kind { None, Done, Warning, Refused };
  Kind kind = Kind::None;
  Phrase text;      ///< of the editor; translated
  std::string why;  ///< the kernel's sentence
};

}  // namespace kiri
