// A place to draw without a screen: an EGL context, on a GPU where there is one, else on Mesa's
// software renderer.
#pragma once

#include <memory>
#include <string>

namespace lsos {

enum class GpuChoice { any, software };

// Made, used and destroyed by one thread, on which it is current all the while. Those of one thread
// that live at a time share one context, so that simulations side by side may draw in turn.
class Gpu {
 public:
  // `LSOS_GPU=software` in the environment chooses that too. Throws InputError: there is no EGL, or
  // none of its devices draws with OpenGL 3.3; says what to install.
  explicit Gpu(GpuChoice choice = GpuChoice::any);
  ~Gpu();
  Gpu(const Gpu&) = delete;
  Gpu& operator=(const Gpu&) = delete;

  // "llvmpipe (LLVM 15.0.6, 256 bits)", for logs.
  const std::string& name() const;

 private:
  struct Context;
  std::shared_ptr<const Context> context_;
};

}  // namespace lsos
