// Wavefront OBJ files of the folded model (docs/formats/obj.md).
// SPDX-License-Identifier: MIT
#include "io/obj_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "io/facet_mesh.h"
#include "io/json_tree.h"

namespace kiri {

namespace {

class ObjText {
 public:
  ObjText(const FoldedState& state, const ObjOptions& options)
      : state_(state), options_(options), mesh_(meshOf(state.pattern)) {}

  Exported write() {
    out_ = "# KiriSim, lengths in mm\n";
    if (!options_.title.empty()) out_ += "# " + onOneLine(options_.title) + "\n";
    std::size_t face = 0;
    while (face < mesh_.faces.size()) {
      const FacetId facet = mesh_.faces[face].facet;
      std::vector<std::size_t> faces;
      for (; face < mesh_.faces.size() && mesh_.faces[face].facet == facet; ++face)
        faces.push_back(face);
      writeFacet(facet, faces);
    }
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

  Rigid placeOf(FacetId facet) const {
    if (options_.isPattern) return {};
    Rigid pose = state_.poseOf(facet);
    if (options_.layerGap != 0) {
      const LayerSet& set = state_.layers.sets()[state_.layers.setOf(facet)];
      pose.origin = pose.origin + set.normal * (options_.layerGap * state_.layers.rankOf(facet));
    }
    return pose;
  }

  void writeVertex(const Rigid& pose, Vec2 paper) {
    const Vec3 p = pose.apply(paper);
    out_ += "v " + number(p.x) + " " + number(p.y) + " " + number(p.z) + "\n";
    const Vec2 size = options_.sheet.high - options_.sheet.low;
    const Vec2 from = paper - options_.sheet.low;
    out_ += "vt " + number(size.x > 0 ? from.x / size.x : 0) + " " +
            number(size.y > 0 ? from.y / size.y : 0) + "\n";
  }

  void writeTriangle(std::size_t a, std::size_t b, std::size_t c, std::size_t normal) {
    out_ += "f";
    for (const std::size_t v : {a, b, c}) {
      const std::string text = std::to_string(v);
      out_.append(" ").append(text).append("/").append(text).append("/");
      out_ += std::to_string(normal);
    }
    out_ += "\n";
  }

  void writeFan(const std::vector<std::size_t>& starts, const std::vector<std::size_t>& faces,
                bool isFront) {
    const std::size_t normal = isFront ? normals_ : normals_ + 1;
    out_ += isFront ? "usemtl front\n" : "usemtl back\n";
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const std::size_t n = mesh_.faces[faces[i]].vertices.size();
      for (std::size_t k = 1; k + 1 < n; ++k) {
        const std::size_t second = starts[i] + (isFront ? k : k + 1);
        const std::size_t third = starts[i] + (isFront ? k + 1 : k);
        if (isTriangle(faces[i], k)) writeTriangle(starts[i], second, third, normal);
      }
    }
  }

  /// False for the empty triangles of a fan whose corners lie on one line.
  bool isTriangle(std::size_t face, std::size_t k) const {
    const std::vector<std::uint32_t>& loop = mesh_.faces[face].vertices;
    const Vec2 a = mesh_.vertices[loop[k]] - mesh_.vertices[loop[0]];
    const Vec2 b = mesh_.vertices[loop[k + 1]] - mesh_.vertices[loop[0]];
    const double longest = std::max(length(a), length(b));
    return cross(a, b) > longest * state_.tolerance().length();
  }

  void writeFacet(FacetId facet, const std::vector<std::size_t>& faces) {
    out_ += "g facet_" + std::to_string(facet.index) + "\n";
    const Rigid pose = placeOf(facet);
    std::vector<std::size_t> starts;
    for (const std::size_t face : faces) {
      starts.push_back(vertices_ + 1);
      for (const std::uint32_t v : mesh_.faces[face].vertices) {
        writeVertex(pose, mesh_.vertices[v]);
        ++vertices_;
      }
    }
    const Vec3 up = pose.normal();
    out_ += "vn " + number(up.x) + " " + number(up.y) + " " + number(up.z) + "\n";
    ++normals_;
    writeFan(starts, faces, true);
    if (!options_.isTwoSided) return;
    out_ += "vn " + number(-up.x) + " " + number(-up.y) + " " + number(-up.z) + "\n";
    writeFan(starts, faces, false);
    ++normals_;
  }

  const FoldedState& state_;
  ObjOptions options_;
  FacetMesh mesh_;
  std::string out_;
  std::size_t vertices_ = 0;
  std::size_t normals_ = 0;
};

}  // namespace

Exported writeObj(const FoldedState& state, const ObjOptions& options) {
  return ObjText(state, options).write();
}

}  // namespace kiri
