// A glTF 2.0 document under construction: accessors into one buffer, and the GLB file around them.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/vec.h"
#include "io/json_tree.h"

namespace kiri {

/// What kind of bytes lie together in the buffer.
enum class GltfBytes { Vectors, Pairs, Shorts, Words, Keys };

/// Collects the parts of a document. Indices that functions return are those of the glTF file.
class GltfDocument {
 public:
  /// Vertex attributes. With `hasBounds` the accessor tells its box, as glTF asks of positions.
  int addVectors(const std::vector<Vec3>& values, bool hasBounds);
  int addPairs(const std::vector<Vec2>& values);
  /// Corners of triangles; `vertices`: how many the largest index may reach.
  int addIndices(const std::vector<std::uint32_t>& values, std::size_t vertices);
  /// Key frames: times in seconds with their bounds, and values of one, three or four numbers.
  int addTimes(const std::vector<double>& seconds);
  int addKeys(const std::vector<Vec3>& values);
  int addKeys(const std::vector<std::array<double, 4>>& values);

  /// An image file in the buffer. Returns the texture that shows it, clamped at its rim.
  int addPngTexture(const std::string& png);
  int addMaterial(JsonValue material) { return append(materials_, std::move(material)); }
  int addMesh(JsonValue mesh) { return append(meshes_, std::move(mesh)); }
  int addNode(JsonValue node) { return append(nodes_, std::move(node)); }
  int addAnimation(JsonValue animation) { return append(animations_, std::move(animation)); }

  /// The bytes of the GLB file whose scene has the node `root`.
  std::string finish(const std::string& generator, int root) const;

 private:
  struct Accessor {
    GltfBytes bytes;
    std::size_t offset;
    std::size_t count;
    const char* type;
    int componentType;
    std::vector<double> low;  ///< empty: no bounds
    std::vector<double> high;
  };

  static int append(JsonValue& list, JsonValue item);
  std::string& bytesOf(GltfBytes kind) { return bytes_[static_cast<std::size_t>(kind)]; }
  int addAccessor(GltfBytes kind, std::size_t count, const char* type, int componentType);
  JsonValue accessorsJson(const std::array<int, 5>& views) const;

  std::array<std::string, 5> bytes_;
  std::vector<Accessor> accessors_;
  std::vector<std::string> images_;
  JsonValue materials_ = JsonValue::array();
  JsonValue meshes_ = JsonValue::array();
  JsonValue nodes_ = JsonValue::array();
  JsonValue animations_ = JsonValue::array();
};

/// Arrays of numbers, as glTF's JSON has many.
JsonValue jsonNumbers(const std::vector<double>& values);
JsonValue jsonNumber(int value);

}  // namespace kiri
