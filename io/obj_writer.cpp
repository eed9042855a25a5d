// Wavefront OBJ files of the folded model (docs/formats/obj.md).
// SPDX-License-Identifier: MIT
#include "io/obj_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/layers/layer_levels.h"
#include "io/facet_mesh.h"
#include "io/facet_triangles.h"
#include "io/json_tree.h"

namespace kiri {

namespace {

class ObjText {
 public:
  ObjText(const FoldedState& state, const ObjOptions& options)
      : state_(state), options_(options), mesh_(meshOf(state.pattern)) {
    if (options_.isPattern) {
      poses_.assign(state.poses.size(), Rigid{});
    } else {
      poses_ = spreadPoses(state, options_.layerGap + options_.thickness);
    }
  }

  Exported write() {
    out_ = "# KiriSim, lengths in mm\n";
    if (!options_.title.empty()) out_ += "# " + onOneLine(options_.title) + "\n";
    for (const FacetTriangles& facet : trianglesOf(state_.pattern, mesh_)) writeFacet(facet);
    std::vector<std::string> losses = {
        "OBJ holds no creases, layers or fold angles: only the shape is written"};
    if (mesh_.hasCurves) losses.push_back("OBJ has no curves: curved edges became polylines");
    return {std::move(out_), std::move(losses)};
  }

 private:
  static std::string onOneLine(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
  }

  static std::string number(double value) {
    constexpr double kParts = 1e9;
    return numberText(std::round(value * kParts) / kParts);
  }

  void writeFacet(const FacetTriangles& facet) {
    out_ += "g facet_" + std::to_string(facet.facet.index) + "\n";
    const Rigid& pose = poses_[facet.facet.index];
    const Vec3 half = pose.normal() * (options_.thickness / 2);
    fronts_ = vertices_ + 1;
    backs_ = fronts_;
    writePoints(facet, pose, half);
    if (options_.thickness > 0) {
      backs_ = vertices_ + 1;
      writePoints(facet, pose, -half);
    }
    writeSide(facet, PlateSide::Front, pose.normal());
    if (options_.thickness > 0 || options_.isTwoSided) {
      writeSide(facet, PlateSide::Back, -pose.normal());
    }
    if (options_.thickness > 0) writeRim(facet, pose);
  }

  void writePoints(const FacetTriangles& facet, const Rigid& pose, Vec3 lift) {
    const Vec2 size = options_.sheet.high - options_.sheet.low;
    for (const Vec2 paper : facet.points) {
      const Vec3 p = pose.apply(paper) + lift;
      out_ += "v " + number(p.x) + " " + number(p.y) + " " + number(p.z) + "\n";
      const Vec2 from = paper - options_.sheet.low;
      out_ += "vt " + number(size.x > 0 ? from.x / size.x : 0) + " " +
              number(size.y > 0 ? from.y / size.y : 0) + "\n";
      ++vertices_;
    }
  }

  void writeNormal(Vec3 normal) {
    out_ += "vn " + number(normal.x) + " " + number(normal.y) + " " + number(normal.z) + "\n";
    ++normals_;
  }

  void writeTriangle(const PlateTriangle& triangle) {
    out_ += "f";
    for (const PlateCorner& corner : triangle) {
      const std::string text = std::to_string((corner.isFront ? fronts_ : backs_) + corner.point);
      out_.append(" ").append(text).append("/").append(text).append("/");
      out_ += std::to_string(normals_);
    }
    out_ += "\n";
  }

  void writeSide(const FacetTriangles& facet, PlateSide side, Vec3 normal) {
    writeNormal(normal);
    out_ += side == PlateSide::Front ? "usemtl front\n" : "usemtl back\n";
    for (const PlateTriangle& triangle : plateTriangles(facet, side)) writeTriangle(triangle);
  }

  void writeRim(const FacetTriangles& facet, const Rigid& pose) {
    out_ += "usemtl rim\n";
    const std::vector<PlateTriangle> triangles = plateTriangles(facet, PlateSide::Rim);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& [from, to] = facet.rim[i / 2];
      if (i % 2 == 0) {
        const Vec2 along = facet.points[to] - facet.points[from];
        writeNormal(pose.direction(-perpendicular(normalized(along))));
      }
      writeTriangle(triangles[i]);
    }
  }

  const FoldedState& state_;
  ObjOptions options_;
  FacetMesh mesh_;
  std::vector<Rigid> poses_;
  std::string out_;
  std::size_t vertices_ = 0;
  std::size_t normals_ = 0;
  std::size_t fronts_ = 1;  ///< number of the first vertex of the facet's front
  std::size_t backs_ = 1;   ///< and of its back, the same where there is no thickness
};

}  // namespace

Exported writeObj(const FoldedState& state, const ObjOptions& options) {
  return ObjText(state, options).write();
}

}  // namespace kiri
