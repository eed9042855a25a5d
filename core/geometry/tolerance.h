// The one place that says how near is the same.
// SPDX-License-Identifier: MIT
#pragma once

namespace kiri {

/// Every tolerance of the kernel, derived from the size of the sheet. A literal like 1e-9 anywhere
/// else is a defect (DESIGN section 4; a test looks for them).
class Tolerance {
 public:
  /// `sheetSize`: diagonal of the sheet's bounding box, mm, > 0.
  explicit constexpr Tolerance(double sheetSize) : size_(sheetSize) {}

  constexpr double sheetSize() const { return size_; }
  /// Paper-frame points nearer than this are one vertex.
  constexpr double length() const { return 1e-9 * size_; }
  /// Model-frame points nearer than this coincide; wider than length(), for poses carry rounding.
  constexpr double match() const { return 1e-7 * size_; }
  /// A crease that would leave paper thinner than this, but not nothing, is refused.
  constexpr double thin() const { return 1e-5 * size_; }
  /// A drawn end nearer than this to a vertex means the vertex.
  constexpr double pick() const { return 1e-4 * size_; }
  /// Overlaps narrower than this are contact, not overlap: regions are compared as area /
  /// perimeter.
  constexpr double fat() const { return 1e-7 * size_; }
  /// Curves become polylines no farther than this from them.
  constexpr double flattening() const { return 1e-5 * size_; }

 private:
  double size_;
};

/// Directions whose sine differs by less are parallel; parameters of curves nearer than this are
/// equal.
inline constexpr double kParallel = 1e-9;
/// Unit normals whose cross product is shorter than this belong to parallel planes; wider than
/// kParallel, for poses carry rounding.
inline constexpr double kSamePlane = 1e-8;
/// Fold angles nearer than this, in degrees, are equal.
inline constexpr double kSameAngle = 1e-9;
/// A closed loop of creases that misses its start by a smaller turn (radians, lengths as parts of
/// the sheet) closes: beyond rounding, far below length().
inline constexpr double kClosedLoop = 1e-10;
/// Damping of the least-squares equations of loops, whose squared singular values are about 1, or
/// the square of the fold angles in radians where the paper is almost flat.
inline constexpr double kLoopDamping = 1e-10;
/// Hinges beyond 180 degrees by less, in degrees, are at 180: what a solution of loops may miss.
inline constexpr double kFullFold = 1e-8;
/// Parts of a motion nearer than this are one moment.
inline constexpr double kSameMoment = 1e-9;
/// Below this a leading coefficient counts as zero beside the others: the polynomial has a lower
/// degree.
inline constexpr double kVanishing = 1e-14;

}  // namespace kiri
