// A test with a context of OpenGL, and what helps to compare pictures.
// SPDX-License-Identifier: MIT
#include "tests/render/gl/gl_fixture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace kiri::test {

void GlTest::SetUp() {
  std::string why;
  gl_ = HeadlessGl::create(GetParam(), why);
  if (!gl_) GTEST_SKIP() << "not tested: " << why;
  renderer_ = *GlRenderer::create();
}

Image GlTest::drawn(const GlView& view) {
  gl_->begin(view.width, view.height);
  renderer_->draw(view);
  EXPECT_EQ(gl_->error(), 0U);
  return gl_->finish();
}

std::string nameOf(const ::testing::TestParamInfo<GlKind>& parameter) {
  return parameter.param == GlKind::Desktop33 ? "OpenGl33" : "OpenGlEs30";
}

GlView plainView(const ViewFrame& frame, const Box& box, int pixels, const PaperMesh& mesh) {
  GlView view;
  view.frame = frame;
  view.centre = (box.low + box.high) / 2;
  view.width = view.height = pixels;
  view.pixelsPerMm = pixels / (box.high.x - box.low.x);
  view.background = {255, 255, 255};
  view.showsEdges = view.showsCreases = view.showsBorders = view.isShaded = false;
  double low = 1e30;
  double high = -1e30;
  for (const MeshVertex& v : mesh.vertices) {
    const auto at = [&](std::size_t i) { return static_cast<double>(v.position[i]); };
    const Vec3 p = mesh.origin + Vec3{at(0), at(1), at(2)};
    low = std::min(low, frame.depth(p));
    high = std::max(high, frame.depth(p));
  }
  const double room = 1 + 0.05 * (high - low);
  view.nearDepth = high + room;
  view.farDepth = low - room;
  return view;
}

ViewSpec randomView(Random& random) {
  ViewSpec spec{random.between(-180, 180), random.between(-90, 90)};
  if (random.chance(0.5)) spec.fieldOfView = random.between(5, 110);
  return spec;
}

const std::uint8_t* pixelAt(const Image& image, int x, int y) {
  return &image.rgba[static_cast<std::size_t>(y * image.width + x) * 4];
}

int differenceAt(const Image& a, const Image& b, int x, int y) {
  int most = 0;
  for (int c = 0; c < 3; ++c) {
    most = std::max(most, std::abs(pixelAt(a, x, y)[c] - pixelAt(b, x, y)[c]));
  }
  return most;
}

bool isCalm(const Image& image, int x, int y) {
  const std::uint8_t* middle = pixelAt(image, x, y);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (!std::equal(middle, middle + 3, pixelAt(image, x + dx, y + dy))) return false;
    }
  }
  return true;
}

Image blurred(const Image& image, int radius) {
  Image out{image.width, image.height, {}};
  out.rgba.reserve(image.rgba.size());
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::array<int, 4> sum{};
      int count = 0;
      for (int v = std::max(y - radius, 0); v <= std::min(y + radius, image.height - 1); ++v) {
        for (int u = std::max(x - radius, 0); u <= std::min(x + radius, image.width - 1); ++u) {
          for (std::size_t c = 0; c < 4; ++c) sum[c] += pixelAt(image, u, v)[c];
          ++count;
        }
      }
      for (const int s : sum) out.rgba.push_back(static_cast<std::uint8_t>(s / count));
    }
  }
  return out;
}

}  // namespace kiri::test
