// Shadow maps: depth images of rovers and assets as seen from the Sun, for the shadows that they
// cast in a camera's picture.
#pragma once

#include <span>
#include <vector>

#include "view/gl/program.h"
#include "view/picture/drawable.h"
#include "view/picture/scene.h"

namespace lsos {

class DepthMaps {
 public:
  static constexpr std::size_t bodies_max = 8;  // that cast shadows; the same as in the shader

  // Renders the first `bodies_max` bodies of the scene, each to its own layer of the texture.
  DepthMaps(const Scene& scene, std::span<const Drawable* const> bodies);
  ~DepthMaps() { glDeleteTextures(1, &texture_); }
  DepthMaps(const DepthMaps&) = delete;
  DepthMaps& operator=(const DepthMaps&) = delete;

  void bind(const Program& program) const;
  // Whether a body may shade any point within `near_m` of p. Conservative: false only where none
  // does.
  bool may_shade(const Vec3& p_m, double near_m, double disc_rad) const;

 private:
  std::size_t count_;
  GLuint texture_ = 0;
  std::vector<Eigen::Matrix4f> matrices_;
  std::vector<float> reaches_m_;
  std::vector<std::vector<int>> blocks_;  // summed-area tables, by body
};

}  // namespace lsos
