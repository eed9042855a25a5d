// The facets of a state as polygons that share vertices, as exchange formats want them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/base/vec.h"
#include "core/paper/crease_pattern.h"

namespace kiri {

/// A convex polygon of paper: a facet, or a part of one that is not convex.
struct MeshFace {
  FacetId facet;
  std::vector<std::uint32_t> vertices;  ///< counter-clockwise on the paper
  std::vector<EdgeId>
      sources;  ///< the edge that side i (from vertex i on) lies on; none inside a facet
};

enum class MeshEdgeKind : std::uint8_t {
  Border,  ///< paper on one side only
  Hinge,   ///< joins two facets
  Cut,     ///< torn or cut, with paper on both sides
  Join,    ///< divides one facet into convex faces; no crease
};

/// A side of one face, or the side that two faces share.
struct MeshEdge {
  static constexpr std::uint32_t kNoFace = 0xFFFFFFFF;

  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t left = kNoFace;   ///< the face that runs along it forwards
  std::uint32_t right = kNoFace;  ///< the face that runs along it backwards
  MeshEdgeKind kind = MeshEdgeKind::Border;
  EdgeId source;  ///< none for a join
};

struct FacetMesh {
  std::vector<Vec2> vertices;  ///< paper frame, mm
  std::vector<MeshFace> faces;
  std::vector<MeshEdge> edges;
  bool hasCurves = false;  ///< some edges were curves and are polylines now
  bool hasJoins = false;   ///< some facets were divided
};

/// The mesh of a pattern. Faces are convex, without holes, and neighbours share whole sides; curves
/// are polylines within `chordError`, mm; 0: within tolerance.flattening().
FacetMesh meshOf(const CreasePattern& pattern, double chordError = 0);

}  // namespace kiri
