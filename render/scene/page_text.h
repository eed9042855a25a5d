// Words on a page: labels that keep out of each other's way, and paragraphs.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/geometry/cubic.h"
#include "render/scene/scene.h"

namespace kiri {

/// About how wide a line of text is, mm.
double widthOf(const std::string& text, double height);

/// The text in lines of at most `width` mm, broken between words.
std::vector<std::string> wrapped(const std::string& text, double height, double width);

/// Finds places for labels beside points of a page.
class LabelPlaces {
 public:
  /// Labels stay in `page`.
  explicit LabelPlaces(const Box& page) : page_(page) {}

  /// Nothing shall be written there.
  void keepFree(const Box& box) { taken_.push_back(box); }

  /// The place of a label for `point`, `away` mm from it or a little more, where it covers the
  /// least of what is there.
  TextItem place(const std::string& text, double height, Vec2 point, double away, Color color);

 private:
  double covered(const Box& box) const;

  Box page_;
  std::vector<Box> taken_;
};

}  // namespace kiri
