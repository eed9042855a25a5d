// Six of the Huzita-Justin constructions, bisectors and mirrors.
// SPDX-License-Identifier: MIT
#include "editor/snap/constructions.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace kiri {
namespace {

/// An infinite line: unit direction and normal, and dot(normal, p) == offset for its points p,
/// counted from an origin near what is looked at.
struct Directed {
  Vec2 along;
  Vec2 normal;
  double offset = 0;
  double length = 0;
};

std::optional<Directed> directed(const Line2& line, Vec2 origin, double resolution) {
  const double size = distance(line.from, line.to);
  if (!(size > resolution)) return std::nullopt;
  const Vec2 along = (line.to - line.from) / size;
  const Vec2 normal = perpendicular(along);
  // From the end that is nearer, for less rounding.
  const Vec2 a = line.from - origin;
  const Vec2 b = line.to - origin;
  return Directed{along, normal, dot(normal, dot(a, a) < dot(b, b) ? a : b), size};
}

/// True when the lines, as long as they are drawn, run apart by no more than the resolution.
bool areParallel(const Directed& a, const Directed& b, double resolution) {
  return std::abs(cross(a.along, b.along)) * std::max(a.length, b.length) <= resolution;
}

/// A line of a given length about a point.
Line2 about(Vec2 point, Vec2 direction, double size) {
  const Vec2 half = normalized(direction) * (size / 2);
  return {point - half, point + half};
}

}  // namespace

std::vector<Line2> throughPoints(Vec2 a, Vec2 b, double resolution) {
  if (!(distance(a, b) > resolution)) return {};
  return {{a, b}};
}

std::vector<Line2> pointOntoPoint(Vec2 moved, Vec2 onto, double resolution) {
  if (!(distance(moved, onto) > resolution)) return {};
  return {about(lerp(moved, onto, 0.5), perpendicular(onto - moved), distance(moved, onto))};
}

std::vector<Line2> lineOntoLine(const Line2& moved, const Line2& onto, double resolution) {
  const Vec2 origin = (moved.from + moved.to + onto.from + onto.to) / 4;
  const std::optional<Directed> a = directed(moved, origin, resolution);
  const std::optional<Directed> b = directed(onto, origin, resolution);
  if (!a || !b) return {};
  const double size = std::max(a->length, b->length);
  if (areParallel(*a, *b, resolution)) {
    const double away = dot(a->normal, onto.from - origin) - a->offset;
    if (std::abs(away) <= resolution) return {};
    return {about(origin + a->normal * (a->offset + away / 2), a->along, size)};
  }
  // Points as far from the one line as from the other, on the one side or on the other.
  const auto bisector = [&](Vec2 normal, double offset) {
    const Vec2 nearest = origin + normal * (offset / dot(normal, normal));
    return about(nearest, -perpendicular(normal), size);
  };
  return {bisector(a->normal + b->normal, a->offset + b->offset),
          bisector(a->normal - b->normal, a->offset - b->offset)};
}

std::vector<Line2> squareThrough(Vec2 point, const Line2& line, double resolution) {
  const std::optional<Directed> a = directed(line, point, resolution);
  if (!a) return {};
  return {about(point, a->normal, a->length)};
}

std::vector<Line2> pointOntoLineThrough(Vec2 moved, const Line2& onto, Vec2 through,
                                        double resolution) {
  const std::optional<Directed> line = directed(onto, through, resolution);
  const Vec2 arm = moved - through;
  const double reach = length(arm);
  if (!line || !(reach > resolution)) return {};
  // The point goes round on a circle about `through`, and meets the line where that does.
  const double spare = reach - std::abs(line->offset);
  if (spare < -resolution) return {};
  const bool touches = spare <= resolution;
  const double half = touches ? 0 : std::sqrt(spare * (reach + std::abs(line->offset)));
  std::vector<Line2> out;
  for (const double side : {-1.0, 1.0}) {
    const Vec2 image = line->normal * line->offset + line->along * (side * half);
    // The line halves the angle between the arms; both expressions do, one of them well.
    const Vec2 between = arm + image;
    const Vec2 square = perpendicular(image - arm);
    out.push_back(
        about(through, dot(between, between) > dot(square, square) ? between : square, 2 * reach));
    if (touches) break;
  }
  return out;
}

std::vector<Line2> pointOntoLineSquareTo(Vec2 moved, const Line2& onto, const Line2& square,
                                         double resolution) {
  const std::optional<Directed> line = directed(onto, moved, resolution);
  const std::optional<Directed> way = directed(square, moved, resolution);
  if (!line || !way || areParallel(*line, *way, resolution)) return {};
  const double steps = line->offset / dot(line->normal, way->along);
  return {about(moved + way->along * (steps / 2), way->normal, way->length)};
}

Vec2 projectedOnto(Vec2 point, const Line2& line) {
  const Vec2 along = line.to - line.from;
  const double square = dot(along, along);
  if (!(square > 0)) return line.from;
  return line.from + along * (dot(point - line.from, along) / square);
}

Vec2 mirrored(Vec2 point, const Line2& mirror) {
  if (mirror.from == mirror.to) return point;
  return projectedOnto(point, mirror) * 2 - point;
}

Line2 mirrored(const Line2& line, const Line2& mirror) {
  return {mirrored(line.from, mirror), mirrored(line.to, mirror)};
}

std::vector<Line2> bisectorOf(Vec2 a, Vec2 corner, Vec2 b, double resolution) {
  const double reach = std::min(distance(a, corner), distance(b, corner));
  if (!(reach > resolution)) return {};
  const Vec2 u = normalized(a - corner);
  const Vec2 v = normalized(b - corner);
  const Vec2 between = u + v;
  Vec2 square = perpendicular(v - u);  // the same direction, well known where `between` is short
  if (dot(square, between) < 0) square = -square;
  const bool isWide = dot(square, square) > dot(between, between);
  return {{corner, corner + normalized(isWide ? square : between) * reach}};
}

}  // namespace kiri
