// A crease pattern as people draw it and files hold it: loose lines, before anything is repaired.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/vec.h"

namespace kiri {

/// What a line of a crease pattern means (FOLD 1.2, edges_assignment). Auxiliary lines of other
/// programs are Flat: they do not fold.
enum class Assignment : std::uint8_t {
  Border,      ///< B: the paper ends here
  Mountain,    ///< M
  Valley,      ///< V
  Flat,        ///< F: a crease that lies flat
  Unassigned,  ///< U: folds, nobody said in which direction
  Cut,         ///< C: a slit, paper on both sides
  Join,        ///< J: divides a face for the file's sake; no crease
};

/// One straight line. `angle`: its target in degrees, valley positive, mountain negative, where the
/// file gives one; else 180 degrees are meant for all that fold.
struct DrawnCrease {
  Vec2 from;
  Vec2 to;
  Assignment assignment = Assignment::Unassigned;
  std::optional<double> angle;
  bool operator==(const DrawnCrease&) const = default;
};

/// Which face lies above which, named by points inside them: `upper` lies on the side of `lower`
/// that the front of `lower` is turned to in the folded state (`isFront`), or on the other.
struct DrawnOrder {
  Vec2 upper;
  Vec2 lower;
  bool isFront = true;
  bool operator==(const DrawnOrder&) const = default;
};

/// Lines in the paper frame: y up, seen from the front, whatever the file's own habit. Units are
/// those of the file (PatternFile::mmPerUnit). Lines may cross, overlap, repeat, miss each other by
/// a little; repairing is patternOf's work.
struct CreaseDrawing {
  std::vector<DrawnCrease> lines;
  std::vector<std::vector<Vec2>> faces;  ///< where the paper is, if the file says so; else empty
  std::vector<DrawnOrder> orders;        ///< of the folded state, if the file has them
};

}  // namespace kiri
