// A pair of shaders, compiled and linked.
#pragma once

#include <epoxy/gl.h>

#include "base/error.h"

namespace lsos {

class Program {
 public:
  Program(const char* vertex_shader, const char* fragment_shader) : id_(glCreateProgram()) {
    for (const auto& [kind, text] : {std::pair{GLenum{GL_VERTEX_SHADER}, vertex_shader},
                                     {GLenum{GL_FRAGMENT_SHADER}, fragment_shader}}) {
      const GLuint part = glCreateShader(kind);
      glShaderSource(part, 1, &text, nullptr);
      glCompileShader(part);
      GLint is_good = 0;
      glGetShaderiv(part, GL_COMPILE_STATUS, &is_good);
      LSOS_ASSERT(is_good != 0);
      glAttachShader(id_, part);
      glDeleteShader(part);
    }
    glLinkProgram(id_);
    GLint is_good = 0;
    glGetProgramiv(id_, GL_LINK_STATUS, &is_good);
    LSOS_ASSERT(is_good != 0);
  }
  ~Program() { glDeleteProgram(id_); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  GLuint id() const { return id_; }
  GLint uniform(const char* name) const { return glGetUniformLocation(id_, name); }

 private:
  GLuint id_;
};

}  // namespace lsos
