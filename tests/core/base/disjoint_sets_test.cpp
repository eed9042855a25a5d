// Disjoint sets against colours that are painted over whenever two sets are joined.
// SPDX-License-Identifier: MIT
#include "core/base/disjoint_sets.h"

#include <gtest/gtest.h>

#include <random>

namespace kiri {
namespace {

TEST(DisjointSets, AreTheSameAsPaintingOver) {
  constexpr std::uint32_t kCount = 60;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_int_distribution<std::uint32_t> some(0, kCount - 1);
    DisjointSets sets(kCount);
    std::vector<std::uint32_t> colours(kCount);
    std::iota(colours.begin(), colours.end(), 0U);
    for (int i = 0; i < 50; ++i) {
      const std::uint32_t a = some(random);
      const std::uint32_t b = some(random);
      const std::uint32_t low = std::min(colours[a], colours[b]);
      const std::uint32_t high = std::max(colours[a], colours[b]);
      EXPECT_EQ(sets.join(a, b), low != high) << "seed " << seed;
      std::replace(colours.begin(), colours.end(), high, low);
    }
    // Painted with the lower colour, each set has that of its least member.
    for (std::uint32_t k = 0; k < kCount; ++k) EXPECT_EQ(sets.find(k), colours[k]) << seed;
  }
}

TEST(DisjointSets, AreEachItsOwnAtTheStart) {
  DisjointSets sets(3);
  EXPECT_EQ(sets.count(), 3U);
  for (std::uint32_t k = 0; k < 3; ++k) EXPECT_EQ(sets.find(k), k);
  EXPECT_FALSE(sets.join(1, 1));
}

}  // namespace
}  // namespace kiri
