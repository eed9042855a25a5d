// SPDX-License-Identifier: MIT
#include "tests/core/flatfold/small_patterns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/model/apply.h"
#include "core/model/model.h"
#include "tests/core/flatfold/flat_patterns.h"
#include "tests/support/order_check.h"
#include "tests/support/pattern_text.h"
#include "tests/support/plane_overlap.h"

namespace kiri::test {
namespace {

constexpr std::size_t kMost = 8;

/// The creases of a state, with some directions forgotten or turned.
AssignedPattern creasesOf(const CreasePattern& pattern, Random& random) {
  AssignedPattern creases(pattern);
  const double forget = random.chance(0.3) ? 1 : random.unit();
  const double turn = random.chance(0.7) ? 0 : 0.2;
  for (Edge& edge : creases.pattern.edges) {
    Assignment assignment = Assignment::Border;
    if (edge.kind == EdgeKind::Hinge && edge.angle == 0) {
      assignment = Assignment::Flat;
    } else if (edge.kind == EdgeKind::Hinge) {
      if (random.chance(turn)) edge.angle = -edge.angle;
      assignment = edge.angle > 0 ? Assignment::Valley : Assignment::Mountain;
      if (random.chance(forget)) {
        assignment = Assignment::Unassigned;
        edge.angle = 180;
      }
    }
    creases.assignments.push_back(assignment);
  }
  return creases;
}

CreasePattern byFolding(Random& random) {
  for (;;) {
    FoldedState state = flatState(*squareSheet(100));
    const RandomStepOptions options{false, false, false, kMost};
    for (std::size_t n = 2 + random.below(5); n-- > 0;) {
      Result<FoldedState> next = apply(state, randomStep(random, state, options), 1);
      if (next.isOk() && isFlat(*next) && next->pattern.facets.size() <= kMost) {
        state = std::move(*next);
      }
    }
    if (state.pattern.facets.size() > 1) return state.pattern;
  }
}

/// Alternate sectors add up to half a turn.
CreasePattern oneVertex(Random& random) {
  const std::size_t half = 2 + random.below(kMost / 2 - 1);
  std::vector<double> sectors;
  do {
    sectors.clear();
    std::array<double, 2> sums{0, 0};
    for (std::size_t i = 0; i < 2 * half; ++i) {
      const bool isRound = random.chance(0.5);
      sectors.push_back(isRound ? 1 + static_cast<double>(random.below(3))
                                : random.between(0.5, 3));
      sums[i % 2] += sectors.back();
    }
    for (std::size_t i = 0; i < sectors.size(); ++i) sectors[i] *= std::numbers::pi / sums[i % 2];
    // The rim of a wider sector would pass the wrong side of the vertex.
  } while (*std::max_element(sectors.begin(), sectors.end()) > 3);
  CreasePattern pattern = starOf(sectors).pattern;
  for (Edge& edge : pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) edge.angle = random.chance(0.5) ? 180 : -180;
  }
  return pattern;
}

CreasePattern strip(Random& random) {
  const std::size_t facets = 2 + random.below(kMost - 1);
  std::vector<Vec2> vertices;
  std::vector<DrawnEdge> edges;
  double x = 0;
  for (std::size_t i = 0; i <= facets; ++i) {
    vertices.push_back({x, 0});
    vertices.push_back({x, 10});
    const bool isRim = i == 0 || i == facets;
    const bool isFlatCrease = random.chance(0.15);
    const double angle = isFlatCrease ? 0 : random.chance(0.5) ? 180 : -180;
    edges.push_back({2 * i, 2 * i + 1, EdgeKind::Hinge, isRim ? 0 : angle});
    if (i > 0) {
      edges.push_back({2 * i - 2, 2 * i});
      edges.push_back({2 * i - 1, 2 * i + 1});
    }
    x += random.chance(0.7) ? 5 * static_cast<double>(1 + random.below(3)) : random.between(4, 20);
  }
  return drawnState(vertices, edges).pattern;
}

}  // namespace

AssignedPattern smallPattern(Random& random) {
  const double pick = random.unit();
  return creasesOf(pick < 0.4   ? byFolding(random)
                   : pick < 0.7 ? oneVertex(random)
                                : strip(random),
                   random);
}

namespace {

class OrderTrial {
 public:
  OrderTrial(const AssignedPattern& creases, FacetId rest, std::size_t limit)
      : creases_(creases), state_(creases.pattern), limit_(limit) {
    state_.rests = {{rest, Rigid{}}};
    state_.poses = derivePoses(state_.pattern, state_.rests);
    const PlaneFrame frame{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (std::size_t f = 0; f < state_.poses.size(); ++f) {
      loops_.push_back(placed(flatLoopsOf(state_.pattern, FacetId(f)), state_.poses[f], frame));
      for (std::size_t g = 0; g < f; ++g) {
        placeOf_[g][f] = placeOf_[f][g] = order_.size();
        isOverlap_[g][f] = isOverlap_[f][g] = isFat({&loops_[g], &loops_[f]});
        if (isOverlap_[g][f]) order_.push_back({FacetId(g), FacetId(f), false});
      }
    }
  }

  std::optional<std::vector<WholeOrder>> run() {
    tryFrom(0);
    if (judged_ > limit_) return std::nullopt;
    return found_;
  }

 private:
  bool isFat(const std::vector<const Loops*>& loops) const {
    return commonOf(loops).fatness() > 1e-6 * state_.tolerance().sheetSize();
  }

  bool isAbove(std::size_t f, std::size_t g) const {
    return order_[placeOf_[f][g]].isAbove == (f < g);
  }

  void tryFrom(std::size_t place) {
    if (judged_ > limit_) return;
    if (place == order_.size()) return judge();
    for (const bool isAboveNow : {false, true}) {
      order_[place].isAbove = isAboveNow;
      if (fits(place)) tryFrom(place + 1);
    }
  }

  /// No ring with what was placed before, no crease turned the wrong way.
  bool fits(std::size_t place) const {
    const std::size_t f = order_[place].a.index;
    const std::size_t g = order_[place].b.index;
    for (const Edge& edge : state_.pattern.edges) {
      const bool isBetween = (edge.left.index == f && edge.right.index == g) ||
                             (edge.left.index == g && edge.right.index == f);
      if (!isBetween || edge.kind != EdgeKind::Hinge) continue;
      const Assignment assignment =
          creases_.of(EdgeId(static_cast<std::size_t>(&edge - state_.pattern.edges.data())));
      const bool isValley = angleOf(edge) > 0;
      if (assignment == Assignment::Valley && !isValley) return false;
      if (assignment == Assignment::Mountain && isValley) return false;
    }
    for (std::size_t h = 0; h < loops_.size(); ++h) {
      if (h == f || h == g || !isOverlap_[f][h] || !isOverlap_[g][h]) continue;
      if (placeOf_[f][h] > place || placeOf_[g][h] > place) continue;
      const bool isRing = isAbove(f, g) == isAbove(g, h) && isAbove(g, h) == isAbove(h, f);
      if (isRing && isFat({&loops_[f], &loops_[g], &loops_[h]})) return false;
    }
    return true;
  }

  double angleOf(const Edge& edge) const {
    const bool isLeftUp = state_.poses[edge.left.index].normal().z > 0;
    return isAbove(edge.right.index, edge.left.index) == isLeftUp ? 180 : -180;
  }

  void judge() {
    if (++judged_ > limit_) return;
    for (std::size_t e = 0; e < state_.pattern.edges.size(); ++e) {
      if (creases_.isFolded(EdgeId(e))) {
        state_.pattern.edges[e].angle = angleOf(state_.pattern.edges[e]);
      }
    }
    LayerSet set{{0, 0, 1}, {}, {}};
    for (std::size_t f = 0; f < loops_.size(); ++f) set.upward.push_back(FacetId(f));
    for (const OrderedPair& pair : order_) {
      if (pair.isAbove) set.exceptions.insert({pair.a, pair.b});
    }
    state_.layers = LayerOrder({set});
    if (orderViolations(state_).empty()) found_.push_back(order_);
  }

  const AssignedPattern& creases_;
  FoldedState state_;
  std::size_t limit_;
  std::vector<Loops> loops_;
  std::array<std::array<std::size_t, kMost>, kMost> placeOf_{};
  std::array<std::array<bool, kMost>, kMost> isOverlap_{};
  WholeOrder order_;
  std::size_t judged_ = 0;
  std::vector<WholeOrder> found_;
};

}  // namespace

std::optional<std::vector<WholeOrder>> ordersByTrying(const AssignedPattern& creases, FacetId rest,
                                                      std::size_t limit) {
  return OrderTrial(creases, rest, limit).run();
}

}  // namespace kiri::test
