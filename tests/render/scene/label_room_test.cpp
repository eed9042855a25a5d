// Labels keep off the shape, off each other, and on the page.
// SPDX-License-Identifier: MIT
#include "render/scene/label_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/random_steps.h"

namespace kiri {
namespace {

constexpr Vec2 kLabelSize{12, 3};
const Box kLabelPage{{0, 0}, {100, 80}};

Box labelBox(Vec2 middle) { return {middle - kLabelSize / 2, middle + kLabelSize / 2}; }

bool overlap(const Box& a, const Box& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

bool isOnPage(const Box& box) {
  return box.low.x >= 0 && box.low.y >= 0 && box.high.x <= 100 && box.high.y <= 80;
}

/// A disc in short sides.
std::vector<Vec2> disc(Vec2 middle, double radius) {
  std::vector<Vec2> loop;
  constexpr int kSides = 90;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    loop.push_back(middle + Vec2{std::cos(angle), std::sin(angle)} * radius);
  }
  return loop;
}

TEST(LabelRoom, BeyondAShapeLabelsStandOffItOffEachOtherAndOnThePage) {
  const Vec2 middle{50, 40};
  constexpr double kRadius = 15;
  LabelRoom room(kLabelPage, {disc(middle, kRadius)});
  std::vector<Box> found;
  constexpr int kRays = 40;
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRays;
    const Vec2 way{std::cos(angle), std::sin(angle)};
    const auto place = room.takeBeyond(middle + way * kRadius, way, kLabelSize, 100);
    if (!place) continue;
    const Box box = labelBox(place->middle);
    EXPECT_TRUE(isOnPage(box)) << i;
    const Vec2 nearest{std::clamp(middle.x, box.low.x, box.high.x),
                       std::clamp(middle.y, box.low.y, box.high.y)};
    EXPECT_GT(distance(nearest, middle), 0.98 * kRadius) << i;
    for (const Box& other : found) EXPECT_FALSE(overlap(box, other)) << i;
    found.push_back(box);
  }
  EXPECT_GT(found.size(), 15U);
}

TEST(LabelRoom, BeyondTheReachAndTheEdgeOfThePageThereIsNoPlace) {
  LabelRoom room(kLabelPage);
  EXPECT_FALSE(room.takeBeyond({95, 40}, {1, 0}, kLabelSize, 100));
  room.keepFree({{0, 0}, {60, 80}});
  EXPECT_FALSE(room.takeBeyond({40, 40}, {1, 0}, kLabelSize, 10)) << "what is taken bars the way";
  EXPECT_FALSE(room.takeBeyond({61, 70}, {0, 1}, kLabelSize, 2));
  const auto place = room.takeBeyond({61, 40}, {1, 0}, kLabelSize, 10);
  ASSERT_TRUE(place);
  EXPECT_FALSE(place->isAway);
  EXPECT_GT(place->near.x, 61);
}

TEST(LabelRoom, AroundAPointLabelsStandApartWhileThereIsRoom) {
  LabelRoom room(kLabelPage);
  std::vector<Box> found;
  for (int i = 0; i < 6; ++i) {
    const Box box = labelBox(room.takeAround({50, 40}, kLabelSize, 1));
    for (const Box& other : found) EXPECT_FALSE(overlap(box, other)) << i;
    EXPECT_FALSE(overlap(box, {{49.5, 39.5}, {50.5, 40.5}})) << i;
    found.push_back(box);
  }
}

TEST(LabelRoom, AroundAPointThereIsAlwaysAPlaceOnThePage) {
  test::Random random(7);
  LabelRoom room(kLabelPage);
  room.keepFree({{0, 0}, {100, 20}});
  for (int i = 0; i < 200; ++i) {
    const Vec2 point{random.between(-5, 105), random.between(-5, 85)};
    EXPECT_TRUE(isOnPage(labelBox(room.takeAround(point, kLabelSize, 2)))) << i;
  }
}

TEST(LabelRoom, WhatShallStayFreeIsAvoided) {
  LabelRoom room(kLabelPage);
  const Box kept{{0, 0}, {100, 39}};
  room.keepFree(kept);
  EXPECT_FALSE(overlap(labelBox(room.takeAround({50, 40}, kLabelSize, 1)), kept));
}

}  // namespace
}  // namespace kiri
