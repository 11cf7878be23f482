#include "view/picture/sun_picture.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "view/gl/program.h"
#include "view/picture/canvas.h"

namespace lsos {

namespace {

constexpr double depth_half_m = 500;  // beyond it depth is clamped, and the nearest is not found

constexpr const char* sun_vertex_shader = R"(#version 330 core
uniform mat4 to_picture;
layout(location = 0) in vec3 p_m;
out vec3 at_m;
void main() {
  at_m = p_m;
  gl_Position = to_picture * vec4(p_m, 1.0);
}
)";
constexpr const char* sun_fragment_shader = R"(#version 330 core
uniform vec3 colour;
uniform vec3 towards;
uniform bool is_emissive;
in vec3 at_m;
out vec4 drawn;
void main() {
  vec3 normal = normalize(cross(dFdx(at_m), dFdy(at_m)));
  float shade = is_emissive ? 1.0 : 0.25 + 0.7 * abs(dot(normal, towards));
  drawn = vec4(colour * shade, 1.0);
}
)";

void draw_mesh(const Mesh& mesh) {
  GLuint arrays = 0;
  std::array<GLuint, 2> buffers{};
  glGenVertexArrays(1, &arrays);
  glBindVertexArray(arrays);
  glGenBuffers(2, buffers.data());
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof mesh.vertices[0]),
               mesh.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof mesh.triangles[0]),
               mesh.triangles.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * mesh.triangles.size()), GL_UNSIGNED_INT,
                 nullptr);
  glDeleteBuffers(2, buffers.data());
  glDeleteVertexArrays(1, &arrays);
}

// Column-major.
std::array<float, 16> sun_to_picture(const PictureFrame& frame) {
  const Vec3 right = frame.up.cross(frame.towards);
  std::array<float, 16> m{};
  const std::array<Vec3, 3> rows{right / frame.half_m, frame.up / frame.half_m,
                                 -frame.towards / depth_half_m};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      m[4 * j + i] = static_cast<float>(rows[i][static_cast<int>(j)]);
    }
    m[12 + i] = static_cast<float>(-rows[i].dot(frame.centre_m));
  }
  m[15] = 1;
  return m;
}

}  // namespace

Picture draw(const Gpu&, std::span<const PictureSolid> solids, const PictureFrame& frame) {
  const Canvas canvas(frame.size_px, frame.size_px);
  const Program program(sun_vertex_shader, sun_fragment_shader);
  glUseProgram(program.id());
  glViewport(0, 0, frame.size_px, frame.size_px);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glEnable(GL_DEPTH_CLAMP);  // a distant ridge hides too
  glDisable(GL_CULL_FACE);
  disable_clip_planes();
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const std::array<float, 16> matrix = sun_to_picture(frame);
  glUniformMatrix4fv(program.uniform("to_picture"), 1, GL_FALSE, matrix.data());
  const Eigen::Vector3f towards = frame.towards.cast<float>();
  glUniform3fv(program.uniform("towards"), 1, towards.data());
  for (const PictureSolid& solid : solids) {
    const Eigen::Vector3f colour = solid.colour.cast<float>();
    glUniform3fv(program.uniform("colour"), 1, colour.data());
    glUniform1i(program.uniform("is_emissive"), solid.is_emissive ? 1 : 0);
    draw_mesh(solid.mesh);
  }
  glDisable(GL_DEPTH_CLAMP);
  Picture picture{frame.size_px, {}};
  const auto row = static_cast<std::size_t>(3 * frame.size_px);
  std::vector<std::uint8_t> from_below(row * static_cast<std::size_t>(frame.size_px));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, frame.size_px, frame.size_px, GL_RGB, GL_UNSIGNED_BYTE, from_below.data());
  for (auto at = from_below.end(); at != from_below.begin();) {
    at -= static_cast<std::ptrdiff_t>(row);
    picture.rgb.insert(picture.rgb.end(), at, at + static_cast<std::ptrdiff_t>(row));
  }
  return picture;
}

int green_pixels(const Picture& picture) {
  int count = 0;
  for (std::size_t k = 0; k + 2 < picture.rgb.size(); k += 3) {
    count += picture.rgb[k] == 0 && picture.rgb[k + 1] == 255 && picture.rgb[k + 2] == 0;
  }
  return count;
}

}  // namespace lsos
