// glTF 2.0 files (binary, GLB) of the folded model (docs/formats/gltf.md).
// SPDX-License-Identifier: MIT
#include "io/gltf_writer.h"

#include <string>
#include <utility>
#include <vector>

#include "core/layers/layer_levels.h"
#include "io/facet_mesh.h"
#include "io/gltf_document.h"
#include "io/gltf_meshes.h"

namespace kiri {

Exported writeGlb(const FoldedState& state, const GltfOptions& options) {
  const FacetMesh mesh = meshOf(state.pattern, options.chordError);
  const std::vector<Rigid> poses = options.isPattern
                                       ? std::vector<Rigid>(state.poses.size())
                                       : spreadPoses(state, options.thickness + options.layerGap);
  GltfDocument document;
  GltfMeshes meshes(document, options);
  std::vector<int> children;
  for (const FacetTriangles& facet : trianglesOf(state.pattern, mesh)) {
    const Rigid& pose = poses[facet.facet.index];
    const std::array<double, 4> turn = quaternionOf(pose);
    JsonValue node = JsonValue::object();
    node.add("name", JsonValue::ofText("facet_" + std::to_string(facet.facet.index)));
    node.add("mesh", jsonNumber(meshes.meshOf(facet)));
    node.add("translation", jsonNumbers({pose.origin.x, pose.origin.y, pose.origin.z}));
    node.add("rotation", jsonNumbers({turn.begin(), turn.end()}));
    children.push_back(document.addNode(std::move(node)));
  }
  const int root = document.addNode(gltfRoot(options.title, children));
  return {document.finish(options.generator, root), gltfLosses(mesh.hasCurves)};
}

}  // namespace kiri
