// What a panel sees instead of the Sun: how much of its view is sky, and how much is ground. Solids
// near by hide it, drawn as they are for the Sun; the ground ends the sky at its horizon.
#pragma once

#include <array>

#include "view/exposure/panel_view.h"
#include "view/exposure/terrain_horizon.h"

namespace lsos {

// Shares of the light that reaches a panel when all around it is equally bright; what is left is
// hidden by solids, which count as black.
struct DiffuseView {
  double sky = 0, ground = 0;
};

// Share of a panel that nothing hides, in each of 32 directions of its lit side. They are spread so
// that each stands for the same part of an even light, weighted by the cosine of incidence.
using OpenShares = std::array<double, 32>;
OpenShares open_shares(PanelView& view, const PanelFace& panel, const Mesh& solids);

// Local axes at the panel, in the frame that it is given in.
struct Compass {
  Vec3 north = Vec3::UnitY(), east = Vec3::UnitX(), up = Vec3::UnitZ();
};

// Divides the view between sky and ground in 1024 directions; each takes the open share of the
// nearest of those that were drawn.
DiffuseView diffuse_view(const OpenShares& open, const PanelFace& panel,
                         const TerrainHorizon& horizon, const Compass& compass);

}  // namespace lsos
