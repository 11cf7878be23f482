// The renderer for light and lines of sight.
#pragma once

#include "view/exposure/panel_view.h"
#include "view/gl/gpu.h"

namespace lsos {

// Constructed, used and destroyed on one thread.
struct Renderer {
  explicit Renderer(GpuChoice choice = GpuChoice::any) : gpu(choice), panels(gpu) {}

  Gpu gpu;
  PanelView panels;
};

}  // namespace lsos
