// The Sun's depth pictures of rovers and assets, for the shadows they throw in a camera's picture.
#pragma once

#include <span>
#include <vector>

#include "view/gl/program.h"
#include "view/picture/drawable.h"
#include "view/picture/scene.h"

namespace lsos {

class DepthMaps {
 public:
  static constexpr std::size_t bodies_max = 8;  // that throw shadows, as in the shader

  // Draws the first few of the scene's bodies, each to a layer of its own.
  DepthMaps(const Scene& scene, std::span<const Drawable* const> bodies);
  ~DepthMaps() { glDeleteTextures(1, &texture_); }
  DepthMaps(const DepthMaps&) = delete;
  DepthMaps& operator=(const DepthMaps&) = delete;

  void bind(const Program& program) const;
  // Anything so near to a point; false only where it is sure that nothing does.
  bool may_shade(const Vec3& p_m, double near_m, double disc_rad) const;

 private:
  std::size_t count_;
  GLuint texture_ = 0;
  std::vector<Eigen::Matrix4f> matrices_;
  std::vector<float> reaches_m_;
  std::vector<std::vector<int>> blocks_;  // that hold anything: sums from the lower left corner
};

}  // namespace lsos
