// The soft shadow that the model casts on the table it lies on.
// SPDX-License-Identifier: MIT
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <string>

#include "render/gl/buffers.h"
#include "render/gl/program.h"
#include "render/mesh/paper_mesh.h"

namespace kiri {

/// Under a lamp with some width at the upper left, as in the pictures of the CPU (ViewSpec). The
/// shadow is drawn once for each mesh, as the share of the lamp that each place of the table does
/// not see; views only look at it.
class TableShadow {
 public:
  explicit TableShadow(const std::string& header);
  ~TableShadow();
  TableShadow(const TableShadow&) = delete;
  TableShadow& operator=(const TableShadow&) = delete;

  /// The table is a little below the mesh.
  void setMesh(const PaperMesh& mesh);
  /// The first time after setMesh: draws the shadow into its own framebuffer, and binds again the
  /// one that is bound.
  void prepare(const MeshBuffers& buffers);
  /// Draws it where the clip matrix puts the table. Nothing is tested or written but colour.
  void draw(const std::array<float, 16>& clip) const;

 private:
  void makeTarget();

  Program fall_;
  Program table_;
  GLuint texture_ = 0;
  GLuint depth_ = 0;
  GLuint framebuffer_ = 0;
  GLuint nothing_ = 0;  ///< a vertex array without attributes
  std::array<float, 4> box_{0, 0, 1, 1};
  float height_ = 0;  ///< of the table, relative to the origin of the mesh
  bool isStale_ = true;
};

}  // namespace kiri
