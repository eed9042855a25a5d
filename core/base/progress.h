// How long work reports where it is and learns that nobody wants it any more.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace kiri {

/// Called now and then with the part that is done, 0 to 1. Returns false to stop the work.
using Progress = std::function<bool(double)>;

/// Tells `progress` (which may be empty) and says whether to go on.
inline bool goesOn(const Progress& progress, double done) { return !progress || progress(done); }

}  // namespace kiri
