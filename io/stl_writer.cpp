// Binary STL files of the folded model (docs/formats/stl.md).
// SPDX-License-Identifier: MIT
#include "io/stl_writer.h"

#include <cstdint>
#include <utility>

#include "core/layers/layer_levels.h"
#include "io/bytes.h"
#include "io/facet_mesh.h"
#include "io/facet_triangles.h"

namespace kiri {

namespace {

class StlBytes {
 public:
  explicit StlBytes(double thickness) : thickness_(thickness) {}

  void addFacet(const FacetTriangles& facet, const Rigid& pose) {
    addSide(facet, pose, PlateSide::Front);
    if (thickness_ == 0) return;
    addSide(facet, pose, PlateSide::Back);
    addSide(facet, pose, PlateSide::Rim);
  }

  std::string finish() {
    constexpr std::size_t kHeader = 80;
    std::string header = "KiriSim, lengths in mm";  // not "solid", which would mean text
    header.resize(kHeader, ' ');
    appendUint32(header, count_);
    return header + triangles_;
  }

 private:
  void addSide(const FacetTriangles& facet, const Rigid& pose, PlateSide side) {
    for (const PlateTriangle& triangle : plateTriangles(facet, side)) {
      Vec3 corners[3];
      for (std::size_t k = 0; k < 3; ++k) {
        const double lift = triangle[k].isFront ? thickness_ / 2 : -thickness_ / 2;
        corners[k] = pose.apply(facet.points[triangle[k].point]) + pose.normal() * lift;
      }
      const Vec3 across = cross(corners[1] - corners[0], corners[2] - corners[0]);
      const double size = length(across);
      addVector(size > 0 ? across / size : Vec3{});
      for (const Vec3 corner : corners) addVector(corner);
      appendUint16(triangles_, 0);
      ++count_;
    }
  }

  void addVector(Vec3 v) {
    appendFloat(triangles_, v.x);
    appendFloat(triangles_, v.y);
    appendFloat(triangles_, v.z);
  }

  double thickness_;
  std::string triangles_;
  std::uint32_t count_ = 0;
};

}  // namespace

Exported writeStl(const FoldedState& state, const StlOptions& options) {
  const FacetMesh mesh = meshOf(state.pattern);
  const std::vector<Rigid> poses = options.isPattern
                                       ? std::vector<Rigid>(state.poses.size())
                                       : spreadPoses(state, options.thickness + options.layerGap);
  StlBytes bytes(options.thickness);
  for (const FacetTriangles& facet : trianglesOf(state.pattern, mesh)) {
    bytes.addFacet(facet, poses[facet.facet.index]);
  }
  std::vector<std::string> losses = {
      "STL holds triangles only: no colours, creases, layers or fold angles"};
  if (mesh.hasCurves) losses.push_back("STL has no curves: curved edges became polylines");
  return {bytes.finish(), std::move(losses)};
}

}  // namespace kiri
