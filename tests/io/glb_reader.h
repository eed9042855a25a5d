// A reader of GLB files of the tests' own, written from the glTF 2.0 specification.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/vec.h"

namespace kiri::test {

struct GlbTriangle {
  std::array<Vec3, 3> corners;  ///< metres, the scene's axes
  std::array<Vec3, 3> normals;
  std::string material;
};

struct GlbPart {
  std::string name;
  std::vector<GlbTriangle> triangles;
};

class GlbFile {
 public:
  /// Throws std::runtime_error on what is no GLB file of the kind that we write.
  explicit GlbFile(const std::string& bytes);

  const nlohmann::json& document() const { return document_; }
  /// Seconds of the last key frame; 0 without an animation.
  double duration() const;
  /// The nodes with meshes as they are seen at a time; those that are scaled to nothing are left
  /// out.
  std::vector<GlbPart> at(double seconds = 0) const;

 private:
  struct Place {
    std::vector<double> translation{0, 0, 0};
    std::vector<double> rotation{0, 0, 0, 1};
    std::vector<double> scale{1, 1, 1};
  };

  std::vector<std::vector<double>> values(std::size_t accessor) const;
  std::vector<Place> placesAt(double seconds) const;
  void animate(std::vector<Place>& places, double seconds) const;
  GlbPart partOf(std::size_t node, const std::vector<std::size_t>& chain,
                 const std::vector<Place>& places) const;

  nlohmann::json document_;
  std::string buffer_;
};

}  // namespace kiri::test
