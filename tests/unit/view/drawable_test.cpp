// A mesh on the GPU keeps its own triangles when others of its vertices are drawn.
#include "view/picture/drawable.h"

#include <gtest/gtest.h>

#include "view/gl/gpu.h"
#include "view/gl/program.h"
#include "view/picture/canvas.h"
#include "view/picture/scene_shaders.h"

namespace lsos {
namespace {

constexpr int side_px = 16;

template <class Draw>
GLuint pixels_drawn(const Draw& draw) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  GLuint query = 0, pixels = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  draw();
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &pixels);
  glDeleteQueries(1, &query);
  return pixels;
}

TEST(Drawable, draws_its_own_triangles_after_others_of_its_vertices) {
  const Gpu gpu;
  const Canvas canvas(side_px, side_px);
  glViewport(0, 0, side_px, side_px);
  glDisable(GL_CULL_FACE);
  disable_clip_planes();
  const Program program(scene_shaders::depth_vertex, scene_shaders::depth_fragment);
  glUseProgram(program.id());
  const Eigen::Matrix4f to_map = Eigen::Matrix4f::Identity();
  glUniformMatrix4fv(program.uniform("to_map"), 1, GL_FALSE, to_map.data());
  // Two triangles that fill the picture.
  SceneMesh square;
  for (const float y : {-1.0f, 1.0f}) {
    for (const float x : {-1.0f, 1.0f}) square.vertices.push_back({{x, y, 0}, {}, {}, 1});
  }
  square.triangles = {{0, 1, 2}, {1, 3, 2}};
  const Drawable drawable(square);
  constexpr GLuint all = side_px * side_px;
  EXPECT_EQ(pixels_drawn([&] { drawable.draw(); }), all);
  const GLuint first = pixels_drawn([&] { drawable.draw({{0, 1, 2}}); });
  EXPECT_GT(first, 0u);
  EXPECT_LT(first, all);
  EXPECT_EQ(pixels_drawn([&] { drawable.draw(); }), all);
}

}  // namespace
}  // namespace lsos
