#include "view/picture/scene_picture.h"

#include <epoxy/gl.h>

#include "base/error.h"
#include "base/units.h"
#include "view/gl/program.h"
#include "view/picture/canvas.h"
#include "view/picture/depth_maps.h"
#include "view/picture/drawable.h"
#include "view/picture/scene_shaders.h"

namespace lsos {

namespace {

// Supersampling factor in width and height, for smooth edges. On small triangles this is far
// quicker in software than several samples per pixel.
constexpr int supersampling = 2;
constexpr double picture_nearest_m = 0.2, picture_farthest_m = 500e3;
constexpr double level_ground_brightness =
    0.30;  // its brightness in the picture before tone mapping
constexpr double exposure_max = 6;
constexpr double margin_share = 0.02;  // of the distance: allows for the spacing of ground vertices

using Matrix = Eigen::Matrix4f;

void set(const Program& program, const char* name, const Vec3& v) {
  const Eigen::Vector3f f = v.cast<float>();
  glUniform3fv(program.uniform(name), 1, f.data());
}
void set(const Program& program, const char* name, double x) {
  glUniform1f(program.uniform(name), static_cast<float>(x));
}

Matrix camera_to_picture(const Camera& camera) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m.row(0).head<3>() = camera.right_S() * (2 * camera.focal_px / camera.width_px);
  m.row(1).head<3>() = camera.up_S * (2 * camera.focal_px / camera.height_px);
  m.row(2).head<3>() = camera.ahead_S * ((picture_farthest_m + picture_nearest_m) /
                                         (picture_farthest_m - picture_nearest_m));
  m(2, 3) = -2 * picture_farthest_m * picture_nearest_m / (picture_farthest_m - picture_nearest_m);
  m.row(3).head<3>() = camera.ahead_S;
  return m.cast<float>();
}

// Exposure at which sunlit level ground, seen somewhat from above, is as bright as
// `level_ground_brightness`.
double exposure(const Scene& scene) {
  constexpr double seen = 0.3;
  const double facing = std::max(1e-3, scene.sun_S.dot(scene.up_S));
  const double moon = facing / (facing + seen) + 0.5 * facing;
  const double law = scene.air.moonlike * moon + (1 - scene.air.moonlike) * facing;
  return std::clamp(level_ground_brightness / (law * scene.air.ground.mean()), 0.5, exposure_max);
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
  const Matrix matrix = camera_to_picture(camera);
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

// Splits the ground into triangles that a body may shade and the rest. Most of the ground is in the
// rest, which is far cheaper to draw.
std::pair<Triangles, Triangles> split(const Scene& scene, const DepthMaps& maps) {
  const SceneMesh& ground = scene.ground;
  std::vector<std::uint8_t> is_near(ground.vertices.size(), 0);
  for (std::size_t k = 0; k < ground.vertices.size(); ++k) {
    const SceneVertex& vertex = ground.vertices[k];
    const Vec3 p_m(vertex.p_m[0], vertex.p_m[1], vertex.p_m[2]);
    if (vertex.sun_share <= 0) continue;  // in the dark already
    is_near[k] = maps.may_shade(p_m, margin_share * p_m.norm(), scene.disc_rad) ? 1 : 0;
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
  // Dusk dims the sky, down to light that one can still see by.
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
  disable_clip_planes();
  const Drawable ground(scene.ground), marks(scene.marks);
  std::vector<std::unique_ptr<Drawable>> owned;
  std::vector<const Drawable*> bodies;
  for (const SceneBody& body : scene.bodies) {
    owned.push_back(std::make_unique<Drawable>(body.mesh));
    bodies.push_back(owned.back().get());
  }
  const DepthMaps maps(scene, bodies);
  const Canvas canvas(supersampling * camera.width_px, supersampling * camera.height_px),
      flat(camera.width_px, camera.height_px);
  glBindFramebuffer(GL_FRAMEBUFFER, canvas.framebuffer);
  glViewport(0, 0, supersampling * camera.width_px, supersampling * camera.height_px);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_sky(scene, camera);
  const auto [shaded, plain] = split(scene, maps);
  const std::string vertex = toned(scene_shaders::surface_vertex);
  const Program with_shadows(vertex.c_str(), toned(scene_shaders::shaded_fragment).c_str());
  set_all(with_shadows, scene, camera);
  maps.bind(with_shadows);
  glUniform1i(with_shadows.uniform("kind"), 1);
  for (const Drawable* body : bodies) body->draw();  // first, as ground that they hide costs less
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
  // Each pixel becomes the mean of 2 x 2.
  glBlitFramebuffer(0, 0, supersampling * camera.width_px, supersampling * camera.height_px, 0, 0,
                    camera.width_px, camera.height_px, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, flat.framebuffer);
  return read(camera);
}

}  // namespace lsos
