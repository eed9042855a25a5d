// The facets of a model as meshes of a glTF document, in the colours of the paper.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/geometry/rigid.h"
#include "io/facet_triangles.h"
#include "io/gltf_document.h"
#include "io/gltf_writer.h"

namespace kiri {

/// Adds materials and meshes to a document. Facets of the same shape at the same place of the paper
/// share a mesh, whichever state they come from.
class GltfMeshes {
 public:
  GltfMeshes(GltfDocument& document, const GltfOptions& options);

  /// The mesh of a facet at rest, paper frame with z = 0.
  int meshOf(const FacetTriangles& facet);

 private:
  struct Material {
    int index = 0;
    bool hasTexture = false;
  };

  Material addMaterial(const std::string& name, const GltfSide& side);
  JsonValue primitiveOf(const FacetTriangles& facet, PlateSide side);
  JsonValue rimOf(const FacetTriangles& facet);
  int positionsOf(const FacetTriangles& facet, double lift);
  int normalsOf(std::size_t count, bool isFront);
  int texturePlacesOf(const FacetTriangles& facet, bool isFront);

  GltfDocument& document_;
  GltfOptions options_;
  Material front_;
  Material back_;
  Material rim_;
  std::map<std::vector<double>, int> meshes_;
  std::map<std::pair<std::size_t, bool>, int> normals_;
  int sharedPositions_ = -1;  ///< of the facet under way, when both sides lie in one plane
};

/// The node above all facets: it makes metres of mm and lays the model on glTF's ground.
JsonValue gltfRoot(const std::string& title, const std::vector<int>& children);

/// What glTF could not hold, in sentences.
std::vector<std::string> gltfLosses(bool hadCurves);

/// A rotation as glTF has it: x, y, z, w of a unit quaternion, w not negative.
std::array<double, 4> quaternionOf(const Rigid& pose);

}  // namespace kiri
