// A view as the numbers that shaders take.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "render/gl/renderer.h"

namespace kiri {

/// From places relative to `origin` to clip space, column by column. The picture is that of
/// ViewFrame::project, depth that of ViewFrame::depth.
std::array<float, 16> clipMatrix(const GlView& view, Vec3 origin);

/// From directions of the model frame to the axes of the view, column by column.
std::array<float, 9> viewMatrix(const ViewFrame& frame);

/// Place of the eye relative to `origin` and 1, or the direction to it and 0.
std::array<float, 4> eyeOf(const ViewFrame& frame, Vec3 origin);

/// Depth in clip space by pixels of paper that is turned away by 45 degrees.
float flatSlopeOf(const GlView& view);

}  // namespace kiri
