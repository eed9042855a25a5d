// SPDX-License-Identifier: MIT
#include "core/paper/contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/geometry/region.h"
#include "core/paper/folded_state.h"
#include "tests/support/model_text.h"

namespace kiri {
namespace {

/// Areas inside the contours, sorted; holes count below zero.
std::vector<double> contourAreas(const std::string& model) {
  const FoldedState state = test::run(model);
  std::vector<double> areas;
  for (const std::vector<EdgeUse>& contour : contoursOf(state.pattern)) {
    Loop loop;
    for (const EdgeUse use : contour) loop.push_back(arcOf(state.pattern, use));
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_EQ(loop[i].end, loop[(i + 1) % loop.size()].start) << model;
    }
    areas.push_back(signedAreaOf(loop));
  }
  std::sort(areas.begin(), areas.end());
  return areas;
}

void expectAreas(const std::string& model, const std::vector<double>& expected) {
  const std::vector<double> areas = contourAreas(model);
  ASSERT_EQ(areas.size(), expected.size()) << model;
  for (std::size_t i = 0; i < areas.size(); ++i) EXPECT_NEAR(areas[i], expected[i], 1e-6) << model;
}

TEST(Contours, OfASheetAreItsOutlineAndItsHoles) {
  expectAreas("square 100", {10000});
  expectAreas("polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,60 40,60", {-400, 10000});
}

TEST(Contours, CrossCreasesTearsAndSlits) {
  expectAreas("square 100\nfold a valley 50,0 50,100 left\nunfold all", {10000});
  expectAreas("square 100\nfold a valley 50,0 50,100 left\nunfold all\ntear 50,0 50,40", {10000});
  expectAreas("square 100\ncut @model m:-5,30 m:50,40", {10000});
  expectAreas("square 100\ncut @model m:20,30 m:50,40", {10000});
}

TEST(Contours, FollowTheBorderOfWhatACutLeaves) {
  expectAreas("square 100\ncut @model m:-10,50 m:110,50 keep m:50,20", {5000});
}

}  // namespace
}  // namespace kiri
