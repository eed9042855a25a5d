// Ear clipping with exact predicates, then merging of triangles (Hertel and Mehlhorn 1983).
// SPDX-License-Identifier: MIT
#include "core/geometry/triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/geometry/orientation.h"

namespace kiri {
namespace {

constexpr std::int32_t kNone = -1;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Polygons as half-edges: triangles at first, joined later.
struct Mesh {
  struct HalfEdge {
    Vec2 origin;
    std::int32_t tag = ConvexPart::kInner;
    std::int32_t twin = kNone;
    std::int32_t next = kNone;
    std::int32_t previous = kNone;
    bool isAlive = true;
  };
  std::vector<HalfEdge> edges;

  std::int32_t addTriangle(Vec2 a, Vec2 b, Vec2 c) {
    const auto first = static_cast<std::int32_t>(edges.size());
    edges.push_back({a, ConvexPart::kInner, kNone, first + 1, first + 2});
    edges.push_back({b, ConvexPart::kInner, kNone, first + 2, first});
    edges.push_back({c, ConvexPart::kInner, kNone, first, first + 1});
    return first;
  }
  HalfEdge& operator[](std::int32_t i) { return edges[at(i)]; }
  const HalfEdge& operator[](std::int32_t i) const { return edges[at(i)]; }
  Vec2 targetOf(std::int32_t i) const { return (*this)[(*this)[i].next].origin; }
};

/// Cuts a ring into triangles, one ear at a time. Earness changes only at the neighbours of a
/// clipped ear, so each clip costs two tests against the corners that are not convex: O(n^2) in
/// all.
class EarClipper {
 public:
  EarClipper(const Ring& ring, Trust trust)
      : ring_(ring), nodes_(ring.size()), remaining_(ring.size()), trust_(trust) {
    const auto n = static_cast<std::int32_t>(ring.size());
    std::int32_t bridges = 0;
    for (const Corner& corner : ring) bridges = std::max(bridges, corner.bridge + 1);
    links_.resize(at(bridges), kNone);
    for (std::int32_t i = 0; i < n; ++i) {
      const Corner& corner = ring[at(i)];
      nodes_[at(i)] = {corner.point, corner.tag, corner.bridge, (i + n - 1) % n, (i + 1) % n};
    }
    for (std::int32_t i = 0; i < n; ++i) {
      if (turnAt(i) <= 0) blockers_.push_back(i);
    }
  }

  Mesh clipAll() {
    std::int32_t i = 0;
    std::size_t idle = 0;
    while (remaining_ > 2) {
      Node& node = nodes_[at(i)];
      if (pointOf(node.previous) == pointOf(node.next)) {
        i = dropSpike(i);
        idle = 0;
        continue;
      }
      if (node.kind == Kind::Unknown) node.kind = kindOf(i);
      if (node.kind == Kind::Ear) {
        const std::int32_t after = node.next;
        clip(i);
        i = nodes_[at(after)].next;  // skipping one makes for fewer slender triangles
        idle = 0;
        continue;
      }
      i = node.next;
      if (++idle > remaining_) {
        i = leastBadEar(i);
        const std::int32_t after = nodes_[at(i)].next;
        canClip(i) ? clip(i) : leaveOut(i);
        i = after;
        idle = 0;
      }
    }
    if (remaining_ == 2) joinSides(i, nodes_[at(i)].next);
    return std::move(mesh_);
  }

 private:
  enum class Kind : std::uint8_t {
    Unknown,
    Ear,
    Touching,  ///< an ear but for corners that lie on its inner side
    Blocked,
  };
  struct Node {
    Vec2 point;
    std::int32_t tag = ConvexPart::kInner;
    std::int32_t link = kNone;  ///< inner side: the pair of half-edges to which it will belong
    std::int32_t previous = kNone;
    std::int32_t next = kNone;
    Kind kind = Kind::Unknown;
    bool isGone = false;
  };

  Vec2 pointOf(std::int32_t i) const { return nodes_[at(i)].point; }

  int turnAt(std::int32_t i) const {
    const Node& node = nodes_[at(i)];
    return orientation(pointOf(node.previous), node.point, pointOf(node.next));
  }

  /// What stands in the way of cutting corner i off.
  Kind kindOf(std::int32_t i) const {
    const Node& node = nodes_[at(i)];
    const Vec2 a = pointOf(node.previous);
    const Vec2 b = node.point;
    const Vec2 c = pointOf(node.next);
    if (orientation(a, b, c) <= 0) return Kind::Blocked;
    const double left = std::min({a.x, b.x, c.x});
    const double right = std::max({a.x, b.x, c.x});
    const double bottom = std::min({a.y, b.y, c.y});
    const double top = std::max({a.y, b.y, c.y});
    Kind kind = Kind::Ear;
    for (const std::int32_t w : blockers_) {
      const Node& other = nodes_[at(w)];
      const Vec2 p = other.point;
      if (p.x < left || p.x > right || p.y < bottom || p.y > top) continue;
      if (other.isGone || w == i || w == node.previous || w == node.next) continue;
      const Kind found = kindOfBlocker(a, b, c, other);
      if (found == Kind::Blocked) return found;
      if (found == Kind::Touching) kind = found;
    }
    if (trust_ == Trust::MayCross && (isCrossed(a, c, i) || !isPaper(a, b, c)))
      return Kind::Blocked;
    return kind;
  }

  /// True when the ring as it was at first winds around the middle of the triangle. Where it
  /// crosses itself there are parts inside out, and what looks like their ears lies outside of the
  /// paper.
  bool isPaper(Vec2 a, Vec2 b, Vec2 c) const {
    const Vec2 middle = (a + b + c) / 3;
    int winding = 0;
    Vec2 p = ring_.back().point;
    for (const Corner& corner : ring_) {
      const Vec2 q = corner.point;
      const bool isBelow = middle.y < p.y;
      if (isBelow != (middle.y < q.y)) {
        const int side = isBelow ? orientation(q, p, middle) : orientation(p, q, middle);
        if (side > 0) winding += isBelow ? -1 : 1;
      }
      p = q;
    }
    return winding > 0;
  }

  /// True when a side of the ring, wherever its ends are, crosses the segment. Sides start after
  /// node `start`.
  bool isCrossed(Vec2 a, Vec2 c, std::int32_t start) const {
    std::int32_t i = nodes_[at(start)].next;
    Vec2 p = pointOf(i);
    int sideOfP = orientation(a, c, p);
    for (std::size_t k = 2; k < remaining_; ++k) {
      i = nodes_[at(i)].next;
      const Vec2 q = pointOf(i);
      const int sideOfQ = orientation(a, c, q);
      if (sideOfP * sideOfQ < 0 && orientation(p, q, a) * orientation(p, q, c) < 0) return true;
      p = q;
      sideOfP = sideOfQ;
    }
    return false;
  }

  /// Ear: the corner `other` is not in the way of cutting off the triangle a b c.
  Kind kindOfBlocker(Vec2 a, Vec2 b, Vec2 c, const Node& other) const {
    const std::array<std::pair<Vec2, Vec2>, 3> sides{{{a, b}, {b, c}, {c, a}}};
    std::array<int, 3> side{};
    for (std::size_t k = 0; k < 3; ++k) {
      side[k] = orientation(sides[k].first, sides[k].second, other.point);
      if (side[k] < 0) return Kind::Ear;
    }
    if (side[0] > 0 && side[1] > 0) return side[2] > 0 ? Kind::Blocked : Kind::Touching;
    // On one of the two outer sides or at a corner: in the way only if the ring goes on into the
    // triangle.
    for (const std::int32_t neighbour : {other.previous, other.next}) {
      bool entersHere = true;
      for (std::size_t k = 0; k < 3; ++k) {
        if (side[k] > 0) continue;
        entersHere =
            entersHere && orientation(sides[k].first, sides[k].second, pointOf(neighbour)) > 0;
      }
      if (entersHere) return Kind::Blocked;
    }
    return Kind::Ear;
  }

  void clip(std::int32_t i) {
    const Node node = nodes_[at(i)];
    const std::int32_t h =
        mesh_.addTriangle(pointOf(node.previous), node.point, pointOf(node.next));
    attach(nodes_[at(node.previous)], h);
    attach(node, h + 1);
    Node& before = nodes_[at(node.previous)];
    before.tag = ConvexPart::kInner;
    before.link = static_cast<std::int32_t>(links_.size());
    links_.push_back(h + 2);
    remove(i);
  }

  /// Takes node i out of the ring; its neighbours must be looked at again.
  void remove(std::int32_t i) {
    Node& node = nodes_[at(i)];
    nodes_[at(node.previous)].next = node.next;
    nodes_[at(node.next)].previous = node.previous;
    nodes_[at(node.previous)].kind = Kind::Unknown;
    nodes_[at(node.next)].kind = Kind::Unknown;
    node.isGone = true;
    --remaining_;
    if (++goneSinceTidy_ * 4 > blockers_.size()) tidyBlockers();
  }

  /// Forgets corners that are gone or have become convex.
  void tidyBlockers() {
    goneSinceTidy_ = 0;
    const auto isHarmless = [&](std::int32_t w) { return nodes_[at(w)].isGone || turnAt(w) > 0; };
    blockers_.erase(std::remove_if(blockers_.begin(), blockers_.end(), isHarmless),
                    blockers_.end());
  }

  /// Half-edge h runs along the side that leaves `node`.
  void attach(const Node& node, std::int32_t h) {
    if (node.link == kNone) {
      mesh_[h].tag = node.tag;
      return;
    }
    std::int32_t& waiting = links_[at(node.link)];
    if (waiting == kNone) {
      waiting = h;
    } else {
      pair(waiting, h);
    }
  }

  void pair(std::int32_t g, std::int32_t h) {
    mesh_[g].twin = h;
    mesh_[h].twin = g;
  }

  /// The sides that leave i and j run along the same points, forth and back, with nothing between.
  void joinSides(std::int32_t i, std::int32_t j) {
    const Node& a = nodes_[at(i)];
    const Node& b = nodes_[at(j)];
    const std::int32_t g = a.link == kNone ? kNone : links_[at(a.link)];
    const std::int32_t h = b.link == kNone ? kNone : links_[at(b.link)];
    if (g != kNone && h != kNone) {
      if (g != h) pair(g, h);
    } else if (g != kNone) {
      mesh_[g].tag = b.tag;
    } else if (h != kNone) {
      mesh_[h].tag = a.tag;
    }
  }

  /// Corner i is a tip: the ring comes and goes along the same points. Returns where to go on.
  std::int32_t dropSpike(std::int32_t i) {
    const std::int32_t before = nodes_[at(i)].previous;
    const std::int32_t after = nodes_[at(i)].next;
    joinSides(before, i);
    remove(i);
    if (remaining_ == 2) {
      remaining_ = 0;
      return after;
    }
    // Two nodes lie at one point now: the first goes, the second keeps its own side.
    remove(before);
    if (turnAt(after) <= 0) blockers_.push_back(after);
    return after;
  }

  bool canClip(std::int32_t i) const {
    const Node& node = nodes_[at(i)];
    return turnAt(i) > 0 && (trust_ == Trust::Simple ||
                             isPaper(pointOf(node.previous), node.point, pointOf(node.next)));
  }

  /// Takes a corner away whose triangle lies outside of the paper.
  void leaveOut(std::int32_t i) {
    Node& before = nodes_[at(nodes_[at(i)].previous)];
    before.tag = ConvexPart::kInner;
    before.link = kNone;
    remove(i);
  }

  /// For rings that touch or cross themselves: the corner that changes least when cut off.
  std::int32_t leastBadEar(std::int32_t start) const {
    std::int32_t best = start;
    double bestArea = std::numeric_limits<double>::infinity();
    std::int32_t i = start;
    for (std::size_t k = 0; k < remaining_; ++k, i = nodes_[at(i)].next) {
      const Node& node = nodes_[at(i)];
      if (node.kind == Kind::Touching) return i;
      const Vec2 before = pointOf(node.previous);
      const double area = std::abs(cross(node.point - before, pointOf(node.next) - before));
      if (area < bestArea) {
        best = i;
        bestArea = area;
      }
    }
    return best;
  }

  const Ring& ring_;
  std::vector<Node> nodes_;
  std::size_t remaining_;
  Trust trust_;
  std::vector<std::int32_t> blockers_;  ///< corners that are not convex; some may be gone
  std::size_t goneSinceTidy_ = 0;
  std::vector<std::int32_t> links_ =
      {};  ///< for each inner side: the half-edge that waits for its twin
  Mesh mesh_ = {};
};

/// True when before, corner, after may follow each other on the border of a convex polygon.
bool turnsLeft(Vec2 before, Vec2 corner, Vec2 after) {
  const int turn = orientation(before, corner, after);
  return turn > 0 || (turn == 0 && dot(before - corner, after - corner) < 0);
}

/// Removes diagonals, the longest first, wherever both of their ends stay convex.
void mergeTriangles(Mesh& mesh) {
  std::vector<std::pair<double, std::int32_t>> diagonals;
  for (std::int32_t h = 0; at(h) < mesh.edges.size(); ++h) {
    if (mesh[h].twin <= h) continue;
    const Vec2 d = mesh.targetOf(h) - mesh[h].origin;
    diagonals.emplace_back(-dot(d, d), h);
  }
  std::sort(diagonals.begin(), diagonals.end());
  for (const auto& [size, h] : diagonals) {
    const std::int32_t t = mesh[h].twin;
    const Mesh::HalfEdge forth = mesh[h];
    const Mesh::HalfEdge back = mesh[t];
    if (!turnsLeft(mesh[forth.previous].origin, forth.origin, mesh.targetOf(back.next)) ||
        !turnsLeft(mesh[back.previous].origin, mesh.targetOf(h), mesh.targetOf(forth.next))) {
      continue;
    }
    mesh[forth.previous].next = back.next;
    mesh[back.next].previous = forth.previous;
    mesh[back.previous].next = forth.next;
    mesh[forth.next].previous = back.previous;
    mesh[h].isAlive = false;
    mesh[t].isAlive = false;
  }
}

bool isConvexRing(const Ring& ring) {
  const auto pointsUp = [](Vec2 d) { return d.y > 0 || (d.y == 0 && d.x > 0); };
  int turns = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i].point;
    const Vec2 b = ring[(i + 1) % ring.size()].point;
    const Vec2 c = ring[(i + 2) % ring.size()].point;
    if (!turnsLeft(a, b, c)) return false;
    if (pointsUp(b - a) != pointsUp(c - b)) ++turns;
  }
  return turns == 2;
}

}  // namespace

std::vector<ConvexPart> convexPartsOf(const Ring& ring, Trust trust) {
  std::vector<ConvexPart> parts;
  if (ring.size() < 3) return parts;
  if (isConvexRing(ring)) {
    parts.resize(1);
    for (const Corner& corner : ring) {
      parts[0].points.push_back(corner.point);
      parts[0].tags.push_back(corner.tag);
    }
    return parts;
  }
  Mesh mesh = EarClipper(ring, trust).clipAll();
  mergeTriangles(mesh);
  for (std::int32_t h = 0; at(h) < mesh.edges.size(); ++h) {
    if (!mesh[h].isAlive) continue;
    ConvexPart part;
    for (std::int32_t g = h; mesh[g].isAlive; g = mesh[g].next) {
      mesh[g].isAlive = false;
      part.points.push_back(mesh[g].origin);
      part.tags.push_back(mesh[g].tag);
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace kiri
