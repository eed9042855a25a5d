// The figures that describe a state.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/vec.h"
#include "core/geometry/cubic.h"
#include "core/paper/folded_state.h"

namespace kiri::cli {

struct FoldLineFacts {
  std::string name;
  bool isValley = true;
  std::optional<double>
      angle;  ///< degrees in the fold's own direction; none when its hinges disagree
  std::size_t hinges = 0;
};

struct StateFacts {
  std::size_t facets = 0;
  std::size_t hinges = 0;
  std::size_t tornEdges = 0;
  std::size_t pieces = 0;
  double area = 0;  ///< mm^2
  bool isFlat = true;
  std::uint32_t layers = 0;
  double stretch = 0;                ///< mm
  std::vector<FoldLineFacts> lines;  ///< those that still have hinges
  Box paper;                         ///< box of the paper that is left, paper frame
  Vec3 boxLow;                       ///< box of the folded model, model frame
  Vec3 boxHigh;
};

StateFacts factsOf(const FoldedState& state);

}  // namespace kiri::cli
