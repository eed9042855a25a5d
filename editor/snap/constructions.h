// Placing a line by what it must do: the Huzita-Justin constructions, bisectors, mirrors.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace kiri {

/// A line of one plane, infinite where nothing else is said.
struct Line2 {
  Vec2 from;
  Vec2 to;
};

/// The seven Huzita-Justin operations (guide/algorithms.md; Huzita 1989, Justin 1986, Hatori 2001).
/// Points and lines are of one plane, mm. Each returns all lines that do it, in a fixed order; none
/// when there is none, and none when any number of lines would do (a point that already lies where
/// it shall go, a line of no length). `resolution`: mm within which things are the same.
/// 1: through both points. 2: puts one point onto the other. 3: puts one line onto the other (both
/// bisectors, first that between the directions of the lines; the one between parallels). 4:
/// through the point, square to the line. 5: puts `moved` onto the line, through `through`. 6: puts
/// each point onto its line (up to three). 7: puts the point onto the line, square to the other
/// line.
std::vector<Line2> throughPoints(Vec2 a, Vec2 b, double resolution);
std::vector<Line2> pointOntoPoint(Vec2 moved, Vec2 onto, double resolution);
std::vector<Line2> lineOntoLine(const Line2& moved, const Line2& onto, double resolution);
std::vector<Line2> squareThrough(Vec2 point, const Line2& line, double resolution);
std::vector<Line2> pointOntoLineThrough(Vec2 moved, const Line2& onto, Vec2 through,
                                        double resolution);
std::vector<Line2> pointsOntoLines(Vec2 movedA, const Line2& ontoA, Vec2 movedB, const Line2& ontoB,
                                   double resolution);
std::vector<Line2> pointOntoLineSquareTo(Vec2 moved, const Line2& onto, const Line2& square,
                                         double resolution);

/// Mirror image of a line in a line (thesis F31). A mirror of no length leaves all where it is.
Line2 mirrored(const Line2& line, const Line2& mirror);
Vec2 mirrored(Vec2 point, const Line2& mirror);
/// Nearest point of the infinite line.
Vec2 projectedOnto(Vec2 point, const Line2& line);
/// The line from the corner that halves the angle, of at most 180 degrees, between the rays to a
/// and b.
std::vector<Line2> bisectorOf(Vec2 a, Vec2 corner, Vec2 b, double resolution);

}  // namespace kiri
