// Each facet as triangles, flat or as a plate with thickness, for formats of surfaces and solids.
// SPDX-License-Identifier: MIT
#include "io/facet_triangles.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace kiri {

namespace {

class FacetTriangulator {
 public:
  FacetTriangulator(const CreasePattern& pattern, const FacetMesh& mesh)
      : pattern_(pattern), mesh_(mesh) {}

  void addFace(const MeshFace& face) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t vertex : face.vertices) corners.push_back(pointOf(vertex));
    addSides(corners);
    if (isFan(corners)) {
      for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        out_.triangles.push_back({corners[0], corners[k], corners[k + 1]});
      }
      return;
    }
    // A fan from a corner would have empty triangles along its own sides; leaving them out would
    // leave cracks.
    const auto middle = static_cast<std::uint32_t>(out_.points.size());
    out_.points.push_back(middleOf(corners));
    for (std::size_t k = 0; k < corners.size(); ++k) {
      out_.triangles.push_back({middle, corners[k], corners[(k + 1) % corners.size()]});
    }
  }

  FacetTriangles finish(FacetId facet) {
    out_.facet = facet;
    out_.rim.assign(open_.begin(), open_.end());
    return std::move(out_);
  }

 private:
  std::uint32_t pointOf(std::uint32_t vertex) {
    const auto [at, isNew] =
        places_.try_emplace(vertex, static_cast<std::uint32_t>(out_.points.size()));
    if (isNew) out_.points.push_back(mesh_.vertices[vertex]);
    return at->second;
  }

  /// What two faces of the facet share is inside it, slits too: they have no width.
  void addSides(const std::vector<std::uint32_t>& corners) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::array<std::uint32_t, 2> side = {corners[k], corners[(k + 1) % corners.size()]};
      if (open_.erase({side[1], side[0]}) == 0) open_.insert(side);
    }
  }

  bool isFan(const std::vector<std::uint32_t>& corners) const {
    const Vec2 start = out_.points[corners[0]];
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      const Vec2 a = out_.points[corners[k]] - start;
      const Vec2 b = out_.points[corners[k + 1]] - start;
      const double longest = std::max(length(a), length(b));
      if (cross(a, b) <= longest * pattern_.tolerance.match()) return false;
    }
    return true;
  }

  Vec2 middleOf(const std::vector<std::uint32_t>& corners) const {
    Vec2 sum;
    for (const std::uint32_t corner : corners) sum = sum + out_.points[corner];
    return sum / static_cast<double>(corners.size());
  }

  const CreasePattern& pattern_;
  const FacetMesh& mesh_;
  FacetTriangles out_;
  std::map<std::uint32_t, std::uint32_t> places_;
  std::set<std::array<std::uint32_t, 2>> open_;
};

}  // namespace

std::vector<FacetTriangles> trianglesOf(const CreasePattern& pattern, const FacetMesh& mesh) {
  std::vector<FacetTriangles> out;
  std::size_t face = 0;
  while (face < mesh.faces.size()) {
    const FacetId facet = mesh.faces[face].facet;
    FacetTriangulator triangulator(pattern, mesh);
    for (; face < mesh.faces.size() && mesh.faces[face].facet == facet; ++face) {
      triangulator.addFace(mesh.faces[face]);
    }
    out.push_back(triangulator.finish(facet));
  }
  return out;
}

std::vector<PlateTriangle> plateTriangles(const FacetTriangles& facet, PlateSide side) {
  std::vector<PlateTriangle> out;
  if (side == PlateSide::Rim) {
    for (const auto& [from, to] : facet.rim) {
      out.push_back({{{from, false}, {to, false}, {to, true}}});
      out.push_back({{{from, false}, {to, true}, {from, true}}});
    }
    return out;
  }
  const bool isFront = side == PlateSide::Front;
  for (const auto& [a, b, c] : facet.triangles) {
    out.push_back({{{a, isFront}, {isFront ? b : c, isFront}, {isFront ? c : b, isFront}}});
  }
  return out;
}

}  // namespace kiri
