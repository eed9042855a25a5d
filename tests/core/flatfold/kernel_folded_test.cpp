// Paper folded at random by the kernel: its pattern has the overlaps, and allows the layer order,
// of the state that it was folded to.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>

#include "core/flatfold/folded_ground.h"
#include "core/flatfold/layer_states.h"
#include "core/model/apply.h"
#include "tests/support/model_text.h"
#include "tests/support/order_check.h"
#include "tests/support/plane_overlap.h"
#include "tests/support/random_steps.h"
#include "tests/support/sanitized.h"

namespace kiri::test {
namespace {

constexpr std::uint64_t kModels = casesOf<std::uint64_t>(150, 15);

bool hasCurves(const FoldedState& state) {
  return std::any_of(state.pattern.edges.begin(), state.pattern.edges.end(),
                     [](const Edge& e) { return e.isCurved(); });
}

/// Only what lies flat, in one piece, without having passed through itself.
bool isUsable(const FoldedState& state) {
  return isFlat(state) && state.collisions.empty() && state.rests.size() == 1 &&
         !hasCurves(state) && state.pattern.facets.size() > 1 && orderViolations(state).empty();
}

/// Calls `check` with flat states of models grown from random steps.
void forFoldedStates(const RandomStepOptions& options,
                     const std::function<void(const FoldedState&, const std::string&)>& check) {
  for (std::uint64_t seed = 1; seed <= kModels; ++seed) {
    Random random(seed);
    Model model = randomSheet(random);
    FoldedState state = startOf(model);
    for (int tries = 0; tries < 60 && model.steps.size() < 8; ++tries) {
      const Step step = randomStep(random, state, options);
      Result<FoldedState> next = apply(state, step, static_cast<int>(model.steps.size()) + 1);
      if (!next || next->rests.size() != 1 || !next->collisions.empty() || hasCurves(*next))
        continue;
      model.steps.push_back(step);
      state = std::move(next).value();
      if (isUsable(state)) check(state, "seed " + std::to_string(seed) + "\n" + textOf(model));
    }
  }
}

AssignedPattern patternOfState(const FoldedState& state) {
  AssignedPattern creases(state.pattern);
  for (const Edge& e : state.pattern.edges) {
    Assignment a = Assignment::Border;
    if (e.kind == EdgeKind::Hinge)
      a = e.angle > 0 ? Assignment::Valley : e.angle < 0 ? Assignment::Mountain : Assignment::Flat;
    else if (e.kind != EdgeKind::Border)
      a = Assignment::Cut;
    creases.assignments.push_back(a);
  }
  return creases;
}

/// Overlap by slabs of the facets as the kernel placed them.
class Overlaps {
 public:
  explicit Overlaps(const FoldedState& state) : size_(state.tolerance().sheetSize()) {
    const PlaneFrame frame = frameOf({0, 0, 1}, {0, 0, 0});
    for (std::size_t f = 0; f < state.pattern.facets.size(); ++f)
      loops_.push_back(placed(flatLoopsOf(state.pattern, FacetId(f)), state.poses[f], frame));
  }

  Common common(const std::vector<FacetId>& facets) const {
    std::vector<const Loops*> polygons;
    for (const FacetId f : facets) polygons.push_back(&loops_[f.index]);
    return commonOf(polygons);
  }
  bool isFat(const Common& c) const { return c.fatness() > 1e-7 * size_; }
  bool isNothing(const Common& c) const { return c.area < 1e-9 * size_ * size_; }

 private:
  double size_;
  std::vector<Loops> loops_;
};

FacetId largestOf(const FoldedState& state) {
  FacetId best(0);
  for (std::size_t f = 1; f < state.pattern.facets.size(); ++f) {
    if (areaOf(regionOf(state.pattern, FacetId(f))) > areaOf(regionOf(state.pattern, best)) + 1e-12)
      best = FacetId(f);
  }
  return best;
}

LayerValues valuesOf(const FoldedState& state, const FlatMap& map, const OrderProblem& problem) {
  // "Above" is meant along the normal of a facet that the map leaves face up.
  const FacetId largest = largestOf(state);
  const Vec3 up = map.poses[largest.index].isFlipped ? -state.poseOf(largest).normal()
                                                     : state.poseOf(largest).normal();
  LayerValues values;
  for (const FacetPair& pair : problem.pairs) {
    const LayerSet& set = state.layers.sets()[state.layers.setOf(pair.a)];
    values.push_back(state.layers.isAbove(pair.a, pair.b) == (dot(set.normal, up) > 0));
  }
  return values;
}

bool isTrue(const LayerValues& values, Literal l) { return values[l.pair()] != l.isNegated(); }

/// Every rule, looked at without the search's own code.
void expectAllRulesHold(const OrderProblem& problem, const LayerValues& values) {
  for (const Literal l : problem.known) EXPECT_TRUE(isTrue(values, l));
  for (const SameOrder& s : problem.same)
    EXPECT_EQ(isTrue(values, s.first), isTrue(values, s.second));
  for (const Interleaving& i : problem.interleavings) {
    const int count =
        isTrue(values, i.ac) + isTrue(values, i.bc) + isTrue(values, i.ad) + isTrue(values, i.bd);
    EXPECT_EQ(count % 2, 0);
  }
}

void expectSameOverlaps(const FoldedState& state, const OrderProblem& problem) {
  const Overlaps overlaps(state);
  for (std::uint32_t a = 0; a < problem.facetCount; ++a) {
    for (std::uint32_t b = a + 1; b < problem.facetCount; ++b) {
      const Common common = overlaps.common({FacetId(a), FacetId(b)});
      const bool isPair = problem.indexOf(FacetId(a), FacetId(b)) != OrderProblem::kNone;
      if (overlaps.isFat(common)) EXPECT_TRUE(isPair) << a << " and " << b;
      if (overlaps.isNothing(common)) EXPECT_FALSE(isPair) << a << " and " << b;
    }
  }
}

/// Stacks are common ground, none is part of another, and every triple that has common ground is in
/// one of them.
void expectTrueStacks(const FoldedState& state, const OrderProblem& problem) {
  const Overlaps overlaps(state);
  const FacetSets& stacks = problem.stacks;
  for (std::size_t s = 0; s < stacks.size(); ++s) {
    EXPECT_FALSE(overlaps.isNothing(overlaps.common({stacks.begin(s), stacks.end(s)})));
    for (std::size_t t = 0; t < stacks.size(); ++t) {
      if (s != t)
        EXPECT_FALSE(std::includes(stacks.begin(t), stacks.end(t), stacks.begin(s), stacks.end(s)));
    }
  }
  for (std::uint32_t a = 0; a < problem.facetCount; ++a) {
    for (std::uint32_t b = a + 1; b < problem.facetCount; ++b) {
      if (problem.indexOf(FacetId(a), FacetId(b)) == OrderProblem::kNone) continue;
      for (std::uint32_t c = b + 1; c < problem.facetCount; ++c) {
        const std::vector<FacetId> triple{FacetId(a), FacetId(b), FacetId(c)};
        if (!overlaps.isFat(overlaps.common(triple))) continue;
        bool isFound = false;
        for (std::size_t s = 0; s < stacks.size() && !isFound; ++s)
          isFound = std::includes(stacks.begin(s), stacks.end(s), triple.begin(), triple.end());
        EXPECT_TRUE(isFound) << a << ", " << b << ", " << c;
      }
    }
  }
}

TEST(KernelFolded, PaperHasItsOverlapsAndAllowsItsLayerOrder) {
  RandomStepOptions options;
  options.hasAngles = false;
  options.facetLimit = 30;
  std::size_t states = 0;
  std::map<std::string, std::size_t> met;
  forFoldedStates(options, [&](const FoldedState& state, const std::string& story) {
    SCOPED_TRACE(story);
    const AssignedPattern creases = patternOfState(state);
    const Result<FlatMap> map = flatMapOf(creases);
    ASSERT_TRUE(map.isOk()) << map.error().message;
    const Result<GroundAndOrders> ground = overlapsOf(creases, *map);
    ASSERT_TRUE(ground.isOk()) << ground.error().message;
    const OrderProblem& problem = ground->problem;
    const LayerValues values = valuesOf(state, *map, problem);
    expectSameOverlaps(state, problem);
    if (problem.facetCount <= 14) expectTrueStacks(state, problem);
    expectAllRulesHold(problem, values);
    EXPECT_EQ(brokenRule(problem, values), std::nullopt);
    ++states;
    met["interleaving"] += problem.interleavings.size();
    met["same"] += problem.same.size();
    for (const Edge& e : creases.pattern.edges) {
      if (e.kind == EdgeKind::Cut || e.kind == EdgeKind::Tear) ++met["cut"];
      if (e.kind == EdgeKind::Hinge && e.angle == 0) ++met["flat"];
    }
  });
  // The models have all that a rule may be about.
  EXPECT_GT(states, 2 * kModels);
  for (const char* kind : {"interleaving", "same", "cut", "flat"}) EXPECT_GT(met[kind], kModels);
}

}  // namespace
}  // namespace kiri::test
