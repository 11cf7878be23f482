// What a picture of a run shows, from its plan's scripts and its log: rovers, assets, tracks.
#pragma once

#include <string>
#include <vector>

#include "mission/model/mission_model.h"
#include "picture/logged_run.h"
#include "terrain/ground.h"
#include "view/picture/scene_picture.h"
#include "view/picture/sun_picture.h"

namespace lsos {

// A rover or an asset, where it was.
struct DrawnBody {
  std::string id, type;
  Vec3 p_S_m = Vec3::Zero();         // its reference point
  std::vector<PictureSolid> solids;  // about the eye, without panels
  std::vector<PanelFace> panels;     // about the eye
  double reach_m = 1;                // all but masts lies so near to the reference point
  double bound_m = 1;                // and masts so near
  double top_m = 1;                  // over it, along the vertical
};

// Rovers, then assets. `eye_S_m`: the point that they are drawn about.
std::vector<DrawnBody> drawn_bodies(const MissionModel& files, const Ground& ground,
                                    const LoggedMoment& rovers, const Vec3& eye_S_m,
                                    const Vec3& sun_S);

// As a camera sees it.
SceneBody scene_body(const DrawnBody& body, const Vec3& eye_S_m, const TerrainShadow& shadow);

// Where a rover has been until then, to where it is, as a ribbon on the ground, from the camera's
// eye.
struct RibbonStyle {
  Vec3 colour = Vec3::Ones();
  double half_m = 0.1;  // its half width; wider where that were less than a pixel
};
SceneMesh track_ribbon(const Ground& ground, std::vector<TrackPoint> track, const TrackPoint& now,
                       const Camera& camera, const RibbonStyle& style);
// Of a rover, by its place in the order of ids; as on maps.
Vec3 rover_colour(std::size_t place);

}  // namespace lsos
