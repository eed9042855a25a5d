// Thumbnails: the paper where it lies, nothing elsewhere.
// SPDX-License-Identifier: MIT
#include "editor/document/thumbnails.h"

#include <gtest/gtest.h>

#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

struct Pixel {
  int red = 0;
  int green = 0;
  int blue = 0;
  int alpha = 0;
};

Pixel at(const Image& image, int x, int y) {
  const std::size_t i = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x)) *
                        4;
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
}

/// Part of the pixels that are covered.
double coverOf(const Image& image) {
  double cover = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) cover += image.rgba[i] / 255.0;
  return cover / (image.width * image.height);
}

Model twoColoured(const char* text) {
  Model model = modelOf(text);
  model.front.color = {200, 0, 0};
  model.back.color = {0, 0, 200};
  return model;
}

Image pictureOf(const char* text, int pixels) {
  return thumbnailOf(run(text), twoColoured(text), pixels).value();
}

TEST(Thumbnail, ShowsThePaperInItsColoursAndNothingAround) {
  const Image image = pictureOf("square 100; fold valley 50,0 50,100 left", 96);
  EXPECT_EQ(image.width, 96);
  EXPECT_EQ(image.height, 96);
  const Pixel middle = at(image, 48, 48);
  EXPECT_EQ(middle.alpha, 255);
  EXPECT_GT(middle.blue, 100) << "the back is up after folding in half";
  EXPECT_EQ(middle.red, 0);
  EXPECT_EQ(at(image, 2, 48).alpha, 0) << "beside the half sheet";
  EXPECT_EQ(at(image, 93, 48).alpha, 0);
}

TEST(Thumbnail, FillsTheSquareAtEverySize) {
  for (const int pixels : {1, 16, 48, 96, 192, 512}) {
    const Image image = pictureOf("square 100", pixels);
    EXPECT_EQ(image.width, pixels);
    if (pixels < 16) continue;
    EXPECT_GT(coverOf(image), 0.65) << pixels;
    EXPECT_LT(coverOf(image), 1) << pixels;
    const Pixel middle = at(image, pixels / 2, pixels / 2);
    EXPECT_GT(middle.red, 150);
    EXPECT_EQ(middle.alpha, 255);
  }
}

TEST(Thumbnail, OfPaperThatStandsUprightIsNarrow) {
  const Image image = pictureOf("square 100; fold valley 90 0,1 100,1 left", 64);
  EXPECT_GT(coverOf(image), 0.01);
  EXPECT_LT(coverOf(image), 0.1);
}

TEST(Thumbnail, OfManyNarrowFacetsStillShowsTheirColours) {
  std::string text = "square 100";
  for (int x = 99; x > 0; --x) {
    text += "; fold " + std::string(x % 2 == 0 ? "valley" : "mountain") + " 40 " +
            std::to_string(x) + ",0 " + std::to_string(x) + ",100 right in 0.5,50";
  }
  const Image image = pictureOf(text.c_str(), 96);
  double red = 0;
  int covered = 0;
  for (int x = 0; x < 96; ++x) {
    const Pixel pixel = at(image, x, 48);
    if (pixel.alpha == 0) continue;
    ++covered;
    red += pixel.red;
  }
  EXPECT_GT(covered, 80);
  EXPECT_GT(red / covered, 80) << "not black with lines";
}

TEST(Thumbnail, CanBeStopped) {
  const Model model = twoColoured("square 100");
  const Result<Image> stopped =
      thumbnailOf(startOf(model), model, 64, [](double) { return false; });
  ASSERT_FALSE(stopped.isOk());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(thumbnailOf(startOf(model), model, 0).error().code, ErrorCode::BadValue);
}

TEST(Thumbnail, FromTheSideShowsWhatStandsUp) {
  const Model model = twoColoured("square 100");
  const FoldedState state = run("square 100; fold valley 90 50,0 50,100 left");
  const Appearance appearance = appearanceOf(model);
  const Image front = thumbnailOf(state, appearance, 96).value();
  const Image side = thumbnailOf(state, appearance, ViewSpec{-90, 20}, 96, 1).value();
  const auto blueOf = [](const Image& image) {
    int count = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const Pixel p = at(image, x, y);
        count += p.blue > 80 && p.red < 40 && p.alpha > 200 ? 1 : 0;
      }
    return count;
  };
  EXPECT_LT(blueOf(front), 150) << "the half that stands up is seen as a line";
  EXPECT_GT(blueOf(side), 400) << "its back";
}

TEST(Thumbnail, OfThePatternShowsTheWholeSheetWithItsCreases) {
  const Model model = twoColoured("square 100");
  const FoldedState folded = run("square 100; fold valley 50,0 50,100 left");
  const Image image = patternThumbnail(folded, appearanceOf(model), 96).value();
  EXPECT_GT(coverOf(image), 0.85) << "unfolded";
  EXPECT_GT(at(image, 24, 48).red, 150);
  const Pixel crease = at(image, 48, 50);
  const Pixel beside = at(image, 60, 50);
  EXPECT_NE(crease.red + crease.green + crease.blue, beside.red + beside.green + beside.blue);
}

}  // namespace
}  // namespace kiri::test
