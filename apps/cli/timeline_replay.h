// The states of a time line, for what asks for a replay.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/model/replay.h"
#include "core/model/timeline.h"

namespace kiri::cli {

/// The states of a time line as a replay; `timeline` must outlive it.
Replay replayOf(const Timeline& timeline, std::size_t steps);

}  // namespace kiri::cli
