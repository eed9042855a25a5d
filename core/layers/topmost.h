// Picking the uppermost of things that share a line.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace kiri {

/// Something that covers a stretch of a line, at some height.
struct Cover {
  std::size_t id = 0;
  double from = 0;
  double to = 0;
  double height = 0;
};

/// The ids of all covers that are among the `count` highest at some place of the line, sorted.
/// Stretches shorter than `tolerance` do not count.
std::vector<std::size_t> topmost(const std::vector<Cover>& covers, int count, double tolerance);

}  // namespace kiri
