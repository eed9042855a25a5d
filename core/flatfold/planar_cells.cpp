// Cycles of pieces, each turning as far left as it can; those around holes are joined to the cell
// that holds them. SPDX-License-Identifier: MIT
#include "core/flatfold/planar_cells.h"

#include <algorithm>
#include <numeric>

#include "core/flatfold/box_tree.h"
#include "core/geometry/orientation.h"

namespace kiri {
namespace {

constexpr std::uint32_t kUnknown = 0xFFFFFFFF;

class Tracing {
 public:
  explicit Tracing(const Arrangement& arrangement)
      : a_(arrangement), firstOut_(a_.points.size() + 1, 0), place_(2 * a_.pieces.size()) {
    const auto codes = static_cast<std::uint32_t>(2 * a_.pieces.size());
    for (std::uint32_t c = 0; c < codes; ++c) ++firstOut_[startOf(c) + 1];
    std::partial_sum(firstOut_.begin(), firstOut_.end(), firstOut_.begin());
    out_.resize(codes);
    std::vector<std::uint32_t> next(firstOut_.begin(), firstOut_.end() - 1);
    for (std::uint32_t c = 0; c < codes; ++c) out_[next[startOf(c)]++] = c;
    for (std::size_t p = 0; p < a_.points.size(); ++p) sortAround(p);
    for (std::uint32_t i = 0; i < codes; ++i) place_[out_[i]] = i;
  }

  std::optional<PlanarCells> trace() {
    traceCycles();
    nameComponents();
    PlanarCells cells;
    cells.corners.emplace_back();
    std::vector<std::uint32_t> cellOfCycle(cycles_.size(), kUnknown);
    std::vector<std::uint32_t> rims;  // cycles around components
    for (std::uint32_t i = 0; i < cycles_.size(); ++i) {
      if (areaOf(a_, cycles_[i]) > 0) {
        cellOfCycle[i] = static_cast<std::uint32_t>(cells.corners.size());
        cells.corners.push_back(cycles_[i]);
      } else {
        rims.push_back(i);
      }
    }
    if (rims.size() != componentCount_ || cycles_.size() != expectedCycles()) return std::nullopt;
    placeRims(rims, cellOfCycle, cells);
    cells.leftOf.resize(cycleOf_.size());
    for (std::size_t c = 0; c < cycleOf_.size(); ++c) cells.leftOf[c] = cellOfCycle[cycleOf_[c]];
    return cells;
  }

 private:
  std::uint32_t startOf(std::uint32_t code) const { return a_.pieces[code / 2][code % 2]; }
  Vec2 directionOf(std::uint32_t code) const {
    return a_.points[startOf(code ^ 1U)] - a_.points[startOf(code)];
  }

  static bool isUpper(Vec2 d) { return d.y > 0 || (d.y == 0 && d.x > 0); }

  void sortAround(std::size_t point) {
    std::sort(out_.begin() + firstOut_[point], out_.begin() + firstOut_[point + 1],
              [&](std::uint32_t a, std::uint32_t b) {
                const bool upperA = isUpper(directionOf(a));
                const bool upperB = isUpper(directionOf(b));
                if (upperA != upperB) return upperA;
                const int turn = orientation(a_.points[point], a_.points[startOf(a ^ 1U)],
                                             a_.points[startOf(b ^ 1U)]);
                return turn != 0 ? turn > 0 : a < b;
              });
  }

  /// Around the cell on the left: the next piece clockwise of the way back.
  std::uint32_t nextOf(std::uint32_t code) const {
    const std::uint32_t back = code ^ 1U;
    const std::uint32_t point = startOf(back);
    const std::uint32_t at = place_[back];
    return at == firstOut_[point] ? out_[firstOut_[point + 1] - 1] : out_[at - 1];
  }

  void traceCycles() {
    cycleOf_.assign(2 * a_.pieces.size(), kUnknown);
    for (std::uint32_t first = 0; first < cycleOf_.size(); ++first) {
      if (cycleOf_[first] != kUnknown) continue;
      std::vector<std::uint32_t> corners;
      for (std::uint32_t c = first; cycleOf_[c] == kUnknown; c = nextOf(c)) {
        cycleOf_[c] = static_cast<std::uint32_t>(cycles_.size());
        corners.push_back(startOf(c));
      }
      cycles_.push_back(std::move(corners));
    }
  }

  void nameComponents() {
    componentOf_.assign(a_.points.size(), kUnknown);
    std::vector<std::uint32_t> todo;
    for (std::uint32_t p = 0; p < a_.points.size(); ++p) {
      if (componentOf_[p] != kUnknown || firstOut_[p] == firstOut_[p + 1]) continue;
      componentOf_[p] = componentCount_;
      todo.push_back(p);
      while (!todo.empty()) {
        const std::uint32_t at = todo.back();
        todo.pop_back();
        ++pointCount_;
        for (std::uint32_t i = firstOut_[at]; i < firstOut_[at + 1]; ++i) {
          const std::uint32_t to = startOf(out_[i] ^ 1U);
          if (componentOf_[to] != kUnknown) continue;
          componentOf_[to] = componentCount_;
          todo.push_back(to);
        }
      }
      ++componentCount_;
    }
  }

  std::size_t expectedCycles() const {
    return a_.pieces.size() + std::size_t{2} * componentCount_ - pointCount_;
  }

  /// Gives each rim the cell that its component lies in: 0, or the cell left of which a ray towards
  /// -x first meets a piece of another component.
  void placeRims(const std::vector<std::uint32_t>& rims, std::vector<std::uint32_t>& cellOfCycle,
                 PlanarCells& cells) const {
    if (rims.size() == 1) {
      cellOfCycle[rims.front()] = 0;
      return;
    }
    std::vector<Box> boxes;
    double left = 0;
    for (const std::array<std::uint32_t, 2>& p : a_.pieces) {
      boxes.push_back(boxOf({a_.points[p[0]], a_.points[p[1]]}));
      left = std::min(left, boxes.back().low.x);
    }
    const BoxTree tree(std::move(boxes));
    // From left to right: what a rim's ray meets belongs to a cell or to a rim that is placed.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> order;  // leftmost point, rim
    for (const std::uint32_t rim : rims) order.emplace_back(leftmostOf(cycles_[rim]), rim);
    std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
      const Vec2 p = a_.points[a.first];
      const Vec2 q = a_.points[b.first];
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
    });
    for (const auto& [point, rim] : order) {
      const std::uint32_t code = pieceLeftOf(tree, point, left);
      const std::uint32_t cell = code == kUnknown ? 0 : cellOfCycle[cycleOf_[code]];
      cellOfCycle[rim] = cell;
      if (cell != 0) joinHole(cells.corners[cell], cycles_[rim]);
    }
  }

  std::uint32_t leftmostOf(const std::vector<std::uint32_t>& corners) const {
    return *std::min_element(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
      const Vec2 p = a_.points[a];
      const Vec2 q = a_.points[b];
      return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
    });
  }

  /// The code, with the point on its left, of the piece of another component that lies nearest to
  /// the left of the point.
  std::uint32_t pieceLeftOf(const BoxTree& tree, std::uint32_t point, double left) const {
    const Vec2 p = a_.points[point];
    std::uint32_t best = kUnknown;
    double bestX = 0;
    double bestLean = 0;
    tree.near({{left, p.y}, p}, 0, [&](std::uint32_t piece) {
      if (componentOf_[a_.pieces[piece][0]] == componentOf_[point]) return;
      const Vec2 a = a_.points[a_.pieces[piece][0]];
      const Vec2 b = a_.points[a_.pieces[piece][1]];
      if ((a.y > p.y) == (b.y > p.y)) return;
      const double x = a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
      // Ends at the height of the point count as below it: of pieces that part there, the one that
      // leans to the right is nearer.
      const double lean = (b.x - a.x) / (b.y - a.y);
      if (x > p.x || (best != kUnknown && (x < bestX || (x == bestX && lean < bestLean)))) return;
      bestX = x;
      bestLean = lean;
      best = 2 * piece + (b.y > a.y ? 1 : 0);
    });
    return best;
  }

  static void joinHole(std::vector<std::uint32_t>& corners,
                       const std::vector<std::uint32_t>& hole) {
    const std::uint32_t bridge = corners.back();
    corners.insert(corners.end(), hole.begin(), hole.end());
    corners.push_back(hole.front());
    corners.push_back(bridge);
  }

  const Arrangement& a_;
  std::vector<std::uint32_t> firstOut_;
  std::vector<std::uint32_t> out_;    ///< codes that leave each point, counter-clockwise
  std::vector<std::uint32_t> place_;  ///< of each code in out_
  std::vector<std::vector<std::uint32_t>> cycles_;
  std::vector<std::uint32_t> cycleOf_;
  std::vector<std::uint32_t> componentOf_;
  std::size_t pointCount_ = 0;  ///< with pieces
  std::uint32_t componentCount_ = 0;
};

}  // namespace

double areaOf(const Arrangement& arrangement, const std::vector<std::uint32_t>& corners) {
  double twice = 0;
  const Vec2 start = arrangement.points[corners.front()];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    twice += cross(arrangement.points[corners[i]] - start,
                   arrangement.points[corners[(i + 1) % corners.size()]] - start);
  }
  return twice / 2;
}

std::optional<PlanarCells> cellsOf(const Arrangement& arrangement) {
  return Tracing(arrangement).trace();
}

}  // namespace kiri
