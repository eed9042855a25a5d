// Frames of films: the right count, room for every moment, nothing but paper and camera moves.
// SPDX-License-Identifier: MIT
#include "render/film/film.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "render/canvas/rasterise.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri {
namespace {

constexpr Color kGround{255, 0, 255};

Color at(const Image& image, int x, int y) {
  const std::size_t i = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x)) *
                        4;
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
}

std::size_t paperPixels(const Image& image) {
  std::size_t count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) count += at(image, x, y) == kGround ? 0U : 1U;
  }
  return count;
}

/// Pixels other than the ground along the rim of the picture.
std::size_t rimPixels(const Image& image) {
  std::size_t count = 0;
  for (int x = 0; x < image.width; ++x) {
    count += at(image, x, 0) == kGround ? 0U : 1U;
    count += at(image, x, image.height - 1) == kGround ? 0U : 1U;
  }
  for (int y = 0; y < image.height; ++y) {
    count += at(image, 0, y) == kGround ? 0U : 1U;
    count += at(image, image.width - 1, y) == kGround ? 0U : 1U;
  }
  return count;
}

FilmOptions options(int width, int height) {
  FilmOptions out;
  out.width = width;
  out.height = height;
  out.framesPerSecond = 10;
  out.background = kGround;
  out.view.azimuth = 30;
  out.view.elevation = 40;
  return out;
}

Timeline timelineOf(const Model& model, const TimelineOptions& time = {}) {
  Result<Timeline> line = Timeline::of(model, time);
  EXPECT_TRUE(line.isOk()) << line.error().message;
  return std::move(*line);
}

constexpr const char* kTwoFolds =
    "square 100\nfold a valley 50,0 50,100 left\nfold b mountain m:50,50 m:100,50 @model left";

TEST(Rasterise, FillsExactlySoManyOpaquePixelsWithTheSceneInTheMiddle) {
  Scene scene;
  scene.width = 20;
  scene.height = 10;
  scene.background = Color{255, 255, 0};
  FillItem square;
  const Vec2 corners[] = {{0, 0}, {20, 0}, {20, 10}, {0, 10}};
  Loop loop;
  for (int i = 0; i < 4; ++i) loop.push_back(Arc::line(corners[i], corners[(i + 1) % 4]));
  square.loops = {loop};
  square.fill.color = {10, 20, 30};
  scene.groups.push_back({"g", "g", {{square, "paper", "", {}}}, {}});
  const Result<Image> image = rasterise(scene, 40, 40);
  ASSERT_TRUE(image.isOk());
  ASSERT_EQ(image->rgba.size(), 40u * 40u * 4u);
  for (std::size_t i = 3; i < image->rgba.size(); i += 4) ASSERT_EQ(image->rgba[i], 255);
  for (int x = 0; x < 40; ++x) {
    EXPECT_EQ(at(*image, x, 9), (Color{255, 255, 0}));
    EXPECT_EQ(at(*image, x, 10), (Color{10, 20, 30}));
    EXPECT_EQ(at(*image, x, 29), (Color{10, 20, 30}));
    EXPECT_EQ(at(*image, x, 30), (Color{255, 255, 0}));
  }
}

TEST(Rasterise, RefusesSizesThatNoPictureHas) {
  Scene scene;
  scene.width = scene.height = 10;
  EXPECT_FALSE(rasterise(scene, 0, 10).isOk());
  EXPECT_FALSE(rasterise(scene, 10, 20000).isOk());
  scene.width = 0;
  EXPECT_FALSE(rasterise(scene, 10, 10).isOk());
}

TEST(Film, HasAFrameForEveryPartOfASecond) {
  const Timeline line = timelineOf(test::modelOf(kTwoFolds));
  const Result<Film> film = Film::of(line, {}, options(64, 48));
  ASSERT_TRUE(film.isOk());
  EXPECT_NEAR(static_cast<double>(film->frameCount()), line.duration() * 10, 0.5);
  std::size_t shown = 0;
  std::size_t made = 0;
  const Status shot = shoot(*film, [&](const Image& frame, std::size_t times) -> Status {
    EXPECT_EQ(frame.width, 64);
    EXPECT_EQ(frame.height, 48);
    shown += times;
    ++made;
    return std::monostate{};
  });
  EXPECT_TRUE(shot.isOk());
  EXPECT_EQ(shown, film->frameCount());
  EXPECT_LT(made, shown) << "rests are drawn once";
}

TEST(Film, RepeatsOnlyFramesThatLookTheSame) {
  const Timeline line = timelineOf(test::modelOf(kTwoFolds));
  for (const bool moves : {false, true}) {
    FilmOptions wanted = options(64, 48);
    if (moves) wanted.camera = {{0, 0, 90}, {0.5, 40, 30}};
    const Result<Film> film = Film::of(line, {}, wanted);
    ASSERT_TRUE(film.isOk());
    std::size_t repeated = 0;
    for (std::size_t i = 0; i < film->frameCount(); i += film->repeatsAt(i)) {
      const std::size_t last = i + film->repeatsAt(i) - 1;
      EXPECT_EQ(film->frameAt(i)->rgba, film->frameAt(last)->rgba) << i;
      repeated += last - i;
    }
    EXPECT_GT(repeated, moves ? 5u : 15u);
  }
}

TEST(Film, HasRoomForEveryMomentOfRandomModelsFromEverywhere) {
  int films = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    test::Random random(seed);
    Model model = test::randomSheet(random);
    FoldedState state = test::startOf(model);
    for (int i = 0; i < 6; ++i) {
      const Step step = test::randomStep(random, state, {});
      model.steps.push_back(step);
      const Result<Timeline> tried = Timeline::of(model);
      if (!tried.isOk()) {
        model.steps.pop_back();
        continue;
      }
      state = tried->stateAfter(model.steps.size());
    }
    TimelineOptions time;
    time.degreesPerSecond = 360;
    const Timeline line = timelineOf(model, time);
    FilmOptions wanted = options(80, 60);
    wanted.view.azimuth = random.between(-180, 180);
    wanted.view.elevation = random.between(-90, 90);
    wanted.view.fieldOfView = seed % 3 == 0 ? 50 : 0;
    wanted.view.thickness = seed % 4 == 0 ? 2 : 0;
    wanted.view.hasShadow = false;
    if (seed % 2 == 0) wanted.camera = {{0, 10, 80}, {1, 300, -20}};
    const Result<Film> film = Film::of(line, {}, wanted);
    ASSERT_TRUE(film.isOk()) << film.error().message;
    std::size_t most = 0;
    for (std::size_t i = 0; i < film->frameCount(); i += film->repeatsAt(i)) {
      const Result<Image> frame = film->frameAt(i);
      ASSERT_TRUE(frame.isOk()) << frame.error().message;
      EXPECT_EQ(rimPixels(*frame), 0u) << "seed " << seed << ", frame " << i;
      most = std::max(most, paperPixels(*frame));
    }
    EXPECT_GT(most, 50u) << "seed " << seed;
    ++films;
  }
  EXPECT_EQ(films, 12);
}

TEST(Film, LeavesPaperThatRestsWhereItIs) {
  // The right half of the sheet stays on the table while the left one turns over it and beyond.
  const Timeline line =
      timelineOf(test::modelOf("rectangle 120 100\nfold a mountain 90 60,0 60,100 left"));
  FilmOptions wanted = options(120, 90);
  wanted.view = frontSpec();
  const Result<Film> film = Film::of(line, {}, wanted);
  ASSERT_TRUE(film.isOk());
  const Result<Image> first = film->frameAt(0);
  std::size_t same = 0;
  for (std::size_t i = 0; i < film->frameCount(); i += film->repeatsAt(i)) {
    const Result<Image> frame = film->frameAt(i);
    bool isSame = true;
    for (int y = 0; y < 90; ++y) {
      for (int x = 64; x < 120; ++x) isSame = isSame && at(*frame, x, y) == at(*first, x, y);
    }
    EXPECT_TRUE(isSame) << "frame " << i;
    same += isSame ? 1 : 0;
  }
  EXPECT_GT(same, 5u);
}

TEST(Film, OnATurntableEndsWhereItBegan) {
  TimelineOptions time;
  time.firstStep = 2;
  time.startHold = 2;
  time.endHold = 0;
  const Timeline line = timelineOf(test::modelOf(kTwoFolds), time);
  FilmOptions wanted = options(64, 48);
  wanted.camera = {{0, 30, 40}, {1, 390, 40}};
  const Result<Film> film = Film::of(line, {}, wanted);
  ASSERT_TRUE(film.isOk());
  ASSERT_EQ(film->frameCount(), 20u);
  EXPECT_EQ(film->frameAt(0)->rgba, film->frameAt(19)->rgba);
  EXPECT_NE(film->frameAt(0)->rgba, film->frameAt(10)->rgba);
}

TEST(Film, RefusesWhatNoFilmHasAndStopsWhenTold) {
  const Timeline line = timelineOf(test::modelOf(kTwoFolds));
  FilmOptions wanted = options(64, 48);
  wanted.framesPerSecond = 0;
  EXPECT_EQ(Film::of(line, {}, wanted).error().code, ErrorCode::BadValue);
  wanted = options(64, 4);
  EXPECT_EQ(Film::of(line, {}, wanted).error().code, ErrorCode::BadValue);
  wanted = options(64, 48);
  wanted.camera = {{0, 0, 100}};
  EXPECT_EQ(Film::of(line, {}, wanted).error().code, ErrorCode::BadValue);
  wanted = options(64, 48);
  const auto stop = [](double) { return false; };
  EXPECT_EQ(Film::of(line, {}, wanted, stop).error().code, ErrorCode::Cancelled);
  const Result<Film> film = Film::of(line, {}, wanted);
  ASSERT_TRUE(film.isOk());
  const Status shot = shoot(
      *film, [](const Image&, std::size_t) -> Status { return std::monostate{}; }, stop);
  EXPECT_EQ(shot.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace kiri
