// Where each facet of a time line is when: the key frames of an animation.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/timeline.h"
#include "io/facet_triangles.h"

namespace kiri {

/// A facet's place at a time.
struct PlaceKey {
  double seconds = 0;
  Vec3 position;
  std::array<double, 4> turn = {0, 0, 0, 1};  ///< quaternion x, y, z, w
};

/// One facet from the time when it comes to be until it is divided or thrown away, and again, where
/// it comes back.
struct FacetTrack {
  int mesh = 0;
  std::vector<PlaceKey> keys;  ///< times grow strictly, as single-precision numbers too
  std::vector<std::pair<double, double>> shown;  ///< from, to; in order, apart
};

/// All in mm.
struct TrackOptions {
  double gap = 0;         ///< by which layers are lifted
  double error = 0;       ///< by which linear interpolation between two keys may miss
  double chordError = 0;  ///< by which polylines may miss curves; 0: the finest
};

/// Follows all facets through a time line. `meshOf` names the shape of a facet: one name, one
/// facet. Errors: Cancelled.
Result<std::vector<FacetTrack>> tracksOf(const Timeline& timeline, const TrackOptions& options,
                                         const std::function<int(const FacetTriangles&)>& meshOf,
                                         const Progress& progress);

/// Between two turns, evenly, the shorter way, as viewers do it.
std::array<double, 4> slerp(const std::array<double, 4>& a, const std::array<double, 4>& b,
                            double part);

}  // namespace kiri
