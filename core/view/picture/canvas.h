// An off-screen framebuffer with a colour and a depth buffer.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <utility>

#include "base/error.h"

namespace lsos {

// The constructor binds the framebuffer, the destructor deletes it.
struct Canvas {
  GLuint framebuffer = 0;
  std::array<GLuint, 2> renderbuffers{};

  Canvas(int width_px, int height_px) {
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(2, renderbuffers.data());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const std::array<std::pair<GLenum, GLenum>, 2> uses{
        {{GL_RGBA8, GL_COLOR_ATTACHMENT0}, {GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT}}};
    for (std::size_t k = 0; k < renderbuffers.size(); ++k) {
      glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers[k]);
      glRenderbufferStorage(GL_RENDERBUFFER, uses[k].first, width_px, height_px);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, uses[k].second, GL_RENDERBUFFER, renderbuffers[k]);
    }
    LSOS_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  }
  ~Canvas() {
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(2, renderbuffers.data());
  }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
};

// Disables all clip planes. Another user of the context may have left some enabled, and a shader
// that does not write clip distances would then clip at random.
inline void disable_clip_planes() {
  GLint most = 0;
  glGetIntegerv(GL_MAX_CLIP_DISTANCES, &most);
  for (GLint k = 0; k < most; ++k) glDisable(GL_CLIP_DISTANCE0 + static_cast<GLenum>(k));
}

}  // namespace lsos
