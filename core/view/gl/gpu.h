// Off-screen rendering: an EGL context on a GPU if there is one, otherwise on Mesa's software
// renderer.
#pragma once

#include <memory>
#include <string>

namespace lsos {

enum class GpuChoice { any, software };

// A Gpu is constructed, used and destroyed on one thread, where its context is current throughout.
// Objects of the same choice that are alive on one thread share one context, so that several
// simulations may draw alternately.
class Gpu {
 public:
  // The environment variable `LSOS_GPU=software` also selects the software renderer. Throws
  // InputError when there is no EGL or no device supports OpenGL 3.3; the message says what to
  // install.
  explicit Gpu(GpuChoice choice = GpuChoice::any);
  ~Gpu();
  Gpu(const Gpu&) = delete;
  Gpu& operator=(const Gpu&) = delete;

  // Name of the renderer, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)", for logs.
  const std::string& name() const;

 private:
  struct Context;
  std::shared_ptr<const Context> context_;
};

}  // namespace lsos
