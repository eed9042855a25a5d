// Which paper is seen at and right around points of a pane.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "editor/view/neighbourhood.h"

namespace kiri {

/// Answers are remembered: in a stack, many things lie at few points. Keeps a reference.
class SeenPlaces {
 public:
  explicit SeenPlaces(const Neighbourhood& near) : near_(near) {}

  /// True when paper of the facet is seen at a pixel, or in some direction right beside it: at a
  /// corner, this holds for all that meet there and are not covered. The facet has an edge there.
  /// Exact: between two neighbouring edges that pass through the point nothing changes.
  bool has(FacetId facet, Vec2 pixels);

  /// All that has been found to be seen there so far: what is asked for, and what covers it.
  const std::vector<FacetId>& knownAt(Vec2 pixels) { return at(pixels).seen; }

  /// Pixels, so that points that are one but for rounding are equal.
  using Key = std::pair<double, double>;
  static Key keyOf(Vec2 pixels);

 private:
  struct Point {
    Vec2 pixels;
    bool isCovered = false;  ///< lies well inside of the paper that is seen
    std::vector<FacetId> seen;
    std::vector<double> edges;  ///< directions that divide what is around it, degrees, sorted
  };

  Point& at(Vec2 pixels);
  void look(Point& point, FacetId facet) const;
  FacetId uppermostAfter(const Point& point, std::size_t edge) const;

  const Neighbourhood& near_;
  std::map<Key, Point> known_;
};

}  // namespace kiri
