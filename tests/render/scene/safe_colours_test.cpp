// The colours for eyes that see fewer colours: told apart by computing what such eyes see.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/scene/line_looks.h"

namespace kiri {
namespace {

using Rgb = std::array<double, 3>;
using Matrix = std::array<Rgb, 3>;

// Machado, Oliveira and Fernandes 2009, severity 1, on linear RGB.
constexpr Matrix kProtan{{{0.152286, 1.052583, -0.204868},
                          {0.114503, 0.786281, 0.099216},
                          {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeutan{{{0.367322, 0.860646, -0.227968},
                          {0.280085, 0.672501, 0.047413},
                          {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritan{{{1.255528, -0.076749, -0.178779},
                          {-0.078411, 0.930809, 0.147602},
                          {0.004733, 0.691367, 0.303900}}};
constexpr Matrix kAll{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

double linear(int value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// CIE Lab of what the eye sees.
Rgb seenBy(const Matrix& eye, Color color) {
  const Rgb in{linear(color.red), linear(color.green), linear(color.blue)};
  Rgb c{};
  for (std::size_t i = 0; i < 3; ++i)
    c[i] = std::clamp(eye[i][0] * in[0] + eye[i][1] * in[1] + eye[i][2] * in[2], 0.0, 1.0);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.9505);
  const double y = f(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
  const double z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double difference(const Matrix& eye, Color a, Color b) {
  const Rgb p = seenBy(eye, a);
  const Rgb q = seenBy(eye, b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

Color colorOf(LineKind kind, LineStyle style) {
  Appearance looks;
  looks.lineStyle = style;
  return strokeFor(kind, looks, 1).color;
}

double leastDifference(LineStyle style) {
  constexpr LineKind kKinds[] = {LineKind::Mountain, LineKind::Valley, LineKind::Cut};
  double least = 1000;
  for (const Matrix& eye : {kAll, kProtan, kDeutan, kTritan}) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < i; ++k)
        least =
            std::min(least, difference(eye, colorOf(kKinds[i], style), colorOf(kKinds[k], style)));
  }
  return least;
}

TEST(SafeColours, MountainValleyAndCutAreToldApartByEveryEye) {
  // A difference of 2.3 is just seen side by side; thin lines apart from each other want far more.
  EXPECT_GT(leastDifference(LineStyle::Safe), 30);
  EXPECT_LT(leastDifference(LineStyle::Program), leastDifference(LineStyle::Safe))
      << "otherwise nobody needed them";
}

TEST(SafeColours, MountainAndValleyAlsoDifferInDashes) {
  Appearance looks;
  looks.lineStyle = LineStyle::Safe;
  EXPECT_NE(strokeFor(LineKind::Mountain, looks, 1).dashes.size(),
            strokeFor(LineKind::Valley, looks, 1).dashes.size());
}

}  // namespace
}  // namespace kiri
