// Points by their places: which of them lies nearest, if near at all.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/base/vec.h"

namespace kiri {

/// Points in squares as wide as the distance that is asked for. Looking up and adding take constant
/// time as long as few points share a square.
class NearPoints {
 public:
  /// `within` > 0. Coordinates count from `origin`, so that squares are fine far away from zero.
  NearPoints(Vec2 origin, double within) : origin_(origin), within_(within) {}

  /// The added point nearest to `p` at a distance of at most `within`; the first of equals.
  std::optional<std::uint32_t> nearest(Vec2 p) const;
  /// Adds a point; they are numbered as they come.
  std::uint32_t add(Vec2 p);
  const std::vector<Vec2>& points() const { return points_; }

 private:
  struct Square {
    std::int64_t x = 0;
    std::int64_t y = 0;
    bool operator==(const Square&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Square& s) const;
  };
  Square squareOf(Vec2 p) const;

  Vec2 origin_;
  double within_;
  std::vector<Vec2> points_;
  std::vector<std::uint32_t> next_;  ///< the point added before in the same square
  std::unordered_map<Square, std::uint32_t, Hash> last_;
};

}  // namespace kiri
