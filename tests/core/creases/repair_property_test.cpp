// Patterns that are shaken, split, doubled, turned and shuffled come back; random lines make maps.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/creases/repair.h"
#include "core/geometry/orientation.h"
#include "tests/core/creases/drawings.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

/// Random straight cuts of a square from side to side, as the lines of a clean planar map.
CreaseDrawing randomMap(Random& random, int cuts) {
  CreaseDrawing loose = drawn("B 0,0 100,0 100,100 0,100 0,0");
  for (int i = 0; i < cuts; ++i) {
    const auto rim = [&](std::size_t side) {
      const double t = random.between(3, 97);
      return side == 0   ? Vec2{t, 0}
             : side == 1 ? Vec2{100, t}
             : side == 2 ? Vec2{t, 100}
                         : Vec2{0, t};
    };
    const std::size_t side = random.below(4);
    const std::size_t other = (side + 1 + random.below(3)) % 4;
    const Assignment kinds[] = {Assignment::Mountain, Assignment::Valley, Assignment::Unassigned,
                                Assignment::Flat};
    loose.lines.push_back({rim(side), rim(other), kinds[random.below(4)], {}});
  }
  const Result<RepairedPattern> pattern = patternOf(loose);
  EXPECT_TRUE(pattern.isOk());
  CreaseDrawing clean = drawingOf(pattern->creases);
  clean.faces.clear();
  return clean;
}

double smallestFeature(const CreasePattern& pattern) {
  double least = 1e9;
  for (const Edge& edge : pattern.edges) {
    for (const Vec2 p : pattern.vertices) {
      if (p == pattern[edge.from] || p == pattern[edge.to]) continue;
      const Vec2 way = pattern[edge.to] - pattern[edge.from];
      const double t = std::clamp(dot(p - pattern[edge.from], way) / dot(way, way), 0.0, 1.0);
      least = std::min(least, distance(p, pattern[edge.from] + way * t));
    }
  }
  return least;
}

void turnSome(CreaseDrawing& drawing, Random& random) {
  for (DrawnCrease& line : drawing.lines) {
    if (random.chance(0.5)) std::swap(line.from, line.to);
  }
}

void splitSome(CreaseDrawing& drawing, Random& random) {
  const std::size_t n = drawing.lines.size();
  for (std::size_t i = 0; i < n; ++i) {
    // Halved and doubled: both halves lie on the whole.
    if (!random.chance(0.3)) continue;
    DrawnCrease copy = drawing.lines[i];
    if (random.chance(0.5)) std::swap(copy.from, copy.to);
    drawing.lines.push_back(copy);
  }
}

void shuffle(CreaseDrawing& drawing, Random& random) {
  for (std::size_t i = drawing.lines.size(); i > 1; --i)
    std::swap(drawing.lines[i - 1], drawing.lines[random.below(i)]);
}

void shakeEnds(CreaseDrawing& drawing, double noise, Random& random) {
  for (DrawnCrease& line : drawing.lines) {
    for (Vec2* end : {&line.from, &line.to})
      *end = *end + Vec2{random.between(-noise, noise), random.between(-noise, noise)};
  }
}

/// The lines of a pattern with each end named by the nearest vertex of another one.
std::vector<std::string> named(const AssignedPattern& creases, const CreasePattern& names,
                               double within) {
  const auto name = [&](Vec2 p) {
    std::size_t best = 0;
    for (std::size_t v = 0; v < names.vertices.size(); ++v) {
      if (distance(names.vertices[v], p) < distance(names.vertices[best], p)) best = v;
    }
    return distance(names.vertices[best], p) <= within ? std::to_string(best) : "?";
  };
  std::vector<std::string> lines;
  for (std::size_t e = 0; e < creases.assignments.size(); ++e) {
    std::string from = name(creases.pattern[creases.pattern.edges[e].from]);
    std::string to = name(creases.pattern[creases.pattern.edges[e].to]);
    if (to < from) std::swap(from, to);
    lines.push_back(from + " " + to + " " +
                    std::to_string(static_cast<int>(creases.assignments[e])));
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

TEST(PatternOfProperties, ACleanMapComesOutBitByBitInItsOrder) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const CreaseDrawing clean = randomMap(random, 2 + static_cast<int>(seed % 9));
    const Result<RepairedPattern> again = patternOf(clean);
    ASSERT_TRUE(again.isOk());
    EXPECT_TRUE(again->repairs.empty()) << seed << ": " << again->repairs.front().message;
    ASSERT_EQ(again->creases.pattern.edges.size(), clean.lines.size()) << seed;
    std::vector<Vec2> appearing;
    for (std::size_t e = 0; e < clean.lines.size(); ++e) {
      const Edge& edge = again->creases.pattern.edges[e];
      EXPECT_EQ(again->creases.pattern[edge.from], clean.lines[e].from);
      EXPECT_EQ(again->creases.pattern[edge.to], clean.lines[e].to);
      EXPECT_EQ(again->creases.assignments[e], clean.lines[e].assignment);
      for (const Vec2 p : {clean.lines[e].from, clean.lines[e].to}) {
        if (std::find(appearing.begin(), appearing.end(), p) == appearing.end())
          appearing.push_back(p);
      }
    }
    EXPECT_EQ(again->creases.pattern.vertices, appearing);
  }
}

TEST(PatternOfProperties, DoubledTurnedShuffledLinesGiveTheSameMap) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const CreaseDrawing clean = randomMap(random, 2 + static_cast<int>(seed % 12));
    CreaseDrawing dirty = clean;
    turnSome(dirty, random);
    splitSome(dirty, random);
    shuffle(dirty, random);
    const Result<RepairedPattern> a = patternOf(clean);
    const Result<RepairedPattern> b = patternOf(dirty);
    ASSERT_TRUE(a.isOk() && b.isOk());
    EXPECT_EQ(named(a->creases, a->creases.pattern, 0), named(b->creases, a->creases.pattern, 0));
    EXPECT_EQ(b->creases.pattern.facets.size(), a->creases.pattern.facets.size()) << seed;
  }
}

TEST(PatternOfProperties, ShakenLinesGiveTheSameMapUpToTheNoise) {
  int tried = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const CreaseDrawing clean = randomMap(random, 2 + static_cast<int>(seed % 9));
    const Result<RepairedPattern> a = patternOf(clean);
    ASSERT_TRUE(a.isOk());
    const double noise = std::pow(10, random.between(-7, -2));
    if (smallestFeature(a->creases.pattern) < 30 * noise) continue;
    CreaseDrawing dirty = clean;
    turnSome(dirty, random);
    splitSome(dirty, random);
    shuffle(dirty, random);
    shakeEnds(dirty, noise, random);
    const Result<RepairedPattern> b = patternOf(dirty);
    ASSERT_TRUE(b.isOk()) << seed << ": " << b.error().message;
    EXPECT_EQ(named(a->creases, a->creases.pattern, 1e-9),
              named(b->creases, a->creases.pattern, 3 * noise))
        << "seed " << seed << " noise " << noise << " merged within " << b->mergedWithin;
    ++tried;
  }
  EXPECT_GT(tried, 150);
}

/// Vertices, crossings and ends of lines counted the slow way.
struct BruteForce {
  std::size_t vertices = 0;
  std::size_t edges = 0;
};

BruteForce bruteForce(const std::vector<DrawnCrease>& lines) {
  BruteForce count;
  count.vertices = 2 * lines.size();
  count.edges = lines.size();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      const DrawnCrease& a = lines[i];
      const DrawnCrease& b = lines[j];
      if (orientation(a.from, a.to, b.from) * orientation(a.from, a.to, b.to) < 0 &&
          orientation(b.from, b.to, a.from) * orientation(b.from, b.to, a.to) < 0) {
        ++count.vertices;
        count.edges += 2;
      }
    }
  }
  return count;
}

TEST(PatternOfProperties, RandomLinesCrossAsOftenAsBruteForceSays) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    CreaseDrawing drawing;
    const std::size_t n = 5 + random.below(60);
    const double reach = random.chance(0.5) ? 100 : 15;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 p{random.between(1, 99), random.between(1, 99)};
      const Vec2 q{random.between(std::max(1.0, p.x - reach), std::min(99.0, p.x + reach)),
                   random.between(std::max(1.0, p.y - reach), std::min(99.0, p.y + reach))};
      // Cuts, so that nothing is left out for ending inside a facet.
      drawing.lines.push_back({p, q, Assignment::Cut, {}});
    }
    const BruteForce expected = bruteForce(drawing.lines);
    const CreaseDrawing rim = drawn("B 0,0 100,0 100,100 0,100 0,0");
    drawing.lines.insert(drawing.lines.end(), rim.lines.begin(), rim.lines.end());
    RepairOptions options;
    options.merge = 1e-9;
    const Result<RepairedPattern> result = patternOf(drawing, options);
    ASSERT_TRUE(result.isOk()) << result.error().message;
    const CreasePattern& pattern = result->creases.pattern;
    EXPECT_EQ(pattern.vertices.size(), expected.vertices + 4) << seed;
    EXPECT_EQ(pattern.edges.size(), expected.edges + 4) << seed;
    EXPECT_NEAR(areaOf(pattern), 1e4, 1e-6);
    EXPECT_EQ(joined(mapViolations(result->creases)), "");
    // Euler: V - E + F = 1 + groups, the outside counted as a face.
    std::vector<std::size_t> group(pattern.vertices.size());
    for (std::size_t v = 0; v < group.size(); ++v) group[v] = v;
    const auto root = [&](std::size_t v) {
      while (group[v] != v) v = group[v];
      return v;
    };
    std::size_t groups = group.size();
    for (const Edge& edge : pattern.edges) {
      const std::size_t a = root(edge.from.index);
      const std::size_t b = root(edge.to.index);
      groups -= a == b ? 0 : 1;
      group[a] = b;
    }
    EXPECT_EQ(pattern.vertices.size() + pattern.facets.size() + 1,
              1 + groups + pattern.edges.size());
  }
}

TEST(PatternOfProperties, ManyLinesThatCrossAtAllAnglesMakeSoundPatterns) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    CreaseDrawing drawing = drawn("B 0,0 100,0 100,100 0,100 0,0");
    const std::size_t n = 20 + random.below(150);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 p{random.between(0, 100), random.between(0, 100)};
      // Bundles of nearly parallel lines, too, and many ends on few places.
      const double turn =
          random.chance(0.3) ? random.between(-1e-5, 1e-5) : random.between(-3.2, 3.2);
      const Vec2 q = p + Vec2{std::cos(turn), std::sin(turn)} * random.between(0, 60);
      drawing.lines.push_back({p, q, static_cast<Assignment>(random.below(7)), {}});
    }
    const Result<RepairedPattern> result = patternOf(drawing);
    ASSERT_TRUE(result.isOk()) << seed << ": " << result.error().message;
    EXPECT_EQ(joined(mapViolations(result->creases)), "") << seed;
  }
}

TEST(PatternOfProperties, HundredsOfLinesAcrossEachOtherAreNoHatching) {
  // Far more crossings than ends: what the ends suggest would merge crossings by the thousand.
  Random random(5);
  CreaseDrawing drawing;
  for (int i = 0; i < 500; ++i) {
    drawing.lines.push_back({{random.between(0, 1), random.between(0, 1)},
                             {random.between(0, 1), random.between(0, 1)},
                             Assignment::Cut,
                             {}});
  }
  const CreaseDrawing rim = drawn("B -1,-1 2,-1 2,2 -1,2 -1,-1");
  drawing.lines.insert(drawing.lines.end(), rim.lines.begin(), rim.lines.end());
  const Result<RepairedPattern> result = patternOf(drawing);
  ASSERT_TRUE(result.isOk()) << result.error().message;
  EXPECT_EQ(joined(mapViolations(result->creases)), "");
  EXPECT_GT(result->creases.pattern.facets.size(), 10000U);
}

TEST(PatternOfProperties, LinesOnACoarseGridMakeSoundPatterns) {
  // Ends on few places: crossings at vertices, overlaps, lines through ends, all the time.
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    Random random(seed);
    CreaseDrawing drawing;
    const std::size_t n = 3 + random.below(25);
    const double wobbles[] = {0, 1e-9, 1e-7, 1e-5, 1e-3};
    const double wobble = wobbles[random.below(5)];
    for (std::size_t i = 0; i < n; ++i) {
      const auto place = [&] {
        return Vec2{static_cast<double>(random.below(5)) * 10 + random.between(0, wobble),
                    static_cast<double>(random.below(5)) * 10 + random.between(0, wobble)};
      };
      const Assignment kind = static_cast<Assignment>(random.below(7));
      drawing.lines.push_back({place(), place(), kind, {}});
    }
    const Result<RepairedPattern> result = patternOf(drawing);
    if (!result) {
      // All lines on one straight line: the only drawing without paper.
      EXPECT_NE(result.error().message.find("enclose no paper"), std::string::npos)
          << seed << ": " << result.error().message;
      continue;
    }
    EXPECT_EQ(joined(mapViolations(result->creases)), "") << seed;
    EXPECT_EQ(joined(patternViolations(result->creases.pattern)), "") << seed;
    for (const Repair& repair : result->repairs) {
      EXPECT_GT(repair.count, 0U);
      EXPECT_FALSE(repair.message.empty());
      EXPECT_FALSE(repair.places.empty());
    }
    if (wobble > 1e-7) continue;  // so few lines do not show their noise a second time
    const Result<RepairedPattern> again = patternOf(drawingOf(result->creases));
    ASSERT_TRUE(again.isOk()) << seed << ": " << again.error().message;
    EXPECT_TRUE(again->creases.pattern.vertices == result->creases.pattern.vertices)
        << "seed " << seed << " merged within " << result->mergedWithin << ", again "
        << again->mergedWithin << ": " << joined(linesOf(result->creases, 1e-6));
    EXPECT_TRUE(again->creases.assignments == result->creases.assignments) << seed;
  }
}

}  // namespace
}  // namespace kiri::test
