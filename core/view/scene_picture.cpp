#include "view/scene_picture.h"

#include <epoxy/gl.h>

#include <span>

#include "base/error.h"
#include "base/units.h"
#include "view/program.h"
#include "view/scene_shaders.h"

namespace lsos {

namespace {

// The picture is drawn so many times as wide and high, so that edges are smooth: on small triangles
// far quicker in software than several samples a pixel.
constexpr int finer = 2;
constexpr int map_px = 1024;
constexpr std::size_t bodies_max = 8;  // that throw shadows, as in the shader
constexpr double nearest_m = 0.2, farthest_m = 500e3;
constexpr double level_ground = 0.30;  // as bright as that is in the picture, before its tone
constexpr double exposure_max = 6;
constexpr double margin_share = 0.02;  // of the distance, between vertices of ground

using Matrix = Eigen::Matrix4f;

// Colour and depth to draw to; gone with the object.
struct Canvas {
  GLuint framebuffer = 0;
  std::array<GLuint, 2> layers{};

  Canvas(const Camera& camera, int times) {
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(2, layers.data());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const std::array<std::pair<GLenum, GLenum>, 2> uses{
        {{GL_RGBA8, GL_COLOR_ATTACHMENT0}, {GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT}}};
    for (std::size_t k = 0; k < layers.size(); ++k) {
      glBindRenderbuffer(GL_RENDERBUFFER, layers[k]);
      glRenderbufferStorage(GL_RENDERBUFFER, uses[k].first, times * camera.width_px,
                            times * camera.height_px);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, uses[k].second, GL_RENDERBUFFER, layers[k]);
    }
    LSOS_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  }
  ~Canvas() {
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(2, layers.data());
  }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
};

// A mesh on the GPU.
class Drawable {
 public:
  explicit Drawable(const SceneMesh& mesh)
      : count_(static_cast<GLsizei>(3 * mesh.triangles.size())) {
    glGenVertexArrays(1, &arrays_);
    glBindVertexArray(arrays_);
    glGenBuffers(2, buffers_.data());
    fill(GL_ARRAY_BUFFER, buffers_[0], std::as_bytes(std::span(mesh.vertices)));
    fill(GL_ELEMENT_ARRAY_BUFFER, buffers_[1], std::as_bytes(std::span(mesh.triangles)));
    const std::array<std::pair<GLint, std::size_t>, 4> parts{
        {{3, offsetof(SceneVertex, p_m)},
         {3, offsetof(SceneVertex, normal)},
         {3, offsetof(SceneVertex, colour)},
         {1, offsetof(SceneVertex, sun_share)}}};
    for (GLuint k = 0; k < parts.size(); ++k) {
      glEnableVertexAttribArray(k);
      glVertexAttribPointer(k, parts[k].first, GL_FLOAT, GL_FALSE, sizeof(SceneVertex),
                            reinterpret_cast<const void*>(parts[k].second));
    }
  }
  ~Drawable() {
    glDeleteBuffers(2, buffers_.data());
    glDeleteVertexArrays(1, &arrays_);
  }
  Drawable(const Drawable&) = delete;
  Drawable& operator=(const Drawable&) = delete;

  void draw() const {
    glBindVertexArray(arrays_);
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
  }
  // Other triangles of its vertices.
  void draw(const std::vector<std::array<std::uint32_t, 3>>& triangles) const {
    glBindVertexArray(arrays_);
    fill(GL_ELEMENT_ARRAY_BUFFER, buffers_[1], std::as_bytes(std::span(triangles)));
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * triangles.size()), GL_UNSIGNED_INT,
                   nullptr);
  }

 private:
  static void fill(GLenum kind, GLuint buffer, std::span<const std::byte> bytes) {
    glBindBuffer(kind, buffer);
    glBufferData(kind, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  }

  GLuint arrays_ = 0;
  std::array<GLuint, 2> buffers_{};
  GLsizei count_;
};

void set(const Program& program, const char* name, const Vec3& v) {
  const Eigen::Vector3f f = v.cast<float>();
  glUniform3fv(program.uniform(name), 1, f.data());
}
void set(const Program& program, const char* name, double x) {
  glUniform1f(program.uniform(name), static_cast<float>(x));
}

// The Sun's depth pictures of bodies, one a layer.
class DepthMaps {
 public:
  DepthMaps(const Scene& scene, std::span<const Drawable* const> bodies)
      : count_(std::min(bodies.size(), bodies_max)) {
    glGenTextures(1, &texture_);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture_);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, map_px, map_px,
                 static_cast<GLsizei>(std::max<std::size_t>(1, count_)), 0, GL_DEPTH_COMPONENT,
                 GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
    const std::array<float, 4> far{1, 1, 1, 1};
    glTexParameterfv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BORDER_COLOR, far.data());
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glViewport(0, 0, map_px, map_px);
    const Program program(scene_shaders::depth_vertex, scene_shaders::depth_fragment);
    glUseProgram(program.id());
    for (std::size_t k = 0; k < count_; ++k) {
      glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture_, 0,
                                static_cast<GLint>(k));
      glClear(GL_DEPTH_BUFFER_BIT);
      matrices_.push_back(to_map(scene.bodies[k], scene.sun_S));
      reaches_m_.push_back(static_cast<float>(1.05 * scene.bodies[k].reach_m));
      glUniformMatrix4fv(program.uniform("to_map"), 1, GL_FALSE, matrices_.back().data());
      bodies[k]->draw();
    }
    glDeleteFramebuffers(1, &framebuffer);
  }
  ~DepthMaps() { glDeleteTextures(1, &texture_); }
  DepthMaps(const DepthMaps&) = delete;
  DepthMaps& operator=(const DepthMaps&) = delete;

  void bind(const Program& program) const {
    const auto count = static_cast<GLsizei>(count_);
    glUniform1i(program.uniform("bodies"), count);
    glUniform1i(program.uniform("depths"), 0);
    if (count == 0) return;
    glUniformMatrix4fv(program.uniform("to_map"), count, GL_FALSE, matrices_.front().data());
    glUniform1fv(program.uniform("reach_m"), count, reaches_m_.data());
  }

 private:
  // Its cube, -1..1 in all axes; depths grow away from the Sun.
  static Matrix to_map(const SceneBody& body, const Vec3& sun_S) {
    const Vec3 aside = std::abs(sun_S.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
    Mat3 R;
    R.row(0) = aside.cross(sun_S).normalized();
    R.row(1) = sun_S.cross(R.row(0).transpose());
    R.row(2) = -sun_S;
    const double scale = 1 / (1.05 * body.reach_m);
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.topLeftCorner<3, 3>() = scale * R;
    m.topRightCorner<3, 1>() = -scale * (R * body.centre_m);
    return m.cast<float>();
  }

  std::size_t count_;
  GLuint texture_ = 0;
  std::vector<Matrix> matrices_;
  std::vector<float> reaches_m_;
};

Matrix to_picture(const Camera& camera) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m.row(0).head<3>() = camera.right_S() * (2 * camera.focal_px / camera.width_px);
  m.row(1).head<3>() = camera.up_S * (2 * camera.focal_px / camera.height_px);
  m.row(2).head<3>() = camera.ahead_S * ((farthest_m + nearest_m) / (farthest_m - nearest_m));
  m(2, 3) = -2 * farthest_m * nearest_m / (farthest_m - nearest_m);
  m.row(3).head<3>() = camera.ahead_S;
  return m.cast<float>();
}

// So that level ground in the Sun, seen somewhat from above, is as bright as level_ground says.
double exposure(const Scene& scene) {
  constexpr double seen = 0.3;
  const double facing = std::max(1e-3, scene.sun_S.dot(scene.up_S));
  const double moon = facing / (facing + seen) + 0.5 * facing;
  const double law = scene.air.moonlike * moon + (1 - scene.air.moonlike) * facing;
  return std::clamp(level_ground / (law * scene.air.ground.mean()), 0.5, exposure_max);
}

void draw_sky(const Scene& scene, const Camera& camera) {
  const Program program(scene_shaders::sky_vertex, scene_shaders::sky_fragment);
  glUseProgram(program.id());
  set(program, "ahead", camera.ahead_S * camera.focal_px);
  set(program, "right", camera.right_S() * (camera.width_px / 2.0));
  set(program, "above", camera.up_S * (camera.height_px / 2.0));
  set(program, "sun", scene.sun_S);
  set(program, "up", scene.up_S);
  set(program, "horizon", scene.air.horizon);
  set(program, "zenith", scene.air.zenith);
  set(program, "disc_rad", scene.disc_rad);
  GLuint arrays = 0;
  glGenVertexArrays(1, &arrays);
  glBindVertexArray(arrays);
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthMask(GL_TRUE);
  glDeleteVertexArrays(1, &arrays);
}

RgbPicture read(const Camera& camera) {
  RgbPicture picture{camera.width_px, camera.height_px, {}};
  const auto row = static_cast<std::size_t>(3 * camera.width_px);
  std::vector<std::uint8_t> from_below(row * static_cast<std::size_t>(camera.height_px));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, camera.width_px, camera.height_px, GL_RGB, GL_UNSIGNED_BYTE,
               from_below.data());
  for (auto at = from_below.end(); at != from_below.begin();) {
    at -= static_cast<std::ptrdiff_t>(row);
    picture.rgb.insert(picture.rgb.end(), at, at + static_cast<std::ptrdiff_t>(row));
  }
  return picture;
}

std::string toned(const char* shader) {
  return std::string("#version 330 core\n") + scene_shaders::tone + shader;
}

void set_all(const Program& program, const Scene& scene, const Camera& camera) {
  glUseProgram(program.id());
  const Matrix matrix = to_picture(camera);
  glUniformMatrix4fv(program.uniform("to_picture"), 1, GL_FALSE, matrix.data());
  set(program, "sun", scene.sun_S);
  set(program, "up", scene.up_S);
  set(program, "horizon", scene.air.horizon);
  set(program, "anchor_m", camera.eye_S_m.unaryExpr([](double x) { return std::fmod(x, 1000.0); }));
  set(program, "exposure", exposure(scene));
  set(program, "sky_light", scene.air.sky_light);
  set(program, "moonlike", scene.air.moonlike);
  set(program, "pixel_share", 1 / camera.focal_px);
  set(program, "sight_m", scene.air.sight_m);
  set(program, "disc_rad", scene.disc_rad);
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Those that a body may shade, and the others: most of the ground, which costs far less so.
std::pair<Triangles, Triangles> split(const SceneMesh& ground, const Scene& scene) {
  constexpr double margin = 1.1;
  std::vector<std::uint8_t> is_near(ground.vertices.size(), 0);
  const std::size_t bodies = std::min(scene.bodies.size(), bodies_max);
  for (std::size_t k = 0; k < ground.vertices.size(); ++k) {
    const auto& p = ground.vertices[k].p_m;
    const Vec3 p_m(p[0], p[1], p[2]);
    const double step_m = margin_share * p_m.norm();
    for (std::size_t b = 0; b < bodies; ++b) {
      const SceneBody& body = scene.bodies[b];
      const Vec3 to_m = p_m - body.centre_m;
      const double behind_m = -to_m.dot(scene.sun_S);
      const double aside_m = (to_m + behind_m * scene.sun_S).norm();
      const double reach_m = margin * body.reach_m + step_m;
      if (behind_m > -reach_m && aside_m < reach_m + scene.disc_rad * std::max(0.0, behind_m)) {
        is_near[k] = 1;
      }
    }
  }
  std::pair<Triangles, Triangles> parts;
  for (const auto& t : ground.triangles) {
    const bool is_any = (is_near[t[0]] | is_near[t[1]] | is_near[t[2]]) != 0;
    (is_any ? parts.first : parts.second).push_back(t);
  }
  return parts;
}

SceneAir by_day(std::string_view body) {
  if (body == "Moon") {
    return {Vec3(0.40, 0.39, 0.37), Vec3::Zero(), Vec3::Zero(), 0, 0.012, 1};
  }
  if (body == "Mars") {
    return {Vec3(0.55, 0.30, 0.17), Vec3(0.84, 0.69, 0.53), Vec3(0.62, 0.48, 0.36), 30e3, 0.2, 0.3};
  }
  return {Vec3(0.46, 0.38, 0.27), Vec3(0.78, 0.86, 0.93), Vec3(0.28, 0.49, 0.77), 60e3, 0.18, 0};
}

}  // namespace

SceneAir air_of(std::string_view body, double sun_elevation_rad) {
  SceneAir air = by_day(body);
  // Dusk, to the light that one still sees by.
  const double day = std::clamp(0.75 + sun_elevation_rad / radians(16), 0.12, 1.0);
  air.horizon *= day;
  air.zenith *= day;
  air.sky_light *= air.sight_m > 0 ? day : 1;
  return air;
}

RgbPicture draw(const Gpu&, const Scene& scene, const Camera& camera) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDisable(GL_CULL_FACE);
  for (GLenum k = 0; k < 5; ++k) glDisable(GL_CLIP_DISTANCE0 + k);
  const Drawable ground(scene.ground), marks(scene.marks);
  std::vector<std::unique_ptr<Drawable>> owned;
  std::vector<const Drawable*> bodies;
  for (const SceneBody& body : scene.bodies) {
    owned.push_back(std::make_unique<Drawable>(body.mesh));
    bodies.push_back(owned.back().get());
  }
  const DepthMaps maps(scene, bodies);
  const Canvas canvas(camera, finer), flat(camera, 1);
  glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
  glViewport(0, 0, finer * camera.width_px, finer * camera.height_px);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_sky(scene, camera);
  const auto [shaded, plain] = split(scene.ground, scene);
  const std::string vertex = toned(scene_shaders::surface_vertex);
  const Program with_shadows(vertex.c_str(), toned(scene_shaders::shaded_fragment).c_str());
  set_all(with_shadows, scene, camera);
  maps.bind(with_shadows);
  glUniform1i(with_shadows.uniform("kind"), 1);
  for (const Drawable* body : bodies) body->draw();  // first: what they hide costs less
  glUniform1i(with_shadows.uniform("kind"), 0);
  ground.draw(shaded);
  const Program without(vertex.c_str(), scene_shaders::plain_fragment);
  set_all(without, scene, camera);
  glUniform1i(without.uniform("kind"), 0);
  ground.draw(plain);
  glUniform1i(without.uniform("kind"), 2);
  marks.draw();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, canvas.framebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, flat.framebuffer);
  // Each pixel is the mean of its two by two.
  glBlitFramebuffer(0, 0, finer * camera.width_px, finer * camera.height_px, 0, 0, camera.width_px,
                    camera.height_px, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, flat.framebuffer);
  return read(camera);
}

}  // namespace lsos
