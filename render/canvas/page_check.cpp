// What every file format asks of a scene.
// SPDX-License-Identifier: MIT
#include "render/canvas/page_check.h"

#include <string>

#include "render/canvas/number_text.h"

namespace kiri {

Status checkPage(const Scene& scene) {
  constexpr double kLargest = 100000;
  const auto fits = [&](double mm) { return mm > 0 && mm <= kLargest; };
  if (fits(scene.width) && fits(scene.height)) return std::monostate{};
  const auto text = [&](double mm) {
    return mm >= 0 && mm <= 1000 * kLargest ? numberText(mm, 1) : std::string("no number of");
  };
  return Error{
      ErrorCode::BadValue,
      "the picture would be " + text(scene.width) + " x " + text(scene.height) +
          " mm; pages are larger than nothing and at most 100 m, so change the margin or the scale",
      {}};
}

}  // namespace kiri
