// Meshes in the memory of the graphics processor.
// SPDX-License-Identifier: MIT
#pragma once

#include <epoxy/gl.h>

#include "render/mesh/paper_mesh.h"

namespace kiri {

/// The vertex arrays of one mesh.
class MeshBuffers {
 public:
  MeshBuffers();
  ~MeshBuffers();
  MeshBuffers(const MeshBuffers&) = delete;
  MeshBuffers& operator=(const MeshBuffers&) = delete;

  /// New storage each time, so that nobody waits for frames that still use the old one.
  void upload(const PaperMesh& mesh);
  void drawPaper() const;
  void drawShades() const;
  void drawLines() const;

 private:
  GLuint paper_ = 0;  ///< vertex arrays
  GLuint shades_ = 0;
  GLuint lines_ = 0;
  GLuint vertices_ = 0;  ///< buffers
  GLuint triangles_ = 0;
  GLuint shadePieces_ = 0;
  GLuint segments_ = 0;
  GLsizei indexCount_ = 0;
  GLsizei shadeCount_ = 0;
  GLsizei segmentCount_ = 0;
};

}  // namespace kiri
