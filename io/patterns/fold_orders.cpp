// Which face lies above which, from the faceOrders of a FOLD file.
// SPDX-License-Identifier: MIT
#include "io/patterns/fold_orders.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "io/patterns/tally.h"

namespace kiri {

namespace {

using Kind = JsonValue::Kind;

Vec2 centreOf(const std::vector<Vec2>& face, double doubled) {
  Vec2 sum;
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const Vec2 a = face[i] - face[0];
    const Vec2 b = face[i + 1] - face[0];
    sum = sum + (a + b) * cross(a, b);
  }
  return face[0] + sum / (3 * doubled);
}

bool isInTriangle(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
  return cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 && cross(a - c, p - c) >= 0;
}

/// A point inside a simple polygon that runs counter-clockwise: of the diagonal, or the triangle,
/// at its lowest corner.
Vec2 pointAtCorner(const std::vector<Vec2>& face) {
  const std::size_t n = face.size();
  std::size_t corner = n;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 turnIn = face[i] - face[(i + n - 1) % n];
    const Vec2 turnOut = face[(i + 1) % n] - face[i];
    if (cross(turnIn, turnOut) <= 0) continue;
    const bool isLower = corner == n || face[i].y < face[corner].y ||
                         (face[i].y == face[corner].y && face[i].x < face[corner].x);
    if (isLower) corner = i;
  }
  if (corner == n) return face[0];
  const Vec2 a = face[(corner + n - 1) % n];
  const Vec2 v = face[corner];
  const Vec2 b = face[(corner + 1) % n];
  double deepest = 0;
  std::optional<Vec2> inside;
  for (const Vec2 p : face) {
    if (p == a || p == v || p == b || !isInTriangle(p, a, v, b)) continue;
    const double depth = cross(p - b, a - b);
    if (!inside || depth > deepest) {
      deepest = depth;
      inside = p;
    }
  }
  return inside ? lerp(v, *inside, 0.5) : (a + v + b) / 3;
}

/// A point inside the face; none when it has no area.
std::optional<Vec2> pointInside(const std::vector<Vec2>& face) {
  double doubled = 0;
  bool isConvex = true;
  const std::size_t n = face.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = face[i] - face[0];
    const Vec2 b = face[(i + 1) % n] - face[0];
    doubled += cross(a, b);
    isConvex = isConvex && cross(b - a, face[(i + 2) % n] - face[(i + 1) % n]) >= 0;
  }
  if (!(doubled > 0)) return std::nullopt;
  const Vec2 point = isConvex ? centreOf(face, doubled) : pointAtCorner(face);
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) return std::nullopt;
  return point;
}

bool isSame(const JsonValue& a, const JsonValue& b) {
  if (&a == &b) return true;
  if (a.kind != b.kind || a.items.size() != b.items.size()) return false;
  if (a.is(Kind::Number) && a.number != b.number) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i) {
    if (!isSame(a.items[i], b.items[i])) return false;
  }
  return true;
}

/// The orders of the pattern's own frame, or of the first other frame that has the same faces.
const JsonValue* ordersFor(const JsonValue& document, const FoldFrameView& frame,
                           std::vector<std::string>& notes) {
  if (const JsonValue* own = frame.find("faceOrders")) return own;
  const JsonValue* faces = frame.find("faces_vertices");
  if (faces == nullptr) return nullptr;
  constexpr int kMostTries = 20;  // each may inherit the whole file
  int tries = 0;
  for (std::size_t i = 0; i < frameCountOf(document); ++i) {
    if (i == frame.index() || frameObject(document, i).find("faceOrders") == nullptr) continue;
    if (++tries > kMostTries) break;
    const FoldFrameView other(document, i);
    const JsonValue* orders = other.findOwn("faceOrders");
    if (orders == nullptr) continue;
    const JsonValue* others = other.find("faces_vertices");
    if (others == nullptr || !isSame(*faces, *others)) continue;
    notes.push_back("the face orders are those of " + other.name());
    return orders;
  }
  return nullptr;
}

struct FacePoint {
  Vec2 point;
  bool isTurned = false;  ///< the file lists it clockwise: its normal is that of the back
};

std::optional<std::size_t> faceIndex(const JsonValue& value, std::size_t count) {
  if (!value.is(Kind::Number) || !(value.number >= 0) ||
      value.number >= static_cast<double>(count) || std::floor(value.number) != value.number) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(value.number);
}

}  // namespace

void addOrders(const JsonValue& document, const FoldFrameView& frame, const FoldGraph& graph,
               PatternFile& file) {
  const JsonValue* orders = ordersFor(document, frame, file.notes);
  if (orders == nullptr || orders->items.empty()) return;
  const std::size_t count = file.drawing.faces.size();
  if (count == 0 || count != graph.faces.size()) {
    file.notes.emplace_back("faceOrders were left out: the file has no faces that they could mean");
    return;
  }
  std::vector<std::optional<FacePoint>> points(count);
  for (std::size_t f = 0; f < count; ++f) {
    if (const std::optional<Vec2> point = pointInside(file.drawing.faces[f])) {
      points[f] = FacePoint{*point, doubledArea(graph, graph.faces[f]) < 0};
    }
  }
  Tally bad;
  for (std::size_t i = 0; i < orders->items.size(); ++i) {
    const std::vector<JsonValue>& triple = orders->items[i].items;
    const bool isTriple = triple.size() == 3 && triple[2].is(Kind::Number);
    const auto f = isTriple ? faceIndex(triple[0], count) : std::nullopt;
    const auto g = isTriple ? faceIndex(triple[1], count) : std::nullopt;
    if (!f || !g || *f == *g || !points[*f] || !points[*g]) {
      bad.add(i);
    } else if (triple[2].number != 0) {
      const bool isFront = (triple[2].number > 0) != points[*g]->isTurned;
      file.drawing.orders.push_back({points[*f]->point, points[*g]->point, isFront});
    }
  }
  bad.tell(file.notes, "face order", "face orders", "that name no two faces of the file; left out");
}

}  // namespace kiri
