#include "view/exposure/panel_view.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "view/gl/program.h"

namespace lsos {

namespace {

// The picture has one tile per direction.
constexpr int tile_px = 64;
constexpr int tiles_across = 8;
static_assert(tiles_across * tiles_across == PanelView::directions_max);
constexpr int size_px = tile_px * tiles_across;

// Least cosine between normal and direction; below it the panel is seen edge-on.
constexpr double cosine_min = 1e-4;
constexpr int clip_planes = 6;

// to_panel maps a point to panel coordinates c: x and y are -1..1 across the panel, z is in metres
// towards the viewer. A line from c to a viewer at distance d meets the panel's plane at
// c.xy / (1 - c.z/d).
constexpr const char* panel_vertex_shader = R"(#version 330 core
uniform mat3 to_panel[64];
uniform float per_distance[64];
uniform vec2 margins_m;
layout(location = 0) in vec3 p_m;
const float across = 8.0;
out float gl_ClipDistance[6];
void main() {
  vec3 c = to_panel[gl_InstanceID] * p_m;
  float w = 1.0 - c.z * per_distance[gl_InstanceID];
  gl_ClipDistance[0] = w - c.x;
  gl_ClipDistance[1] = w + c.x;
  gl_ClipDistance[2] = w - c.y;
  gl_ClipDistance[3] = w + c.y;
  gl_ClipDistance[4] = c.z - margins_m.x;
  gl_ClipDistance[5] = w - margins_m.y * per_distance[gl_InstanceID];
  vec2 tile = vec2(float(gl_InstanceID % 8), float(gl_InstanceID / 8));
  gl_Position = vec4(((2.0 * tile + 1.0) * w + c.xy) / across - w, 0.0, w);
}
)";
constexpr const char* panel_fragment_shader = R"(#version 330 core
out vec4 colour;
void main() { colour = vec4(0.0, 0.0, 0.0, 1.0); }
)";

// Sides of the view, as flags: those that a point lies beyond from every viewpoint.
enum Beyond : unsigned { right = 1, left = 2, over = 4, under = 8, near = 16, behind = 32 };

struct View {
  Mat3 to_panel;
  double per_distance = 0;  // 1/m
};

// Culls triangles that lie beyond one side of the view from every viewpoint, as most of a rover
// does. The rest is drawn, and decides.
std::vector<std::array<std::uint32_t, 3>> triangles_in_view(const PanelFace& panel,
                                                            const Mesh& mesh,
                                                            const std::vector<View>& views) {
  constexpr double side = 1.001;  // exceeds 1 by more than single precision rounds
  const Vec3 normal = panel.normal();
  std::vector<unsigned> beyond;
  for (const auto& vertex : mesh.vertices) {
    const Vec3 p_m = Vec3(vertex[0], vertex[1], vertex[2]) - panel.centre_m;
    unsigned sides = right | left | over | under | near;
    for (const auto& [to_panel, per_distance] : views) {
      const Vec3 c = to_panel * p_m;
      const double w = 1 - c.z() * per_distance;
      sides &= (c.x() > side * w ? right : 0U) | (c.x() < -side * w ? left : 0U) |
               (c.y() > side * w ? over : 0U) | (c.y() < -side * w ? under : 0U) |
               (w < 0 ? near : 0U);
      if (sides == 0) break;
    }
    beyond.push_back(sides | (normal.dot(p_m) < 0 ? behind : 0U));
  }
  std::vector<std::array<std::uint32_t, 3>> kept;
  for (const auto& t : mesh.triangles) {
    if ((beyond[t[0]] & beyond[t[1]] & beyond[t[2]]) == 0) kept.push_back(t);
  }
  return kept;
}

}  // namespace

struct PanelView::Pipeline {
  Program program{panel_vertex_shader, panel_fragment_shader};
  GLuint framebuffer = 0, picture = 0, arrays = 0, vertices = 0, triangles = 0;
  GLint to_panel = 0, per_distance = 0, margins_m = 0;
  std::vector<GLubyte> pixels = std::vector<GLubyte>(std::size_t{size_px} * size_px);

  Pipeline() {
    to_panel = program.uniform("to_panel");
    per_distance = program.uniform("per_distance");
    margins_m = program.uniform("margins_m");

    glGenRenderbuffers(1, &picture);
    glBindRenderbuffer(GL_RENDERBUFFER, picture);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size_px, size_px);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, picture);
    LSOS_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);

    glGenVertexArrays(1, &arrays);
    glBindVertexArray(arrays);
    glGenBuffers(1, &vertices);
    glGenBuffers(1, &triangles);
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  }
  ~Pipeline() {
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(1, &picture);
    glDeleteVertexArrays(1, &arrays);
    glDeleteBuffers(1, &vertices);
    glDeleteBuffers(1, &triangles);
  }
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  void bind() const {
    glUseProgram(program.id());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindVertexArray(arrays);
    glViewport(0, 0, size_px, size_px);
    for (int k = 0; k < clip_planes; ++k) glEnable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(k));
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
  }
};

Mesh face_mesh(const PanelFace& face) {
  Mesh mesh;
  for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const Vec3 p = face.centre_m + u * face.half_u_m + v * face.half_v_m;
    mesh.vertices.push_back(
        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

PanelView::PanelView(const Gpu&) : pipeline_(std::make_unique<Pipeline>()) {}
PanelView::~PanelView() = default;

std::vector<double> PanelView::visible_shares(const PanelFace& panel, const Mesh& occluders,
                                              std::span<const Vec3> directions) {
  std::vector<Viewpoint> viewpoints;
  for (const Vec3& direction : directions) viewpoints.push_back({direction});
  return visible_shares(panel, occluders, viewpoints);
}

std::vector<double> PanelView::visible_shares(const PanelFace& panel, const Mesh& occluders,
                                              std::span<const Viewpoint> viewpoints,
                                              const ViewMargins& margins) {
  LSOS_ASSERT(viewpoints.size() <= directions_max);
  std::vector<double> shares(viewpoints.size(), 0.0);
  const Vec3 normal = panel.normal();
  // Only viewpoints in front of the panel get a tile.
  std::vector<float> matrices, per_distance;
  std::vector<View> views;
  std::vector<std::size_t> drawn;
  for (std::size_t k = 0; k < viewpoints.size(); ++k) {
    if (viewpoints[k].direction.dot(normal) < cosine_min) continue;
    Mat3 from_panel;
    from_panel << panel.half_u_m, panel.half_v_m, viewpoints[k].direction;
    views.push_back({from_panel.inverse(), 1 / viewpoints[k].distance_m});
    for (int j = 0; j < 9; ++j) {
      matrices.push_back(static_cast<float>(views.back().to_panel(j % 3, j / 3)));
    }
    per_distance.push_back(static_cast<float>(views.back().per_distance));
    drawn.push_back(k);
  }
  if (drawn.empty()) return shares;
  const std::vector<std::array<std::uint32_t, 3>> triangles =
      triangles_in_view(panel, occluders, views);
  if (triangles.empty()) {
    for (const std::size_t k : drawn) shares[k] = 1;
    return shares;
  }

  Pipeline& gl = *pipeline_;
  gl.bind();
  const auto count = static_cast<GLsizei>(drawn.size());
  glUniformMatrix3fv(gl.to_panel, count, GL_FALSE, matrices.data());
  glUniform1fv(gl.per_distance, count, per_distance.data());
  glUniform2f(gl.margins_m, static_cast<float>(margins.panel_m),
              static_cast<float>(margins.viewer_m));
  std::vector<std::array<float, 3>> vertices(occluders.vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    for (int j = 0; j < 3; ++j) {
      vertices[k][static_cast<std::size_t>(j)] = static_cast<float>(
          occluders.vertices[k][static_cast<std::size_t>(j)] - panel.centre_m[j]);
    }
  }
  glBindBuffer(GL_ARRAY_BUFFER, gl.vertices);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof vertices[0]),
               vertices.data(), GL_STREAM_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(triangles.size() * sizeof triangles[0]), triangles.data(),
               GL_STREAM_DRAW);

  // The panel fills each tile.
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(3 * triangles.size()), GL_UNSIGNED_INT,
                          nullptr, count);
  const int rows = (static_cast<int>(drawn.size()) + tiles_across - 1) / tiles_across;
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size_px, rows * tile_px, GL_GREEN, GL_UNSIGNED_BYTE, gl.pixels.data());
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    const auto column = static_cast<int>(k) % tiles_across * tile_px;
    const auto row = static_cast<int>(k) / tiles_across * tile_px;
    int green = 0;
    for (int j = 0; j < tile_px; ++j) {
      const GLubyte* line = &gl.pixels[static_cast<std::size_t>(row + j) * size_px + column];
      green += static_cast<int>(std::count(line, line + tile_px, 255));
    }
    shares[drawn[k]] = static_cast<double>(green) / (tile_px * tile_px);
  }
  return shares;
}

}  // namespace lsos
