// Many pieces of work of one kind, several at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace kiri::cli {

/// How far the work is.
struct PoolView {
  std::size_t done = 0;
  std::vector<std::size_t> atWork;  ///< in order
};

/// Calls `work(i, stop)` for every i below `count`, on up to `threads` threads, begun in order.
/// The calling thread calls `watch` before the first piece, when one begins or ends, and ten times
/// a second; when that says false, `stop` becomes true for all and no further piece is begun.
/// Returns when every piece that was begun has ended. What a piece throws is thrown again, of
/// several the first. Says whether all pieces were begun.
bool inParallel(std::size_t count, std::size_t threads,
                const std::function<void(std::size_t, const std::atomic<bool>&)>& work,
                const std::function<bool(const PoolView&)>& watch);

/// The threads that this machine runs at once, at least 1.
std::size_t processorCount();

}  // namespace kiri::cli
