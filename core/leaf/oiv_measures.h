// The measures of vine leaves: main veins, lateral sinuses and the angles between veins.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/leaf/margin_points.h"
#include "core/paper/crease_pattern.h"

namespace kiri {

/// A characteristic of the OIV descriptor list for grape varieties, as far as a leaf has it: N1 is
/// the mid-vein, N2 the next main vein on either side, and so on.
struct OivMeasure {
  int code = 0;           ///< 601 to 609
  const char* name = "";  ///< "length of vein N1"
  bool isAngle = false;   ///< degrees, else mm
  std::optional<double> right;
  std::optional<double> left;
};

/// The class of an angle (607 to 609): 1, 3, 5, 7 or 9, from very small (to 30 degrees) to very
/// large (above 70).
int oivAngleClass(double degrees);

/// The characteristics of a leaf with veins: creases that leave the petiole towards tips of the
/// margin. 601 to 604: lengths of N1 to N4; 605, 606: from the petiole sinus to the upper and the
/// lower lateral sinus; 607 to 609: angles N1N2, N2N3, N3N4, which in straight veins are the same
/// all along. Empty where no mid-vein and second vein are creased.
std::vector<OivMeasure> oivMeasures(const CreasePattern& pattern, Vec2 petiole,
                                    const std::vector<MarginPoint>& margin);

}  // namespace kiri
