#include "view/picture/depth_maps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "view/picture/scene_shaders.h"

namespace lsos {

namespace {

constexpr int map_px = 1024;
constexpr int blocks = 64;  // along each side of a map
static_assert(map_px % blocks == 0);

// Summed-area table of the map just drawn: for each corner of the blocks, the number of blocks
// below and left of it that hold anything.
std::vector<int> filled_blocks() {
  std::vector<float> depths(static_cast<std::size_t>(map_px * map_px));
  glReadPixels(0, 0, map_px, map_px, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  std::vector<int> sums(static_cast<std::size_t>((blocks + 1) * (blocks + 1)), 0);
  std::vector<int> filled(static_cast<std::size_t>(blocks * blocks), 0);
  constexpr int side = map_px / blocks;
  for (int k = 0; k < map_px * map_px; ++k) {
    if (depths[static_cast<std::size_t>(k)] >= 1) continue;
    filled[static_cast<std::size_t>(k / map_px / side * blocks + k % map_px / side)] = 1;
  }
  for (std::size_t y = 0; y < blocks; ++y) {
    for (std::size_t x = 0; x < blocks; ++x) {
      const std::size_t k = (y + 1) * (blocks + 1) + x + 1;
      sums[k] = filled[y * blocks + x] + sums[k - 1] + sums[k - blocks - 1] - sums[k - blocks - 2];
    }
  }
  return sums;
}

// Maps the cube around the body to -1..1 in all axes; depth grows away from the Sun.
Eigen::Matrix4f to_map(const SceneBody& body, const Vec3& sun_S) {
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

}  // namespace

DepthMaps::DepthMaps(const Scene& scene, std::span<const Drawable* const> bodies)
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
    blocks_.push_back(filled_blocks());
  }
  glDeleteFramebuffers(1, &framebuffer);
}

void DepthMaps::bind(const Program& program) const {
  const auto count = static_cast<GLsizei>(count_);
  glUniform1i(program.uniform("bodies"), count);
  glUniform1i(program.uniform("depths"), 0);
  if (count == 0) return;
  glUniformMatrix4fv(program.uniform("to_map"), count, GL_FALSE, matrices_.front().data());
  glUniform1fv(program.uniform("reach_m"), count, reaches_m_.data());
}

bool DepthMaps::may_shade(const Vec3& p_m, double near_m, double disc_rad) const {
  for (std::size_t k = 0; k < count_; ++k) {
    const Eigen::Vector3f at = (matrices_[k] * p_m.cast<float>().homogeneous()).head<3>();
    const double near = near_m / reaches_m_[k];
    if (at.z() < -1 - near) continue;
    const double reach = near + disc_rad * std::max(0.0f, at.z()) + 4.0 / map_px;
    const auto block = [](double x) {
      return static_cast<std::size_t>(std::clamp((x + 1) / 2 * blocks, 0.0, blocks - 1.0));
    };
    if (std::max(std::abs(at.x()), std::abs(at.y())) > 1 + reach) continue;
    const auto low_x = block(at.x() - reach), high_x = block(at.x() + reach) + 1;
    const auto low_y = block(at.y() - reach), high_y = block(at.y() + reach) + 1;
    const auto sum = [&](std::size_t x, std::size_t y) { return blocks_[k][y * (blocks + 1) + x]; };
    if (sum(high_x, high_y) - sum(low_x, high_y) - sum(high_x, low_y) + sum(low_x, low_y) > 0) {
      return true;
    }
  }
  return false;
}

}  // namespace lsos
