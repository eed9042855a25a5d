// What is seen of a state, sample by sample: slow, short, and independent of render/visibility.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vec.h"
#include "core/geometry/cubic.h"
#include "core/paper/folded_state.h"

namespace kiri::test {

/// Where the eye is: orthonormal axes of the model frame; in perspective (`distance` above 0) it is
/// so far above `centre`, and what lies in the plane of the centre appears in true size.
struct Eye {
  Vec3 right;
  Vec3 up;
  Vec3 toEye;
  Vec3 centre;
  double distance = 0;
};

/// Rows of samples from the top; a sample is a facet's index, or one of the values below.
struct DepthPicture {
  static constexpr std::int32_t kNothing = -1;
  /// Layers contradict each other here, or planes meet: no answer is asked for.
  static constexpr std::int32_t kUnclear = -2;
  int width = 0;
  int height = 0;
  std::vector<std::int32_t> samples;

  std::int32_t at(int x, int y) const {
    if (x < 0 || y < 0 || x >= width || y >= height) return kNothing;
    return samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)];
  }
};

/// The nearest facet at the middle of each of width x height cells of `box` (view coordinates):
/// within one layer-set by the layer order, else by depth along the line of sight. Facets turned to
/// the eye by less than 1/10000 are left out. Curves become 256 chords.
DepthPicture depthPicture(const FoldedState& state, const Eye& eye, const Box& box, int width,
                          int height);

/// The same raster of loops that do not overlap, one set of loops for each facet that is seen.
struct SeenLoops {
  std::int32_t facet = 0;
  std::vector<std::vector<Arc>> loops;
};
DepthPicture pictureOf(const std::vector<SeenLoops>& seen, const Box& box, int width, int height);

/// How many samples of `drawn` show what `truth` shows neither there nor at any of the eight
/// samples around. Unclear samples are left out.
int wrongSamples(const DepthPicture& drawn, const DepthPicture& truth);

}  // namespace kiri::test
