// The states of a time line, for what asks for a replay.
// SPDX-License-Identifier: MIT
#include "apps/cli/timeline_replay.h"

#include <memory>

namespace kiri::cli {

Replay replayOf(const Timeline& timeline, std::size_t steps) {
  const auto shared = [&](std::size_t count) {
    return std::shared_ptr<const FoldedState>(std::shared_ptr<void>(), &timeline.stateAfter(count));
  };
  Replay replay;
  replay.start = shared(0);
  for (std::size_t i = 1; i <= steps; ++i) replay.outcomes.push_back({shared(i), std::nullopt});
  return replay;
}

}  // namespace kiri::cli
