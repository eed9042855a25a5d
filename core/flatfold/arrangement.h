// Many straight lines, divided wherever they meet.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/vec.h"

namespace kiri {

/// Pieces of lines that meet at their ends only. A piece run through backwards has the code
/// 2 * piece + 1, forwards 2 * piece.
struct Arrangement {
  std::vector<Vec2> points;
  std::vector<std::array<std::uint32_t, 2>> pieces;  ///< two different points, no pair twice
  std::vector<std::uint32_t> starts;  ///< by line, into `chain`; one more than there are lines
  std::vector<std::uint32_t> chain;   ///< codes of the pieces that a line became, in its direction
  double farthest = 0;  ///< the longest way that a point was moved, or a piece to a point beside it
};

/// Divides lines between points so that points within `within` of a line lie on it, points within
/// `within` of each other are one, and lines that cross share a point. Lines whose ends became one
/// have no pieces. None when it does not come to an end, `within` being of the size of what is
/// drawn, or when it would take more pieces than `piecesLeft`, which is lowered by those made and
/// is 0 then.
std::optional<Arrangement> arrange(const std::vector<Vec2>& points,
                                   const std::vector<std::array<std::uint32_t, 2>>& lines,
                                   double within, std::size_t& piecesLeft);

/// The least distance of a point from a piece that does not end there, or `most` when none is
/// nearer.
double clearanceOf(const Arrangement& arrangement, double most);

}  // namespace kiri
