#include "vehicle/part_pose.h"

namespace lsos {

std::vector<Vec3> centres_at_rest_B_m(const VehicleConfig& config) {
  std::vector<Vec3> joints_B_m, centres_B_m{config.p_BC_m};
  for (const LinkConfig& link : config.links) {
    const Vec3 parent_B_m =
        link.parent < 0 ? Vec3::Zero() : joints_B_m[static_cast<std::size_t>(link.parent)];
    joints_B_m.push_back(parent_B_m + link.p_PJ_m);
    centres_B_m.push_back(joints_B_m.back() + link.p_JC_m);
  }
  return centres_B_m;
}

}  // namespace lsos
