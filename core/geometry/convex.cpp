// Clipping of convex polygons by lines: distances within eps of a line count as zero.
// SPDX-License-Identifier: MIT
#include "core/geometry/convex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/base/check.h"
#include "core/geometry/bounds.h"

namespace kiri {
namespace {

/// Points with room for a few on the stack: most facets have few sides, and clipping is done by the
/// million.
template <class T>
class Scratch {
 public:
  explicit Scratch(std::size_t size) : size_(size) {
    if (size > kInPlace) heap_.resize(size);
  }
  T* data() { return size_ > kInPlace ? heap_.data() : inPlace_.data(); }

 private:
  static constexpr std::size_t kInPlace = 48;
  std::size_t size_;
  std::array<T, kInPlace> inPlace_;
  std::vector<T> heap_;
};

/// Signed distance from a line, snapped to zero within eps.
class SideOf {
 public:
  SideOf(Vec2 a, Vec2 b, double eps) : origin_(a), eps_(eps) {
    const Vec2 d = b - a;
    normal_ = perpendicular(d) / length(d);
  }
  double operator()(Vec2 p) const {
    const double d = dot(normal_, p - origin_);
    return std::abs(d) <= eps_ ? 0.0 : d;
  }

 private:
  Vec2 origin_;
  Vec2 normal_;
  double eps_;
};

/// Where a side crosses the line; the same bits from both ends, for it always starts on the left.
Vec2 crossing(Vec2 p, double dp, Vec2 q, double dq) {
  return dp > dq ? p + (q - p) * (dp / (dp - dq)) : q + (p - q) * (dq / (dq - dp));
}

/// What of a polygon lies left of a line.
enum class Kept { All, Some, None };

/// Writes distances to `side` and says what is left of the line.
Kept measure(std::span<const Vec2> polygon, const SideOf& sideOf, double* side) {
  bool hasLeft = false;
  bool hasRight = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    side[i] = sideOf(polygon[i]);
    hasLeft = hasLeft || side[i] > 0;
    hasRight = hasRight || side[i] < 0;
  }
  return !hasLeft ? Kept::None : (hasRight ? Kept::Some : Kept::All);
}

/// Writes the left part to `out` (room for one point more than `polygon` has); returns how many
/// points.
std::size_t writeLeft(std::span<const Vec2> polygon, const double* side, Vec2* out) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = i + 1 < polygon.size() ? i + 1 : 0;
    if (side[i] >= 0) out[count++] = polygon[i];
    if ((side[i] > 0 && side[j] < 0) || (side[i] < 0 && side[j] > 0)) {
      out[count++] = crossing(polygon[i], side[i], polygon[j], side[j]);
    }
  }
  return count;
}

struct Extent {
  double area;
  double perimeter;
  double longest;
};

Extent extentOf(std::span<const Vec2> polygon) {
  Extent e{signedArea(polygon), 0, 0};
  std::size_t last = polygon.size() - 1;
  for (std::size_t i = 0; i < polygon.size(); last = i++) {
    const double side = distance(polygon[last], polygon[i]);
    e.perimeter += side;
    e.longest = std::max(e.longest, side);
  }
  return e;
}

/// True when the common box is wider and higher than `width`.
bool boxesOverlap(std::span<const Vec2> a, std::span<const Vec2> b, double width) {
  const Box p = boundsOf(a);
  const Box q = boundsOf(b);
  return std::min(p.high.x, q.high.x) - std::max(p.low.x, q.low.x) > width &&
         std::min(p.high.y, q.high.y) - std::max(p.low.y, q.low.y) > width;
}

/// Room for clipping: twice what exact convex polygons need, for sides that are collinear only but
/// for rounding may cross a line more than twice.
std::size_t roomFor(std::span<const Vec2> a, std::span<const Vec2> b) {
  return 2 * (a.size() + b.size());
}

/// Clips `a` by every side of `b`, alternating between two buffers of roomFor(a, b) points. The
/// result lies in one of them, or is `a` itself.
std::span<const Vec2> clipByAll(std::span<const Vec2> a, std::span<const Vec2> b, double eps,
                                Vec2* buffer, Vec2* other, double* side) {
  std::span<const Vec2> current = a;
  for (std::size_t i = 0; i < b.size(); ++i) {
    const Vec2 from = b[i];
    const Vec2 to = b[i + 1 < b.size() ? i + 1 : 0];
    if (from == to) continue;
    const Kept kept = measure(current, SideOf(from, to, eps), side);
    if (kept == Kept::None) return {};
    if (kept == Kept::All) continue;
    KIRI_CHECK(current.size() + current.size() / 2 < roomFor(a, b), "clipped polygons are convex");
    current = {buffer, writeLeft(current, side, buffer)};
    std::swap(buffer, other);
  }
  return current;
}

}  // namespace

double signedArea(std::span<const Vec2> polygon) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return sum / 2;
}

std::vector<Vec2> clipLeft(std::span<const Vec2> polygon, Vec2 a, Vec2 b, double eps) {
  Scratch<double> side(polygon.size());
  switch (measure(polygon, SideOf(a, b, eps), side.data())) {
    case Kept::None:
      return {};
    case Kept::All:
      return {polygon.begin(), polygon.end()};
    default:
      break;
  }
  std::vector<Vec2> result(polygon.size() + polygon.size() / 2 + 1);
  result.resize(writeLeft(polygon, side.data(), result.data()));
  return result;
}

std::vector<Vec2> intersection(std::span<const Vec2> a, std::span<const Vec2> b, double eps) {
  if (a.size() < 3 || b.size() < 3 || !boxesOverlap(a, b, eps)) return {};
  const std::size_t room = roomFor(a, b);
  Scratch<Vec2> buffer(room);
  Scratch<Vec2> other(room);
  Scratch<double> side(room);
  const std::span<const Vec2> common =
      clipByAll(a, b, eps, buffer.data(), other.data(), side.data());
  if (common.size() < 3) return {};
  const Extent extent = extentOf(common);
  if (extent.area <= eps * extent.longest) return {};
  return {common.begin(), common.end()};
}

bool overlap(std::span<const Vec2> a, std::span<const Vec2> b, double fat) {
  // A convex polygon no wider than 2 fat has no more than fat of area for each mm of perimeter.
  if (a.size() < 3 || b.size() < 3 || !boxesOverlap(a, b, 2 * fat)) return false;
  const std::size_t room = roomFor(a, b);
  Scratch<Vec2> buffer(room);
  Scratch<Vec2> other(room);
  Scratch<double> side(room);
  constexpr double kFiner = 1.0 / 1024;
  const std::span<const Vec2> common =
      clipByAll(a, b, fat * kFiner, buffer.data(), other.data(), side.data());
  if (common.size() < 3) return false;
  const Extent extent = extentOf(common);
  return extent.area > fat * extent.perimeter;
}

ConvexHalves splitConvex(const ConvexPart& part, Vec2 a, Vec2 b, std::int32_t tag, double eps) {
  const std::size_t n = part.points.size();
  const SideOf sideOf(a, b, eps);
  Scratch<double> side(n);
  const Kept left = measure(part.points, sideOf, side.data());
  const double* d = side.data();
  if (left == Kept::All) return {part, {{}, {}}};
  if (left == Kept::None) {
    const bool hasRight = std::any_of(d, d + n, [](double v) { return v < 0; });
    return {{{}, {}}, hasRight ? part : ConvexPart{{}, {}}};
  }
  ConvexHalves halves;
  const auto add = [](ConvexPart& half, Vec2 p, std::int32_t sideTag) {
    half.points.push_back(p);
    half.tags.push_back(sideTag);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    const Vec2 p = part.points[i];
    const std::int32_t own = part.tags[i];
    if (d[i] >= 0) add(halves.left, p, d[i] == 0 && d[j] < 0 ? tag : own);
    if (d[i] <= 0) add(halves.right, p, d[i] == 0 && d[j] > 0 ? tag : own);
    if ((d[i] > 0 && d[j] < 0) || (d[i] < 0 && d[j] > 0)) {
      const Vec2 x = crossing(p, d[i], part.points[j], d[j]);
      add(halves.left, x, d[i] > 0 ? tag : own);
      add(halves.right, x, d[i] > 0 ? own : tag);
    }
  }
  return halves;
}

}  // namespace kiri
