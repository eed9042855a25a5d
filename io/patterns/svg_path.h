// What SVG's shapes and path data draw, as straight and cubic arcs.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "core/geometry/cubic.h"

namespace kiri {

/// One line drawn without lifting the pen.
struct SvgChain {
  std::vector<Arc> arcs;
  bool isClosed = false;  ///< the file says so (Z, polygon, rect...)
};

struct SvgOutline {
  std::vector<SvgChain> chains;
  bool isWhole = true;  ///< false: the data are damaged, what comes before the damage is there
};

/// Path data (the attribute d): all commands, absolute and relative, numbers written as densely as
/// SVG 1.1 allows ("1-2.5.5"). Ends where the damage starts, as SVG demands.
SvgOutline svgPathOf(std::string_view data);

/// The attribute points, closed (polygon) or not (polyline).
SvgOutline svgPointsOf(std::string_view points, bool isClosed);

/// Corners rounded by rx, ry where they are above 0.
SvgChain svgRectangle(Vec2 corner, Vec2 size, Vec2 radii);
SvgChain svgEllipse(Vec2 centre, Vec2 radii);

/// Appends the elliptical arc of path data from `from` to `to` as cubics of at most an eighth turn
/// (nearer than 5 millionths of the radius); `turn` in degrees.
void appendSvgArc(std::vector<Arc>& arcs, Vec2 from, Vec2 to, Vec2 radii, double turn, bool isLarge,
                  bool isPositive);

}  // namespace kiri
