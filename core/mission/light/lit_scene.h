// Panels that are lit, and what stands around them.
#pragma once

#include <vector>

#include "view/exposure/panel_view.h"

namespace lsos {

// Lit faces and the solids around them; vectors relative to `eye_S_m`, site axes.
struct LitScene {
  Vec3 eye_S_m = Vec3::Zero();   // near all of the faces
  std::vector<PanelFace> faces;  // each may shade the others
  Mesh near;                     // solids that may shade them
};

}  // namespace lsos
