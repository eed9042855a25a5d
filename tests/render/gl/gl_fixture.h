// A test with a context of OpenGL, and what helps to compare pictures.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "render/gl/renderer.h"
#include "render/scene/view_spec.h"
#include "tests/render/gl/headless_gl.h"
#include "tests/support/random_steps.h"

namespace kiri::test {

/// Runs with desktop OpenGL and with OpenGL ES; skipped where EGL cannot be had.
class GlTest : public ::testing::TestWithParam<GlKind> {
 protected:
  void SetUp() override;
  void TearDown() override { renderer_.reset(); }

  Image drawn(const GlView& view);

  std::unique_ptr<HeadlessGl> gl_;
  std::unique_ptr<GlRenderer> renderer_;
};

std::string nameOf(const ::testing::TestParamInfo<GlKind>& parameter);

/// A square picture of the box on white: paper alone, without light.
GlView plainView(const ViewFrame& frame, const Box& box, int pixels, const PaperMesh& mesh);

ViewSpec randomView(Random& random);

const std::uint8_t* pixelAt(const Image& image, int x, int y);
/// The largest difference of the three colours.
int differenceAt(const Image& a, const Image& b, int x, int y);
/// All pixels around have the same colour.
bool isCalm(const Image& image, int x, int y);
/// Each pixel the mean of the (2 r + 1)^2 around it; at the rim of fewer.
Image blurred(const Image& image, int radius);

}  // namespace kiri::test
