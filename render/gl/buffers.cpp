// Meshes in the memory of the graphics processor.
// SPDX-License-Identifier: MIT
#include "render/gl/buffers.h"

#include <bit>
#include <cstddef>
#include <cstdint>

#include "render/gl/shaders.h"

namespace kiri {
namespace {

/// OpenGL takes places in buffers as pointers.
const void* place(std::size_t offset) {
  return std::bit_cast<const void*>(static_cast<std::uintptr_t>(offset));
}

template <class Attribute>
void floats(Attribute attribute, GLint count, std::size_t stride, std::size_t offset) {
  const auto index = static_cast<GLuint>(attribute);
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        place(offset));
}

template <class Attribute>
void integers(Attribute attribute, GLint count, GLenum type, std::size_t stride,
              std::size_t offset) {
  const auto index = static_cast<GLuint>(attribute);
  glEnableVertexAttribArray(index);
  glVertexAttribIPointer(index, count, type, static_cast<GLsizei>(stride), place(offset));
}

void layOutPaper() {
  constexpr std::size_t kStride = sizeof(MeshVertex);
  floats(PaperAttribute::Position, 3, kStride, offsetof(MeshVertex, position));
  static_assert(offsetof(MeshVertex, height) == offsetof(MeshVertex, normal) + 3 * sizeof(float));
  floats(PaperAttribute::Plane, 4, kStride, offsetof(MeshVertex, normal));
  floats(PaperAttribute::Paper, 2, kStride, offsetof(MeshVertex, paper));
  integers(PaperAttribute::Facet, 1, GL_UNSIGNED_INT, kStride, offsetof(MeshVertex, facet));
  integers(PaperAttribute::IsFront, 1, GL_UNSIGNED_INT, kStride, offsetof(MeshVertex, isFront));
}

void layOutLines() {
  constexpr std::size_t kStride = sizeof(MeshSegment);
  constexpr std::size_t kForm = offsetof(MeshSegment, kind);
  static_assert(sizeof(bool) == 1 && offsetof(MeshSegment, isThin) == kForm + 1 &&
                    offsetof(MeshSegment, isFromJoined) == kForm + 2 &&
                    offsetof(MeshSegment, isToJoined) == kForm + 3,
                "the shader reads them as four bytes");
  floats(LineAttribute::From, 3, kStride, offsetof(MeshSegment, from));
  floats(LineAttribute::To, 3, kStride, offsetof(MeshSegment, to));
  floats(LineAttribute::Normal, 3, kStride, offsetof(MeshSegment, normal));
  floats(LineAttribute::OtherNormal, 3, kStride, offsetof(MeshSegment, otherNormal));
  floats(LineAttribute::Along, 1, kStride, offsetof(MeshSegment, along));
  integers(LineAttribute::Form, 4, GL_UNSIGNED_BYTE, kStride, kForm);
  integers(LineAttribute::IsCovered, 1, GL_UNSIGNED_BYTE, kStride,
           offsetof(MeshSegment, isCovered));
  for (auto i = static_cast<GLuint>(LineAttribute::From);
       i <= static_cast<GLuint>(LineAttribute::IsCovered); ++i) {
    glVertexAttribDivisor(i, 1);
  }
}

void layOutShades() {
  constexpr std::size_t kStride = sizeof(MeshShade);
  static_assert(offsetof(MeshShade, strength) == offsetof(MeshShade, before) + 2 * sizeof(float));
  floats(ShadeAttribute::From, 3, kStride, offsetof(MeshShade, from));
  floats(ShadeAttribute::To, 3, kStride, offsetof(MeshShade, to));
  floats(ShadeAttribute::Normal, 3, kStride, offsetof(MeshShade, normal));
  floats(ShadeAttribute::Form, 3, kStride, offsetof(MeshShade, before));
  for (auto i = static_cast<GLuint>(ShadeAttribute::From);
       i <= static_cast<GLuint>(ShadeAttribute::Form); ++i) {
    glVertexAttribDivisor(i, 1);
  }
}

template <class T>
void fill(GLenum target, GLuint buffer, const std::vector<T>& content) {
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(content.size() * sizeof(T)), content.data(),
               GL_STREAM_DRAW);
}

}  // namespace

MeshBuffers::MeshBuffers() {
  glGenVertexArrays(1, &paper_);
  glGenVertexArrays(1, &shades_);
  glGenVertexArrays(1, &lines_);
  glGenBuffers(1, &vertices_);
  glGenBuffers(1, &triangles_);
  glGenBuffers(1, &shadePieces_);
  glGenBuffers(1, &segments_);
  glBindVertexArray(paper_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_);
  layOutPaper();
  glBindVertexArray(shades_);
  glBindBuffer(GL_ARRAY_BUFFER, shadePieces_);
  layOutShades();
  glBindVertexArray(lines_);
  glBindBuffer(GL_ARRAY_BUFFER, segments_);
  layOutLines();
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

MeshBuffers::~MeshBuffers() {
  glDeleteVertexArrays(1, &paper_);
  glDeleteVertexArrays(1, &shades_);
  glDeleteVertexArrays(1, &lines_);
  glDeleteBuffers(1, &vertices_);
  glDeleteBuffers(1, &triangles_);
  glDeleteBuffers(1, &shadePieces_);
  glDeleteBuffers(1, &segments_);
}

void MeshBuffers::upload(const PaperMesh& mesh) {
  glBindVertexArray(paper_);
  fill(GL_ARRAY_BUFFER, vertices_, mesh.vertices);
  fill(GL_ELEMENT_ARRAY_BUFFER, triangles_, mesh.triangles);
  glBindVertexArray(0);
  fill(GL_ARRAY_BUFFER, shadePieces_, mesh.shades);
  fill(GL_ARRAY_BUFFER, segments_, mesh.segments);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  indexCount_ = static_cast<GLsizei>(mesh.triangles.size());
  shadeCount_ = static_cast<GLsizei>(mesh.shades.size());
  segmentCount_ = static_cast<GLsizei>(mesh.segments.size());
}

void MeshBuffers::drawPaper() const {
  if (indexCount_ == 0) return;
  glBindVertexArray(paper_);
  glDrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

void MeshBuffers::drawShades() const {
  if (shadeCount_ == 0) return;
  constexpr GLsizei kCorners = 4;
  glBindVertexArray(shades_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, kCorners, shadeCount_);
}

void MeshBuffers::drawLines() const {
  if (segmentCount_ == 0) return;
  constexpr GLsizei kCorners = 6;
  glBindVertexArray(lines_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, kCorners, segmentCount_);
}

}  // namespace kiri
