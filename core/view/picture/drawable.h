// A mesh on the GPU.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "view/picture/scene_mesh.h"

namespace lsos {

class Drawable {
 public:
  explicit Drawable(const SceneMesh& mesh)
      : count_(static_cast<GLsizei>(3 * mesh.triangles.size())) {
    glGenVertexArrays(1, &arrays_);
    glBindVertexArray(arrays_);
    glGenBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    fill(GL_ARRAY_BUFFER, vertices(), std::as_bytes(std::span(mesh.vertices)));
    fill(GL_ELEMENT_ARRAY_BUFFER, own_triangles(), std::as_bytes(std::span(mesh.triangles)));
    const std::array<std::pair<GLint, std::size_t>, 4> parts{
        {{3, offsetof(SceneVertex, p_m)},
         {3, offsetof(SceneVertex, normal)},
         {3, offsetof(SceneVertex, colour)},
         {1, offsetof(SceneVertex, sun_share)}}};
    for (GLuint k = 0; k < parts.size(); ++k) {
      glEnableVertexAttribArray(k);
      glVertexAttribPointer(k, parts[k].first, GL_FLOAT, GL_FALSE, sizeof(SceneVertex),
                            // OpenGL takes the offset in the buffer as a pointer.
                            // NOLINTNEXTLINE(performance-no-int-to-ptr)
                            reinterpret_cast<const void*>(parts[k].second));
    }
  }
  ~Drawable() {
    glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    glDeleteVertexArrays(1, &arrays_);
  }
  Drawable(const Drawable&) = delete;
  Drawable& operator=(const Drawable&) = delete;

  void draw() const {
    glBindVertexArray(arrays_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, own_triangles());
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
  }
  // Draws other triangles of the same vertices.
  void draw(const std::vector<std::array<std::uint32_t, 3>>& triangles) const {
    glBindVertexArray(arrays_);
    fill(GL_ELEMENT_ARRAY_BUFFER, other_triangles(), std::as_bytes(std::span(triangles)));
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * triangles.size()), GL_UNSIGNED_INT,
                   nullptr);
  }

 private:
  GLuint vertices() const { return buffers_[0]; }
  GLuint own_triangles() const { return buffers_[1]; }
  GLuint other_triangles() const { return buffers_[2]; }
  static void fill(GLenum kind, GLuint buffer, std::span<const std::byte> bytes) {
    glBindBuffer(kind, buffer);
    glBufferData(kind, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  }

  GLuint arrays_ = 0;
  std::array<GLuint, 3> buffers_{};
  GLsizei count_;
};

}  // namespace lsos
