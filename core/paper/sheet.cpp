// Making outlines, and refusing polygons that no sheet can have.
// SPDX-License-Identifier: MIT
#include "core/paper/sheet.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "core/geometry/rigid.h"

namespace kiri {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value + 0.0);
  return text;
}

std::string place(Vec2 p) { return "(" + number(p.x) + ", " + number(p.y) + ") mm"; }

Error badValue(std::string message, std::vector<Vec2> points = {}) {
  return {ErrorCode::BadValue, std::move(message), {std::move(points), {}, {}}};
}

bool isSize(double value) { return std::isfinite(value) && value > 0; }

Error badSize(const char* what, double value) {
  return badValue(std::string("the ") + what + " of the sheet is " + number(value) +
                  ", but must be a number of mm above 0");
}

Loop loopOf(const std::vector<Vec2>& corners) {
  Loop loop;
  loop.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    loop.push_back(Arc::line(corners[i], corners[(i + 1) % corners.size()]));
  }
  return loop;
}

double diagonalOf(const Region& region) {
  const Box box = boundsOf(region);
  return distance(box.low, box.high);
}

/// A polygon of the user's with the name that messages give it.
struct NamedLoop {
  std::string name;
  Loop sides;

  std::string side(std::size_t i) const { return "side " + std::to_string(i + 1) + " of " + name; }
};

std::optional<Error> checkCorners(const std::string& name, const std::vector<Vec2>& corners) {
  if (corners.size() < 3) {
    return badValue(name + " has " + std::to_string(corners.size()) +
                    " corners, but needs at least three");
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!std::isfinite(corners[i].x) || !std::isfinite(corners[i].y)) {
      return badValue("corner " + std::to_string(i + 1) + " of " + name +
                      " is not a pair of finite numbers of mm");
    }
  }
  return std::nullopt;
}

std::optional<Error> checkSides(const NamedLoop& loop, double nearness) {
  for (std::size_t i = 0; i < loop.sides.size(); ++i) {
    const Arc& side = loop.sides[i];
    if (distance(side.start, side.end) > nearness) continue;
    const std::size_t other = (i + 1) % loop.sides.size();
    return badValue("corners " + std::to_string(i + 1) + " and " + std::to_string(other + 1) +
                        " of " + loop.name + " are the same point " + place(side.start) +
                        "; leave one of them out",
                    {side.start});
  }
  return std::nullopt;
}

/// Where two sides meet that should not. Neighbours may meet at the corner they share, and nowhere
/// else.
std::optional<Vec2> conflict(const Arc& a, const Arc& b, bool aEndsAtB, bool bEndsAtA,
                             const Tolerance& tolerance) {
  for (const Meeting& m : meetings(a, b, tolerance)) {
    const bool isSharedCorner =
        (aEndsAtB && m.t == 1 && m.u == 0) || (bEndsAtA && m.t == 0 && m.u == 1);
    if (!isSharedCorner) return pointAt(a, m.t);
  }
  return std::nullopt;
}

std::optional<Error> checkCrossings(const NamedLoop& a, const NamedLoop& b, bool isSameLoop,
                                    const Tolerance& tolerance) {
  const std::size_t n = a.sides.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Box box = boundsOf(a.sides[i]);
    for (std::size_t j = isSameLoop ? i + 1 : 0; j < b.sides.size(); ++j) {
      if (!areNear(box, boundsOf(b.sides[j]), tolerance.length())) continue;
      const bool iThenJ = isSameLoop && (i + 1) % n == j;
      const bool jThenI = isSameLoop && (j + 1) % n == i;
      const std::optional<Vec2> where = conflict(a.sides[i], b.sides[j], iThenJ, jThenI, tolerance);
      if (!where) continue;
      return badValue(a.side(i) + " meets " + b.side(j) + " at " + place(*where) +
                          "; move a corner so that they stay apart",
                      {*where});
    }
  }
  return std::nullopt;
}

/// Turns the loop the way a region needs it.
void orient(Loop& loop, bool isCounterClockwise) {
  if ((signedAreaOf(loop) > 0) == isCounterClockwise) return;
  std::reverse(loop.begin(), loop.end());
  for (Arc& arc : loop) arc = reversed(arc);
}

/// Area that is no more than rounding beside the length of the border.
bool isThin(const Loop& loop, const Tolerance& tolerance) {
  const double border = perimeterOf(Region{{loop}}, tolerance.length());
  return std::abs(signedAreaOf(loop)) <= tolerance.length() * border;
}

std::optional<Error> checkHoles(const std::vector<NamedLoop>& loops, const Tolerance& tolerance) {
  const auto isIn = [&](const NamedLoop& hole, const NamedLoop& other) {
    return locate(Region{{other.sides}}, hole.sides[0].start, tolerance.length()) != Where::Outside;
  };
  for (std::size_t i = 1; i < loops.size(); ++i) {
    const Vec2 corner = loops[i].sides[0].start;
    if (!isIn(loops[i], loops[0])) {
      return badValue(loops[i].name + " lies outside of the outline, as its corner 1 at " +
                          place(corner) + " shows; move it inside",
                      {corner});
    }
    for (std::size_t j = 1; j < loops.size(); ++j) {
      if (i == j || !isIn(loops[i], loops[j])) continue;
      return badValue(loops[i].name + " lies inside " + loops[j].name + ", as its corner 1 at " +
                          place(corner) + " shows; leave it out",
                      {corner});
    }
  }
  return std::nullopt;
}

std::optional<Error> checkLoops(const std::vector<NamedLoop>& loops, const Tolerance& tolerance) {
  for (const NamedLoop& loop : loops) {
    if (std::optional<Error> error = checkSides(loop, tolerance.length())) return error;
  }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (std::size_t j = i; j < loops.size(); ++j) {
      if (std::optional<Error> error = checkCrossings(loops[i], loops[j], i == j, tolerance))
        return error;
    }
  }
  for (const NamedLoop& loop : loops) {
    if (isThin(loop.sides, tolerance)) {
      return badValue(loop.name + " has no area near " + place(loop.sides[0].start) +
                          "; give it corners that are not in one line",
                      {loop.sides[0].start});
    }
  }
  return checkHoles(loops, tolerance);
}

}  // namespace

Tolerance Sheet::tolerance() const { return Tolerance(diagonalOf(outline)); }

Result<Sheet> rectangleSheet(double width, double height) {
  if (!isSize(width)) return badSize("width", width);
  if (!isSize(height)) return badSize("height", height);
  return Sheet{Region{{loopOf({{0, 0}, {width, 0}, {width, height}, {0, height}})}}};
}

Result<Sheet> squareSheet(double side) {
  if (!isSize(side)) return badSize("side", side);
  return rectangleSheet(side, side);
}

Result<Sheet> discSheet(double radius) {
  if (!isSize(radius)) return badSize("radius", radius);
  constexpr std::size_t kPieces = 32;
  // Length of the handles, in radii, that spreads the error of a 32nd of a circle evenly to both
  // sides: 0.74 thousand-millionths. (The usual 4/3 tan(a/4) touches the circle in the middle and
  // strays 1.04 to one side.)
  constexpr double kHandle = 0.06550245628394017;
  std::vector<Vec2> directions(kPieces);
  for (std::size_t i = 0; i < kPieces; ++i) {
    const CosSin turn = cosSinDegrees(360.0 * static_cast<double>(i) / kPieces);
    directions[i] = {turn.cos, turn.sin};
  }
  const Vec2 centre{radius, radius};
  Loop border;
  for (std::size_t i = 0; i < kPieces; ++i) {
    const Vec2 from = directions[i] * radius;
    const Vec2 to = directions[(i + 1) % kPieces] * radius;
    border.push_back(Arc::cubic(centre + from, centre + (from + perpendicular(from) * kHandle),
                                centre + (to - perpendicular(to) * kHandle), centre + to));
  }
  return Sheet{Region{{std::move(border)}}};
}

Result<Sheet> polygonSheet(const std::vector<Vec2>& outline,
                           const std::vector<std::vector<Vec2>>& holes) {
  if (std::optional<Error> error = checkCorners("the outline", outline)) return *std::move(error);
  std::vector<NamedLoop> loops{{"the outline", loopOf(outline)}};
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const std::string name = "hole " + std::to_string(i + 1);
    if (std::optional<Error> error = checkCorners(name, holes[i])) return *std::move(error);
    loops.push_back({name, loopOf(holes[i])});
  }
  const double diagonal = diagonalOf(Region{{loops[0].sides}});
  if (!isSize(diagonal))
    return badValue("all corners of the outline are the same point " + place(outline[0]));
  if (std::optional<Error> error = checkLoops(loops, Tolerance(diagonal))) return *std::move(error);
  Sheet sheet;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    orient(loops[i].sides, i == 0);
    sheet.outline.loops.push_back(std::move(loops[i].sides));
  }
  return sheet;
}

}  // namespace kiri
