// Each facet as triangles, flat or as a plate with thickness, for formats of surfaces and solids.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/vec.h"
#include "io/facet_mesh.h"

namespace kiri {

/// One facet at rest. Every side of a triangle is the side of another one, backwards, or is in
/// `rim` once: surfaces made from it have no cracks, and plates are closed.
struct FacetTriangles {
  FacetId facet;
  std::vector<Vec2> points;                             ///< paper frame, mm
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise on the paper
  std::vector<std::array<std::uint32_t, 2>> rim;        ///< with the facet on the left
};

/// The facets of a pattern, in their order.
std::vector<FacetTriangles> trianglesOf(const CreasePattern& pattern, const FacetMesh& mesh);

/// A triangle of a plate: corners of the paper, each on the front or on the back.
struct PlateCorner {
  std::uint32_t point = 0;
  bool isFront = true;
};
using PlateTriangle = std::array<PlateCorner, 3>;

enum class PlateSide { Front, Back, Rim };

/// The triangles of one side of a plate, counter-clockwise seen from outside.
std::vector<PlateTriangle> plateTriangles(const FacetTriangles& facet, PlateSide side);

}  // namespace kiri
