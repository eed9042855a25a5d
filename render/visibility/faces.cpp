// Makes all sides of one face of the planar map agree about what is seen in it.
// SPDX-License-Identifier: MIT
#include "render/visibility/faces.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "core/geometry/rigid.h"

namespace kiri {
namespace {

/// Half 2i runs along side i, half 2i + 1 against it; each has a face on its left.
class Faces {
 public:
  Faces(const Arrangement& map, std::vector<SeenBeside>& seen) : map_(map), seen_(seen) {}

  /// At each vertex what is entered is left again. Sums of scattered numbers show it.
  bool areBordersClosed() const {
    const auto scattered = [](std::uint32_t facet) {
      std::uint64_t x = (facet + 1ULL) * 0x9E3779B97F4A7C15ULL;
      x ^= x >> 31;
      return x * 0xBF58476D1CE4E5B9ULL;
    };
    std::vector<std::uint64_t> sums(map_.vertices.size(), 0);
    for (std::size_t i = 0; i < map_.sides.size(); ++i) {
      if (seen_[i].left == seen_[i].right) continue;
      const std::uint64_t change = scattered(seen_[i].left) - scattered(seen_[i].right);
      sums[map_.sides[i].from] += change;
      sums[map_.sides[i].to] -= change;
    }
    return std::all_of(sums.begin(), sums.end(), [](std::uint64_t sum) { return sum == 0; });
  }

  void settle() {
    sortAround();
    std::vector<bool> isDone(2 * map_.sides.size(), false);
    for (std::uint32_t start = 0; start < isDone.size(); ++start) {
      if (isDone[start]) continue;
      std::vector<std::uint32_t> round;
      for (std::uint32_t h = start; !isDone[h]; h = next(h)) {
        isDone[h] = true;
        round.push_back(h);
      }
      const std::uint32_t facet = choice(round);
      for (const std::uint32_t h : round) leftOf(h) = facet;
    }
  }

 private:
  std::uint32_t startOf(std::uint32_t h) const {
    const Side& side = map_.sides[h / 2];
    return h % 2 == 0 ? side.from : side.to;
  }
  std::uint32_t& leftOf(std::uint32_t h) {
    return h % 2 == 0 ? seen_[h / 2].left : seen_[h / 2].right;
  }
  double chordOf(std::uint32_t h) const {
    const Arc& arc = map_.sides[h / 2].arc;
    return std::max(distance(arc.start, pointAt(arc, 0.5)), distance(arc.start, arc.end));
  }

  /// The direction in which a half crosses a small circle about its start.
  Vec2 leaving(std::uint32_t h, double radius) const {
    const Arc& side = map_.sides[h / 2].arc;
    const Arc arc = h % 2 == 0 ? side : reversed(side);
    if (!arc.isCurved) return arc.end - arc.start;
    double inside = 0;
    double outside = 0.5;
    constexpr int kHalvings = 40;
    for (int i = 0; i < kHalvings; ++i) {
      const double t = (inside + outside) / 2;
      (distance(pointAt(arc, t), arc.start) < radius ? inside : outside) = t;
    }
    return pointAt(arc, outside) - arc.start;
  }

  /// The halves that leave each vertex, counter-clockwise.
  void sortAround() {
    around_.assign(map_.vertices.size(), {});
    place_.assign(2 * map_.sides.size(), 0);
    for (std::uint32_t h = 0; h < place_.size(); ++h) around_[startOf(h)].push_back(h);
    for (std::vector<std::uint32_t>& halves : around_) {
      double radius = std::numeric_limits<double>::infinity();
      for (const std::uint32_t h : halves) radius = std::min(radius, chordOf(h) / 4);
      std::vector<std::pair<double, std::uint32_t>> order;
      for (const std::uint32_t h : halves) {
        const Vec2 d = leaving(h, radius);
        order.emplace_back(angleDegrees(d.x, d.y), h);
      }
      std::sort(order.begin(), order.end());
      for (std::uint32_t i = 0; i < order.size(); ++i) {
        halves[i] = order[i].second;
        place_[halves[i]] = i;
      }
    }
  }

  /// The half that goes on round the face on the left of h.
  std::uint32_t next(std::uint32_t h) const {
    const std::uint32_t back = h ^ 1U;
    const std::vector<std::uint32_t>& halves = around_[startOf(back)];
    return halves[(place_[back] + halves.size() - 1) % halves.size()];
  }

  /// What is seen along most of the way round.
  std::uint32_t choice(const std::vector<std::uint32_t>& round) {
    std::map<std::uint32_t, double> lengths;
    for (const std::uint32_t h : round) lengths[leftOf(h)] += chordOf(h);
    return std::max_element(lengths.begin(), lengths.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  }

  const Arrangement& map_;
  std::vector<SeenBeside>& seen_;
  std::vector<std::vector<std::uint32_t>> around_;  ///< for each vertex
  std::vector<std::uint32_t> place_;                ///< for each half: in that list
};

}  // namespace

void settleFaces(const Arrangement& map, std::vector<SeenBeside>& seen) {
  Faces faces(map, seen);
  if (!faces.areBordersClosed()) faces.settle();
}

}  // namespace kiri
