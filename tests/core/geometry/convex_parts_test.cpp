// Convex parts cover their region once: areas, samples, tags; slits, touching corners and holes
// included. SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/geometry/convex.h"
#include "core/geometry/flattened_parts.h"
#include "core/geometry/orientation.h"
#include "core/geometry/region.h"
#include "tests/core/geometry/shapes.h"

namespace kiri {
namespace {

using test::comb;
using test::loopThrough;
using test::Random;
using test::star;
using test::turned;

const Tolerance kTolerance(141.4);

/// Area of the region with its curves replaced by the polylines that convexParts uses.
double flattenedArea(const Region& region) {
  Region flat;
  for (const Loop& loop : region.loops) {
    Loop chords;
    for (const Arc& arc : loop) {
      const std::vector<double> t = flatteningParameters(arc, kTolerance.flattening());
      for (std::size_t i = 0; i + 1 < t.size(); ++i) {
        chords.push_back(Arc::line(pointAt(arc, t[i]), pointAt(arc, t[i + 1])));
      }
    }
    flat.loops.push_back(chords);
  }
  return areaOf(flat);
}

double areaOfParts(const std::vector<ConvexPart>& parts) {
  double sum = 0;
  for (const ConvexPart& part : parts) sum += signedArea(part.points);
  return sum;
}

bool isConvex(const std::vector<Vec2>& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (orientation(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]) < 0) return false;
  }
  return true;
}

/// Length of the sides with each tag.
std::vector<double> lengthsByTag(const std::vector<ConvexPart>& parts, std::size_t arcs) {
  std::vector<double> result(arcs);
  for (const ConvexPart& part : parts) {
    for (std::size_t i = 0; i < part.points.size(); ++i) {
      if (part.tags[i] == ConvexPart::kInner) continue;
      result[static_cast<std::size_t>(part.tags[i])] +=
          distance(part.points[i], part.points[(i + 1) % part.points.size()]);
    }
  }
  return result;
}

/// Each arc's length must stand in the tags; slits may leave none.
void expectTagsCoverBorder(const Region& region, const std::vector<ConvexPart>& parts,
                           const std::string& what) {
  std::vector<const Arc*> arcs;
  for (const Loop& loop : region.loops) {
    for (const Arc& arc : loop) arcs.push_back(&arc);
  }
  const std::vector<double> lengths = lengthsByTag(parts, arcs.size());
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    EXPECT_NEAR(lengths[i], lengthOf(*arcs[i], 1e-6), 2e-3) << what << " arc " << i;
  }
}

void expectPartsOf(const Region& region, const std::string& what, bool hasSlits = false) {
  const std::vector<ConvexPart> parts = convexParts(region, kTolerance);
  const double area = flattenedArea(region);
  EXPECT_NEAR(areaOfParts(parts), area, 1e-9 * std::max(1.0, area)) << what;
  for (const ConvexPart& part : parts) {
    ASSERT_GE(part.points.size(), 3U) << what;
    ASSERT_EQ(part.points.size(), part.tags.size()) << what;
    EXPECT_TRUE(isConvex(part.points)) << what;
    EXPECT_GT(signedArea(part.points), 0) << what;
  }
  // Convex, inside and of the right total area: so they cover, and do not overlap.
  const auto dense = test::polygons(region, 50);
  Random random(99);
  for (const ConvexPart& part : parts) {
    for (int k = 0; k < 3; ++k) {
      Vec2 p;
      double sum = 0;
      for (const Vec2 q : part.points) {
        const double w = random.in(0.01, 1);
        p = p + q * w;
        sum += w;
      }
      p = p / sum;
      if (hasSlits || test::distanceTo(dense, p) < 0.05) continue;
      EXPECT_TRUE(test::isInside(dense, p)) << what;
    }
  }
  if (!hasSlits) expectTagsCoverBorder(region, parts, what);
}

TEST(ConvexParts, OfStars) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    expectPartsOf({{star(random, {50, 50}, 5, 50, random.count(4, 60))}},
                  "star " + std::to_string(i));
  }
}

TEST(ConvexParts, OfCombs) {
  Random random(2);
  for (int i = 0; i < 100; ++i)
    expectPartsOf({{comb(random, random.count(1, 30))}}, "comb " + std::to_string(i));
}

TEST(ConvexParts, OfCurvedRegions) {
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    expectPartsOf({{star(random, {50, 50}, 25, 45, random.count(5, 20), 0.15)}},
                  "curved " + std::to_string(i));
  }
}

TEST(ConvexParts, OfRegionsWithHoles) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    Region region{{star(random, {50, 50}, 42, 50, random.count(12, 30))}};
    const int holes = random.count(1, 6);
    for (int k = 0; k < holes; ++k) {
      const Vec2 centre = Vec2{50, 50} + test::polar(22, k / 6.0);
      region.loops.push_back(
          turned(star(random, centre, 2, 9, random.count(4, 12), i % 2 == 0 ? 0 : 0.1)));
    }
    expectPartsOf(region, "holed " + std::to_string(i));
  }
}

TEST(ConvexParts, OfGridsOfHoles) {
  Region region{{loopThrough({{0, 0}, {100, 0}, {100, 100}, {0, 100}})}};
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j) {
      const Vec2 c{6 + 12.0 * i, 6 + 12.0 * j};
      region.loops.push_back(
          turned(loopThrough({c, c + Vec2{4, 0}, c + Vec2{4, 4}, c + Vec2{0, 4}})));
    }
  }
  expectPartsOf(region, "grid");
}

TEST(ConvexParts, OfAConvexPolygonIsThePolygon) {
  const std::vector<Vec2> p{{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}};
  const std::vector<ConvexPart> parts = convexParts({{loopThrough(p)}}, kTolerance);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].points, p);
  EXPECT_EQ(parts[0].tags, (std::vector<std::int32_t>{0, 1, 2, 3, 4}));
}

TEST(ConvexParts, OfConvexCurvesAreOnePart) {
  const Arc arch = Arc::cubic({100, 0}, {90, 50}, {10, 50}, {0, 0});
  const std::vector<ConvexPart> parts =
      convexParts({{{Arc::line({0, 0}, {100, 0}), arch}}}, kTolerance);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].tags.front(), 0);
  EXPECT_EQ(parts[0].tags.back(), 1);
}

TEST(ConvexParts, MissCurvesByNoMoreThanTheyMay) {
  const Arc arch = Arc::cubic({100, 0}, {90, 50}, {10, 50}, {0, 0});
  const Region region{{{Arc::line({0, 0}, {100, 0}), arch}}};
  const double area = areaOf(region);
  std::size_t before = 0;
  for (const double error : {1.0, 0.1, 0.01}) {
    const std::vector<ConvexPart> parts = convexPartsWithin(region, kTolerance, error);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_GT(parts[0].points.size(), before) << error;
    before = parts[0].points.size();
    // Chords lie inside the arch, nowhere farther from it than the error.
    EXPECT_LT(areaOfParts(parts), area) << error;
    EXPECT_GT(areaOfParts(parts), area - error * lengthOf(arch, 1e-6)) << error;
  }
  EXPECT_EQ(convexPartsWithin(region, kTolerance, kTolerance.flattening())[0].points,
            convexParts(region, kTolerance)[0].points);
}

TEST(ConvexParts, OfCollinearCornersAllHoldTheirTags) {
  // An L with corners along all sides.
  std::vector<Vec2> p;
  for (int i = 0; i < 10; ++i) p.push_back({static_cast<double>(i), 0});
  for (int i = 0; i < 5; ++i) p.push_back({10, static_cast<double>(i)});
  for (int i = 10; i > 5; --i) p.push_back({static_cast<double>(i), 5});
  for (int i = 5; i < 10; ++i) p.push_back({5, static_cast<double>(i)});
  for (int i = 5; i > 0; --i) p.push_back({static_cast<double>(i), 10});
  for (int i = 10; i > 0; --i) p.push_back({0, static_cast<double>(i)});
  expectPartsOf({{loopThrough(p)}}, "L");
  EXPECT_LE(convexParts({{loopThrough(p)}}, kTolerance).size(), 2U);
}

TEST(ConvexParts, LeaveSlitsFromTheBorderOut) {
  Loop loop = loopThrough({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  loop.insert(loop.begin() + 1, {Arc::line({100, 0}, {60, 40}), Arc::line({60, 40}, {50, 40}),
                                 Arc::line({50, 40}, {60, 40}), Arc::line({60, 40}, {100, 0})});
  expectPartsOf({{loop}}, "slit", true);
  EXPECT_EQ(convexParts({{loop}}, kTolerance).size(), 1U);
}

TEST(ConvexParts, LeaveCurvedSlitsOut) {
  Loop loop = loopThrough({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  const Arc cut = Arc::cubic({100, 0}, {80, 60}, {30, 10}, {50, 50});
  loop.insert(loop.begin() + 1, {cut, reversed(cut)});
  expectPartsOf({{loop}}, "curved slit", true);
  EXPECT_EQ(convexParts({{loop}}, kTolerance).size(), 1U);
}

TEST(ConvexParts, LeaveSlitsInTheMiddleOut) {
  const Loop square = loopThrough({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  const Loop slit{Arc::line({40, 40}, {60, 50}), Arc::line({60, 50}, {40, 40})};
  const Loop tree{Arc::line({20, 20}, {30, 20}), Arc::line({30, 20}, {30, 30}),
                  Arc::line({30, 30}, {30, 20}), Arc::line({30, 20}, {20, 20})};
  expectPartsOf({{square, slit, tree}}, "inner slits", true);
}

TEST(ConvexParts, OfARingCutThroughAreTheRing) {
  // A square with a square hole, joined by a slit that both belong to: one loop.
  Loop loop = loopThrough({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  const Loop hole = loopThrough({{40, 40}, {40, 60}, {60, 60}, {60, 40}});
  Loop all{Arc::line({0, 0}, {40, 40})};
  all.insert(all.end(), hole.begin(), hole.end());
  all.push_back(Arc::line({40, 40}, {0, 0}));
  all.insert(all.end(), loop.begin(), loop.end());
  expectPartsOf({{all}}, "ring");
}

TEST(ConvexParts, OfHolesThatTouch) {
  const Loop square = loopThrough({{0, 0}, {100, 0}, {100, 100}, {50, 100}, {0, 100}});
  // Touching the border in a corner, the side of the border, and each other.
  const Loop atCorner = turned(loopThrough({{0, 0}, {30, 10}, {10, 30}}));
  const Loop atSide = turned(loopThrough({{50, 100}, {40, 70}, {60, 70}}));
  const Loop below = turned(loopThrough({{40, 70}, {30, 50}, {45, 50}}));
  expectPartsOf({{square, atCorner}}, "corner");
  expectPartsOf({{square, atSide}}, "side");
  expectPartsOf({{square, below, atSide}}, "two");
  expectPartsOf({{square, atCorner, atSide, below}}, "three");
}

TEST(ConvexParts, OfABorderThatTouchesItself) {
  // Two squares hang together at (50, 50); a hole's tip touches from inside.
  expectPartsOf(
      {{loopThrough(
          {{0, 0}, {50, 0}, {50, 50}, {100, 50}, {100, 100}, {50, 100}, {50, 50}, {0, 50}})}},
      "pinched");
  expectPartsOf(
      {{loopThrough(
          {{0, 0}, {100, 0}, {100, 100}, {50, 100}, {70, 50}, {30, 50}, {50, 100}, {0, 100}})}},
      "inner pinch");
}

TEST(ConvexParts, OfTinyAndHugeFeatures) {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    Loop loop = star(random, {50, 50}, 20, 50, 20);
    // Replace a corner by very small steps.
    const double tiny = std::pow(10.0, random.in(-7, -2));
    const Vec2 p = loop[5].start;
    const Vec2 d = normalized(loop[5].end - p);
    std::vector<Vec2> corners;
    for (const Arc& arc : loop) corners.push_back(arc.start);
    corners.insert(corners.begin() + 6, {p + d * tiny, p + d * (2 * tiny) + perpendicular(d) * tiny,
                                         p + d * (3 * tiny)});
    expectPartsOf({{loopThrough(corners)}}, "tiny " + std::to_string(i));
  }
}

TEST(ConvexParts, OfSliversThinnerThanTheFlatteningKeepTheArea) {
  for (const double width : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const Arc there = Arc::cubic({0, 0}, {30, 60}, {70, -60}, {100, 0});
    const Arc back = Arc::cubic({100, 0}, {70, -60 + width}, {30, 60 + width}, {0, 0});
    // Differently divided sides have different samples: their polylines cross.
    const Region region{{{there, part(back, 0, 0.3), part(back, 0.3, 1)}}};
    EXPECT_NEAR(areaOfParts(convexParts(region, kTolerance)), areaOf(region), 0.1) << width;
    // The same with sides that truly cross, as rounding may make them.
    const Arc across = Arc::cubic({100, 0}, {70, -60 + width}, {30, 60 - 0.9 * width}, {0, 0});
    EXPECT_NEAR(areaOfParts(convexParts({{{there, across}}}, kTolerance)), 0, 0.2) << width;
  }
}

TEST(ConvexParts, OfRegionsInsideOutEnd) {
  Random random(8);
  for (int i = 0; i < 20; ++i) {
    Loop loop;
    Vec2 p = random.point();
    const Vec2 first = p;
    for (int k = 0; k < 6; ++k) {
      const Vec2 q = k < 5 ? random.point() : first;
      loop.push_back(Arc::cubic(p, random.point(), random.point(), q));
      p = q;
    }
    for (const ConvexPart& piece : convexParts({{loop}}, kTolerance))
      EXPECT_GE(piece.points.size(), 3U);
  }
}

// The time limit of the test program would show if this took long.
TEST(ConvexParts, OfAThousandCornersComeSoon) {
  Random random(6);
  expectPartsOf({{star(random, {50, 50}, 10, 50, 1000)}}, "large star");
  expectPartsOf({{comb(random, 500)}}, "large comb");
}

TEST(ConvexParts, AreFew) {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const Loop loop = star(random, {50, 50}, 5, 50, 40);
    int dents = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      if (orientation(loop[k].start, loop[k].end, loop[(k + 1) % loop.size()].end) < 0) ++dents;
    }
    // Hertel and Mehlhorn promise 2 dents + 1.
    EXPECT_LE(static_cast<int>(convexParts({{loop}}, kTolerance).size()), 2 * dents + 1);
  }
}

TEST(Orientation, IsExactWhereRoundingDecides) {
  const Vec2 a{0.5, 0.5};
  const Vec2 b{12, 12};
  const double ulp = 0x1p-53;
  for (int i = 0; i < 32; ++i) {
    for (int j = 0; j < 32; ++j) {
      const Vec2 c{0.5 + i * ulp * 2, 0.5 + j * ulp * 2};
      EXPECT_EQ(orientation(a, b, c), (j > i) - (j < i)) << i << " " << j;
      EXPECT_EQ(orientation(b, c, a), orientation(a, b, c));
      EXPECT_EQ(orientation(b, a, c), -orientation(a, b, c));
      EXPECT_EQ(orientation({24, 24}, b, c), (i > j) - (i < j));
    }
  }
}

}  // namespace
}  // namespace kiri
