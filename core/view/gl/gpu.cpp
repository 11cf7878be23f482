#include "view/gl/gpu.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace lsos {

namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw InputError({},
                   "cannot draw without a screen: " + why +
                       "; apt-get install libegl1 libgl1-mesa-dri gives a renderer in software");
}

template <class Function>
Function egl_function(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

// Displays to try: GPUs in the order in which their drivers list them, then Mesa without a device.
std::vector<EGLDisplay> displays(GpuChoice choice) {
  std::vector<EGLDisplay> found;
  const auto get = egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (get == nullptr) refuse("EGL is older than its platform extension");
  if (choice == GpuChoice::any) {
    const auto query = egl_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (query != nullptr) query(static_cast<EGLint>(devices.size()), devices.data(), &count);
    for (EGLint k = 0; k < count; ++k) {
      found.push_back(get(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(k)], nullptr));
    }
  }
  found.push_back(get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return found;
}

EGLContext context_on(EGLDisplay display) {
  // The default surface type, a window, matches no configuration.
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  eglBindAPI(EGL_OPENGL_API);
  eglChooseConfig(display, wanted, &config, 1, &count);
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                            3,
                            EGL_CONTEXT_MINOR_VERSION,
                            3,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                            EGL_NONE};
  return eglCreateContext(display, count > 0 ? config : nullptr, EGL_NO_CONTEXT, version);
}

GpuChoice chosen(GpuChoice choice) {
  const char* set = std::getenv("LSOS_GPU");
  return set != nullptr && std::string_view(set) == "software" ? GpuChoice::software : choice;
}

}  // namespace

struct Gpu::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  std::string name;

  explicit Context(GpuChoice choice);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

Gpu::Context::Context(GpuChoice choice) {
  if (!epoxy_has_egl()) refuse("there is no libEGL");
  for (const EGLDisplay on : displays(choice)) {
    if (on == EGL_NO_DISPLAY || !eglInitialize(on, nullptr, nullptr)) continue;
    const EGLContext created = context_on(on);
    if (created == EGL_NO_CONTEXT) continue;
    if (!eglMakeCurrent(on, EGL_NO_SURFACE, EGL_NO_SURFACE, created)) {
      eglDestroyContext(on, created);
      continue;
    }
    display = on;
    context = created;
    name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return;
  }
  refuse("no device draws with OpenGL 3.3");
}

Gpu::Context::~Context() {
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, context);
}

Gpu::Gpu(GpuChoice choice) {
  thread_local std::array<std::weak_ptr<const Context>, 2> living;
  choice = chosen(choice);
  std::weak_ptr<const Context>& shared = living[choice == GpuChoice::any ? 0 : 1];
  context_ = shared.lock();
  if (!context_) shared = context_ = std::make_shared<const Context>(choice);
}

Gpu::~Gpu() = default;

const std::string& Gpu::name() const { return context_->name; }

}  // namespace lsos
