// Regions: areas, where points lie, and points inside, against dense polygons.
// SPDX-License-Identifier: MIT
#include "core/geometry/region.h"

#include <gtest/gtest.h>

#include "core/paper/sheet.h"
#include "tests/core/geometry/shapes.h"

namespace kiri {
namespace {

using test::comb;
using test::loopThrough;
using test::polygons;
using test::Random;
using test::star;
using test::turned;

const Tolerance kOfSheet(141.4);

/// A kind of region for each number: stars, combs, curved, with holes.
Region randomRegion(Random& random, int kind) {
  switch (kind % 5) {
    case 0:
      return {{star(random, {50, 50}, 10, 50, random.count(5, 40))}};
    case 1:
      return {{comb(random, random.count(2, 12))}};
    case 2:
      return {{star(random, {50, 50}, 20, 45, random.count(6, 20), 0.1)}};
    case 3: {
      Region region{{star(random, {50, 50}, 42, 50, 12)}};
      region.loops.push_back(turned(star(random, {35, 50}, 3, 10, 9)));
      region.loops.push_back(turned(star(random, {65, 50}, 3, 10, 5)));
      return region;
    }
    default: {
      Region region{{star(random, {50, 50}, 42, 47, 14, 0.05)}};
      for (int i = 0; i < 4; ++i) {
        region.loops.push_back(turned(
            star(random, Vec2{50, 50} + test::polar(20, i / 4.0), 3, 9, random.count(5, 9), 0.1)));
      }
      return region;
    }
  }
}

double areaOfPolygons(const std::vector<std::vector<Vec2>>& loops) {
  double sum = 0;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      sum += cross(loop[i], loop[(i + 1) % loop.size()]) / 2;
  }
  return sum;
}

TEST(AreaOf, IsTheLimitOfPolygons) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Region region = randomRegion(random, i);
    const double limit =
        (4 * areaOfPolygons(polygons(region, 400)) - areaOfPolygons(polygons(region, 200))) / 3;
    EXPECT_NEAR(areaOf(region), limit, 1e-7) << i;
  }
}

TEST(AreaOf, DoesNotDependOnThePlace) {
  Random random(2);
  Loop loop = star(random, {0, 0}, 0.5, 1, 9, 0.1);
  const double area = signedAreaOf(loop);
  for (Arc& arc : loop) {
    for (Vec2* p : {&arc.start, &arc.end, &arc.control1, &arc.control2}) *p = *p + Vec2{1e6, -1e6};
  }
  EXPECT_NEAR(signedAreaOf(loop), area, 1e-8);
}

TEST(PerimeterOf, AddsAllLoops) {
  const Loop square = loopThrough({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  const Loop hole = turned(loopThrough({{4, 4}, {6, 4}, {6, 6}, {4, 6}}));
  EXPECT_DOUBLE_EQ(perimeterOf(Region{{square, hole}}, 1e-6), 48);
}

TEST(Locate, AgreesWithDensePolygons) {
  Random random(3);
  int checked = 0;
  for (int i = 0; i < 100; ++i) {
    const Region region = randomRegion(random, i);
    const auto dense = polygons(region, 300);
    for (int k = 0; k < 200; ++k) {
      const Vec2 p{random.in(-5, 105), random.in(-5, 105)};
      if (test::distanceTo(dense, p) < 0.01) continue;
      EXPECT_EQ(locate(region, p, kOfSheet.length()),
                test::isInside(dense, p) ? Where::Inside : Where::Outside);
      ++checked;
    }
  }
  EXPECT_GT(checked, 15000);
}

TEST(Locate, FindsTheBorderWithinTheDistanceAndNotBeyond) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Region region = randomRegion(random, i);
    for (const Loop& loop : region.loops) {
      for (const Arc& arc : loop) {
        const double t = random.in(0, 1);
        const Vec2 p = pointAt(arc, t);
        EXPECT_EQ(locate(region, p, kOfSheet.length()), Where::OnBorder);
        const Vec2 out = perpendicular(normalized(tangentAt(arc, t)));
        const double reach = random.in(1e-7, 1e-5);
        EXPECT_EQ(locate(region, p + out * (0.98 * reach), reach), Where::OnBorder);
        EXPECT_EQ(locate(region, p + out * (1.02 * reach), reach) == Where::OnBorder, t * 1.0 > 1)
            << t;
      }
    }
  }
}

TEST(Locate, TakesRaysThroughCornersOnce) {
  const Region diamond{{loopThrough({{0, -1}, {1, 0}, {0, 1}, {-1, 0}})}};
  EXPECT_EQ(locate(diamond, {0, 0}, 1e-9), Where::Inside);
  EXPECT_EQ(locate(diamond, {-2, 0}, 1e-9), Where::Outside);
  EXPECT_EQ(locate(diamond, {-2, 1}, 1e-9), Where::Outside);
  EXPECT_EQ(locate(diamond, {-2, -1}, 1e-9), Where::Outside);
  const Region steps{{loopThrough(
      {{0, 0}, {4, 0}, {4, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})}};
  EXPECT_EQ(locate(steps, {0.5, 1}, 1e-9), Where::Inside);
  EXPECT_EQ(locate(steps, {1.5, 1.5}, 1e-9), Where::Outside);
  EXPECT_EQ(locate(steps, {-1, 1}, 1e-9), Where::Outside);
}

TEST(Locate, PutsSlitsOnTheBorder) {
  Loop slit = loopThrough({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  slit.insert(slit.begin() + 1, {Arc::line({10, 0}, {5, 5}), Arc::line({5, 5}, {10, 0})});
  const Region region{{slit}};
  EXPECT_EQ(locate(region, {7, 3}, 1e-9), Where::OnBorder);
  EXPECT_EQ(locate(region, {7, 3.1}, 1e-9), Where::Inside);
  EXPECT_EQ(locate(region, {7, 2.9}, 1e-9), Where::Inside);
  EXPECT_EQ(locate(region, {3, 7}, 1e-9), Where::Inside);
}

TEST(InteriorPoint, IsInsideAndNotNearTheBorder) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Region region = randomRegion(random, i);
    const Vec2 p = interiorPoint(region, kOfSheet);
    EXPECT_EQ(locate(region, p, 0.1), Where::Inside) << i;
    EXPECT_EQ(interiorPoint(region, kOfSheet), p);
  }
}

TEST(InteriorPoint, OfAConvexPolygonIsItsCentroid) {
  const Region triangle{{loopThrough({{0, 0}, {9, 0}, {0, 6}})}};
  EXPECT_LT(distance(interiorPoint(triangle, kOfSheet), {3, 2}), 1e-14);
}

TEST(InteriorPoint, IsInsideOfThinCrescents) {
  for (const double width : {1.0, 0.1, 0.01, 0.005}) {
    const Arc outer = Arc::cubic({0, 0}, {30, -40}, {70, -40}, {100, 0});
    const Arc inner = Arc::cubic({100, 0}, {70, -40 + width}, {30, -40 + width}, {0, 0});
    const Region region{{{outer, inner}}};
    EXPECT_EQ(locate(region, interiorPoint(region, kOfSheet), kOfSheet.length()), Where::Inside)
        << width;
  }
}

TEST(IsConvexPolygon, HoldsForConvexLoopsOfStraightSides) {
  const auto holds = [](const std::vector<Vec2>& p) {
    return isConvexPolygon({{loopThrough(p)}}, kOfSheet);
  };
  EXPECT_TRUE(holds({{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_TRUE(holds({{0, 0}, {5, 0}, {10, 0}, {10, 10}, {5, 10}, {0, 10}}));  // collinear corners
  EXPECT_TRUE(holds({{0, 0}, {5, 1e-8}, {10, 0}, {10, 10}, {0, 10}}));        // dented by rounding
  EXPECT_FALSE(holds({{0, 0}, {5, 1e-3}, {10, 0}, {10, 10}, {0, 10}}));       // dented
  EXPECT_FALSE(holds({{0, 0}, {0, 10}, {10, 10}, {10, 0}}));                  // clockwise
  EXPECT_FALSE(holds({{0, 0}, {10, 0}, {5, 0}, {10, 10}, {0, 10}}));          // a spike
  EXPECT_FALSE(holds({{0, 10}, {-6, -8}, {9.5, 3}, {-9.5, 3}, {6, -8}}));     // goes round twice
  Region curved = {{loopThrough({{0, 0}, {10, 0}, {10, 10}, {0, 10}})}};
  curved.loops[0][0] = Arc::cubic({0, 0}, {3, -3}, {7, -3}, {10, 0});
  EXPECT_FALSE(isConvexPolygon(curved, kOfSheet));
  Region holed = {{loopThrough({{0, 0}, {10, 0}, {10, 10}, {0, 10}})}};
  holed.loops.push_back(turned(loopThrough({{4, 4}, {6, 4}, {6, 6}})));
  EXPECT_FALSE(isConvexPolygon(holed, kOfSheet));
}

}  // namespace
}  // namespace kiri
