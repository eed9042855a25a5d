// The margin moved outward, facet by facet, between the directions of the creases beside it.
// SPDX-License-Identifier: MIT
#include "core/leaf/blade_outline.h"

#include <algorithm>
#include <array>

namespace kiri {
namespace {

/// Rooms that are tried, in lengths of the mid-vein.
constexpr std::array<double, 6> kRooms = {0.08, 0.06, 0.04, 0.03, 0.02, 0.01};
/// As parts of the room: how far the border may run from the margin moved outward, and how near to
/// the margin or to a crease beside it.
constexpr double kRough = 0.25;
constexpr double kLeast = 0.15;
constexpr int kPerPiece = 4;

Vec2 directionOf(const LeafCrease& crease) { return normalized(crease.end - crease.from); }

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  return distance(p, a + along * t);
}

/// The nearest direction to `normal` between those of two creases, `left` the one further
/// counter-clockwise. Creases that run together: half way.
Vec2 betweenCreases(Vec2 normal, Vec2 left, Vec2 right) {
  if (cross(right, left) <= 0) return normalized(left + right);
  if (cross(normal, left) >= 0 && cross(right, normal) >= 0) return normal;
  return dot(normal, left) > dot(normal, right) ? left : right;
}

/// Leaves out places as long as the line stays near them (Douglas and Peucker 1973).
void keepNeeded(const std::vector<Vec2>& line, std::size_t from, std::size_t to, double rough,
                std::vector<Vec2>& out) {
  std::size_t worst = from;
  double most = rough;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double away = distanceToSegment(line[i], line[from], line[to]);
    if (away <= most) continue;
    most = away;
    worst = i;
  }
  if (worst == from) {
    out.push_back(line[to]);
    return;
  }
  keepNeeded(line, from, worst, rough, out);
  keepNeeded(line, worst, to, rough, out);
}

/// The border of one facet in the order of the margin, both ends on its creases.
std::vector<Vec2> borderOf(const FoldedHalf& half, const std::vector<Vec2>& margin,
                           std::size_t facet, double room) {
  const Vec2 left = directionOf(half.creases()[facet]);
  const Vec2 right = directionOf(half.creases()[facet + 1]);
  std::vector<Vec2> moved = {margin.front() + left * room};
  for (std::size_t k = 1; k + 1 < margin.size(); ++k) {
    const Vec2 normal = perpendicular(normalized(margin[k + 1] - margin[k - 1]));
    moved.push_back(margin[k] + betweenCreases(normal, left, right) * room);
  }
  moved.push_back(margin.back() + right * room);
  std::vector<Vec2> border = {moved.front()};
  keepNeeded(moved, 0, moved.size() - 1, kRough * room, border);
  return border;
}

bool isClear(const FoldedHalf& half, const std::vector<Vec2>& margin,
             const std::vector<Vec2>& border, std::size_t facet, double room) {
  const LeafCrease& before = half.creases()[facet];
  const LeafCrease& behind = half.creases()[facet + 1];
  for (std::size_t i = 0; i < border.size(); ++i) {
    const double fromBefore = cross(border[i] - before.from, directionOf(before));
    const double fromBehind = cross(directionOf(behind), border[i] - behind.from);
    if (i > 0 && !(fromBefore > kLeast * room)) return false;
    if (i + 1 < border.size() && !(fromBehind > kLeast * room)) return false;
  }
  for (const Vec2 place : margin) {
    for (std::size_t i = 0; i + 1 < border.size(); ++i) {
      if (distanceToSegment(place, border[i], border[i + 1]) < kLeast * room) return false;
    }
  }
  return true;
}

bool doMeet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const bool isParted = cross(b - a, c - a) * cross(b - a, d - a) <= 0;
  return isParted && cross(d - c, a - c) * cross(d - c, b - c) <= 0;
}

/// No two sides meet, and all stay in their half.
bool isSimple(const std::vector<Vec2>& places) {
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    if (!(places[i + 1].x > 0)) return false;
    for (std::size_t k = i + 2; k + 1 < places.size(); ++k) {
      if (doMeet(places[i], places[i + 1], places[k], places[k + 1])) return false;
    }
  }
  return true;
}

}  // namespace

Result<BladeOutline> bladeOutline(const FoldedHalf& half, const MarginCurve& curve) {
  std::size_t tight = 0;
  for (const double room : kRooms) {
    BladeOutline outline;
    std::size_t facet = 0;
    for (; facet + 1 < half.creases().size(); ++facet) {
      std::vector<Vec2> margin = marginOfFacet(half, curve, facet, kPerPiece);
      if (half.tipOf(facet) != facet) std::reverse(margin.begin(), margin.end());
      const std::vector<Vec2> border = borderOf(half, margin, facet, room);
      if (!isClear(half, margin, border, facet, room) || !isSimple(border)) break;
      outline.ends.push_back(outline.places.size());
      outline.places.insert(outline.places.end(), border.begin(), border.end() - 1);
      if (facet + 2 < half.creases().size()) continue;
      outline.ends.push_back(outline.places.size());
      outline.places.push_back(border.back());
    }
    if (facet + 1 < half.creases().size()) {
      tight = facet;
    } else if (isSimple(outline.places)) {
      return outline;
    }
  }
  return Error{ErrorCode::BadValue,
               "the " + half.creases()[tight].name + " and the " + half.creases()[tight + 1].name +
                   " end too near to each other: no border of the sheet fits between them; move "
                   "their ends apart"};
}

}  // namespace kiri
