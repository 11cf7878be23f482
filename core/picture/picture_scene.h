// Contents of a picture of a run, from its plan's scripts and its log: rovers, assets, tracks.
#pragma once

#include <string>
#include <vector>

#include "mission/model/mission_model.h"
#include "picture/logged_run.h"
#include "terrain/ground.h"
#include "view/picture/scene_picture.h"
#include "view/picture/sun_picture.h"

namespace lsos {

// A rover or an asset at its logged place.
struct DrawnBody {
  std::string id, type;
  Vec3 p_S_m = Vec3::Zero();         // its reference point
  std::vector<PictureSolid> solids;  // relative to the eye, without panels
  std::vector<PanelFace> panels;     // relative to the eye
  double reach_m = 1;                // radius about the reference point that holds all but masts
  double bound_m = 1;                // radius that holds masts and moved limbs too
  double top_m = 1;                  // height above the reference point
};

// Rovers, then assets. `eye_S_m`: the point relative to which they are drawn.
std::vector<DrawnBody> drawn_bodies(const MissionModel& files, const Ground& ground,
                                    const LoggedMoment& rovers, const Vec3& eye_S_m,
                                    const Vec3& sun_S);

// The body as part of a scene for a camera.
SceneBody scene_body(const DrawnBody& body, const Vec3& eye_S_m, const TerrainShadow& shadow);

// Ribbon on the ground along a rover's track up to `now`, relative to the camera's eye.
struct RibbonStyle {
  Vec3 colour = Vec3::Ones();
  double half_m = 0.1;  // half width; wider where it would be less than a pixel
};
SceneMesh track_ribbon(const Ground& ground, std::vector<TrackPoint> track, const TrackPoint& now,
                       const Camera& camera, const RibbonStyle& style);
// Colour of a rover by its place in the order of ids, the same as on maps.
Vec3 rover_colour(std::size_t place);

}  // namespace lsos
