// What pictures of crease patterns share: a page with a title above and a legend below.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/paper/crease_pattern.h"
#include "render/scene/pattern_check_scene.h"
#include "render/scene/scene.h"

namespace kiri {

/// A line of a legend: words, and what stands before them.
struct LegendLine {
  enum class Sign { None, Ring, Square };
  Sign sign = Sign::None;
  std::string text;
  Color color{0, 0, 0};
};

/// A page with room for pictures of the given size, a title above and a legend below.
class PatternPage {
 public:
  PatternPage(Vec2 pictures, std::vector<LegendLine> legend, const PatternCheckOptions& options);

  Vec2 corner() const { return corner_; }  ///< lower left, of the pictures
  Box pictures() const { return {corner_, corner_ + pictures_}; }
  Box page() const { return {{0, 0}, {width_, height_}}; }

  /// The scene with these groups, the title and the legend.
  Scene scene(std::vector<Group> groups) const;

 private:
  Group legendGroup() const;

  Vec2 pictures_;
  std::vector<LegendLine> legend_;  ///< wrapped
  std::string title_;
  Vec2 corner_;
  double width_ = 0;
  double height_ = 0;
  double margin_ = 0;
};

/// Strokes of rings and squares around `at`.
Item ringMark(Vec2 at, double radius, Color color, const std::string& kind);
Item squareMark(Vec2 at, double half, Color color, const std::string& kind);

inline constexpr double kMarkWidth = 0.5;  ///< mm
inline constexpr double kWordHeight = 3.2;

}  // namespace kiri
