// The rules around a vertex, against every order of its layers.
// SPDX-License-Identifier: MIT
#include "core/flatfold/local_conditions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "tests/core/flatfold/flat_patterns.h"

namespace kiri {
namespace {

using Mask = std::uint32_t;

/// A vertex folded flat is a closed zigzag on a circle: sector i lies between creases i and i + 1,
/// its front up when i is even.
class Zigzag {
 public:
  explicit Zigzag(const std::vector<int>& sectors) : count_(sectors.size()) {
    int at = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      crease_.push_back(at);
      at += i % 2 == 0 ? sectors[i] : -sectors[i];
    }
    crease_.push_back(at);
  }

  /// The choices of valleys (bit i: crease i) for which an order of the layers exists.
  std::set<Mask> foldable() const {
    std::set<Mask> found;
    std::vector<int> height(count_);
    std::iota(height.begin(), height.end(), 0);
    do {
      if (isFree(height)) found.insert(valleysOf(height));
    } while (std::next_permutation(height.begin(), height.end()));
    return found;
  }

 private:
  std::size_t before(std::size_t crease) const { return (crease + count_ - 1) % count_; }
  /// True when the sectors at a crease lie on its right.
  bool isOnRight(std::size_t crease) const { return crease % 2 == 0; }

  static bool isBetween(int x, int a, int b) { return std::min(a, b) < x && x < std::max(a, b); }

  bool isFree(const std::vector<int>& height) const {
    for (std::size_t c = 0; c < count_; ++c) {
      const int low = height[before(c)];
      const int high = height[c];
      for (std::size_t s = 0; s < count_; ++s) {
        if (isBetween(crease_[c], crease_[s], crease_[s + 1]) && isBetween(height[s], low, high))
          return false;
      }
      for (std::size_t d = c + 1; d < count_; ++d) {
        if (crease_[c] != crease_[d] || isOnRight(c) != isOnRight(d)) continue;
        if (isBetween(height[d], low, high) != isBetween(height[before(d)], low, high))
          return false;
      }
    }
    return true;
  }

  Mask valleysOf(const std::vector<int>& height) const {
    Mask valleys = 0;
    for (std::size_t c = 0; c < count_; ++c) {
      const std::size_t turned = c % 2 == 1 ? c : before(c);
      const std::size_t faceUp = c % 2 == 1 ? before(c) : c;
      if (height[turned] > height[faceUp]) valleys |= Mask{1} << c;
    }
    return valleys;
  }

  std::size_t count_;
  std::vector<int> crease_;
};

AssignedPattern vertexOf(const std::vector<int>& sectors, double unit = 15) {
  std::vector<double> radians;
  for (const int s : sectors) radians.push_back(s * unit * std::numbers::pi / 180);
  AssignedPattern creases(test::starOf(radians).pattern);
  for (std::size_t e = 0; e < creases.pattern.edges.size(); ++e) {
    const bool isCrease = creases.pattern.edges[e].kind == EdgeKind::Hinge;
    creases.assignments.push_back(isCrease ? Assignment::Unassigned : Assignment::Border);
    if (isCrease) creases.pattern.edges[e].angle = 180;
  }
  return creases;
}

void choose(AssignedPattern& creases, std::size_t degree, Mask valleys, Mask open = 0) {
  for (std::size_t c = 0; c < degree; ++c) {
    const Mask bit = Mask{1} << c;
    test::assign(creases, EdgeId(c),
                 (open & bit) != 0      ? Assignment::Unassigned
                 : (valleys & bit) != 0 ? Assignment::Valley
                                        : Assignment::Mountain);
  }
}

/// Sectors in units of 15 degrees whose alternate sums are 180.
std::vector<int> randomSectors(std::mt19937& random, std::size_t degree) {
  const auto parts = [&] {
    std::vector<int> sizes(degree / 2, 1);
    for (std::size_t rest = 12 - sizes.size(); rest > 0; --rest) ++sizes[random() % sizes.size()];
    return sizes;
  };
  const std::vector<int> even = parts();
  const std::vector<int> odd = parts();
  std::vector<int> sectors;
  for (std::size_t i = 0; i < even.size(); ++i) {
    sectors.push_back(even[i]);
    sectors.push_back(odd[i]);
  }
  return sectors;
}

std::size_t foldableChoices(const std::vector<int>& sectors, double unit) {
  AssignedPattern creases = vertexOf(sectors, unit);
  std::size_t count = 0;
  for (Mask valleys = 0; valleys < Mask{1} << sectors.size(); ++valleys) {
    choose(creases, sectors.size(), valleys);
    if (vertexFaults(creases).empty()) ++count;
  }
  return count;
}

TEST(VertexFaults, LeaveTheKnownNumbersOfMountainsAndValleys) {
  EXPECT_EQ(foldableChoices({1, 1, 1, 1}, 90), 8U);
  EXPECT_EQ(foldableChoices({1, 1, 1, 1, 1, 1}, 60), 30U);
  EXPECT_EQ(foldableChoices({1, 1, 1, 1, 1, 1, 1, 1}, 45), 112U);
  EXPECT_EQ(foldableChoices({4, 4, 8, 8}, 15), 6U);
  EXPECT_EQ(foldableChoices({3, 6, 9, 6}, 15), 4U);
}

TEST(VertexFaults, AreThereExactlyWhenNoOrderOfTheLayersIs) {
  std::mt19937 random(20261122);
  for (const std::size_t degree : {4U, 6U, 8U}) {
    const int trials = degree == 8 ? 12 : 60;
    for (int trial = 0; trial < trials; ++trial) {
      const std::vector<int> sectors = randomSectors(random, degree);
      const std::set<Mask> foldable = Zigzag(sectors).foldable();
      EXPECT_FALSE(foldable.empty());
      AssignedPattern creases = vertexOf(sectors);
      for (Mask valleys = 0; valleys < Mask{1} << degree; ++valleys) {
        choose(creases, degree, valleys);
        EXPECT_EQ(vertexFaults(creases).empty(), foldable.contains(valleys))
            << "degree " << degree << " trial " << trial << " valleys " << valleys;
      }
    }
  }
}

TEST(VertexFaults, AreThereOnlyWhenNoChoiceOfTheOpenCreasesFolds) {
  std::mt19937 random(20261123);
  std::size_t refused = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const std::size_t degree = trial % 2 == 0 ? 4 : 6;
    const std::vector<int> sectors = randomSectors(random, degree);
    const std::set<Mask> foldable = Zigzag(sectors).foldable();
    AssignedPattern creases = vertexOf(sectors);
    for (Mask open = 0; open < Mask{1} << degree; ++open) {
      for (Mask valleys = 0; valleys < Mask{1} << degree; ++valleys) {
        if ((open & valleys) != 0) continue;
        choose(creases, degree, valleys, open);
        const bool exists = std::any_of(foldable.begin(), foldable.end(),
                                        [&](Mask m) { return (m & ~open) == valleys; });
        EXPECT_EQ(vertexFaults(creases).empty(), exists)
            << "trial " << trial << " open " << open << " valleys " << valleys;
        if (!exists) ++refused;
      }
    }
  }
  EXPECT_GT(refused, 1000U);
}

std::vector<VertexRule> rulesOf(const std::vector<VertexFault>& faults) {
  std::vector<VertexRule> rules;
  for (const VertexFault& fault : faults) rules.push_back(fault.rule);
  return rules;
}

TEST(VertexFaults, NameTheRuleAndTheAmount) {
  AssignedPattern odd = vertexOf({4, 10, 10});
  EXPECT_EQ(rulesOf(vertexFaults(odd)), std::vector{VertexRule::EvenDegree});

  const AssignedPattern bent = vertexOf({91, 90, 92, 87}, 1);
  const std::vector<VertexFault> kawasaki = vertexFaults(bent);
  ASSERT_EQ(rulesOf(kawasaki), std::vector{VertexRule::Kawasaki});
  EXPECT_NEAR(kawasaki.front().amount, 3, 1e-9);
  EXPECT_NE(kawasaki.front().message.find("but for 3;"), std::string::npos);
  EXPECT_TRUE(vertexFaults(bent, 5).empty());

  AssignedPattern valleys = vertexOf({6, 6, 6, 6});
  choose(valleys, 4, 0b1111);
  const std::vector<VertexFault> maekawa = vertexFaults(valleys);
  ASSERT_EQ(rulesOf(maekawa), std::vector{VertexRule::Maekawa});
  EXPECT_EQ(maekawa.front().amount, 2);

  AssignedPattern little = vertexOf({3, 6, 9, 6});
  choose(little, 4, 0b0011);
  EXPECT_EQ(rulesOf(vertexFaults(little)),
            (std::vector{VertexRule::Maekawa, VertexRule::BigLittleBig}));
  choose(little, 4, 0b0111);
  EXPECT_EQ(rulesOf(vertexFaults(little)), std::vector{VertexRule::BigLittleBig});
}

/// Every rule on sight holds, but folding the smallest angle away leaves one that does not.
TEST(VertexFaults, FindCrossingsThatNoOtherRuleShows) {
  std::mt19937 random(7);
  std::size_t found = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<int> sectors = randomSectors(random, 8);
    AssignedPattern creases = vertexOf(sectors);
    choose(creases, 8, random() % 256);
    for (const VertexFault& fault : vertexFaults(creases))
      found += fault.rule == VertexRule::SelfCrossing ? 1 : 0;
  }
  EXPECT_GT(found, 0U);
}

TEST(VertexFaults, WantOneCreaseGoingOnWhereOnlyTwoMeet) {
  const std::vector<test::DrawnEdge> edges{{0, 4},
                                           {4, 1},
                                           {1, 2},
                                           {2, 5},
                                           {5, 3},
                                           {3, 0},
                                           {4, 6, EdgeKind::Hinge, 180},
                                           {6, 5, EdgeKind::Hinge, 180}};
  AssignedPattern creases =
      test::unassignedPattern({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {1, 2}, {1, 1}}, edges);
  EXPECT_TRUE(vertexFaults(creases).empty());
  test::assign(creases, EdgeId(6), Assignment::Mountain);
  EXPECT_TRUE(vertexFaults(creases).empty());
  test::assign(creases, EdgeId(7), Assignment::Valley);
  EXPECT_EQ(rulesOf(vertexFaults(creases)), std::vector{VertexRule::Maekawa});
  creases.pattern.vertices[6].x += 0.1;
  test::assign(creases, EdgeId(7), Assignment::Mountain);
  EXPECT_EQ(rulesOf(vertexFaults(creases)), std::vector{VertexRule::Kawasaki});
}

TEST(VertexFaults, AreNoneOnBordersCutsAndFlatCreases) {
  // Three creases at a slit's end; creases that lie flat.
  AssignedPattern slit = vertexOf({4, 4, 8, 8});
  slit.pattern.edges[0].kind = EdgeKind::Cut;
  slit.assignments[0] = Assignment::Cut;
  EXPECT_TRUE(vertexFaults(slit).empty());
  AssignedPattern flat = vertexOf({6, 3, 3, 6, 6});
  test::assign(flat, EdgeId(2), Assignment::Flat);
  EXPECT_TRUE(vertexFaults(flat).empty());
  test::assign(flat, EdgeId(2), Assignment::Unassigned);
  EXPECT_FALSE(vertexFaults(flat).empty());
}

TEST(VertexFaults, ForgiveWhatTheDrawingCannotSay) {
  AssignedPattern creases = vertexOf({6, 6, 6, 6});
  const double size = creases.pattern.tolerance.sheetSize();
  creases.pattern.vertices[1].y += 2e-6 * size;
  EXPECT_TRUE(vertexFaults(creases).empty());
  EXPECT_FALSE(vertexFaults(creases, 1e-5).empty());
  creases.pattern.vertices[1].y += 1e-3 * size;
  EXPECT_FALSE(vertexFaults(creases).empty());
}

}  // namespace
}  // namespace kiri
