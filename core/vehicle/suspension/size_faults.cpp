#include "vehicle/suspension/size_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

// What bounds a suspension: how many links it makes, and its farthest point from the reference
// point, in any of the three directions.
struct Extent {
  std::size_t links = 0;
  double reach_m = 0;

  template <class Point>
  void reach(const Point& p_B_m) {
    reach_m = std::max(reach_m, p_B_m.cwiseAbs().maxCoeff());
  }
};

Extent extent_of(const Wishbone& wishbone) {
  Extent extent;
  extent.links = wishbone.modules.size() * (2 + wishbone.wheel_offsets_m.size());
  double offset_max_m = 0;
  for (const double offset_m : wishbone.wheel_offsets_m) {
    offset_max_m = std::max(offset_max_m, std::abs(offset_m));
  }
  for (const WishboneModule& module : wishbone.modules) extent.reach(module.p_B_m);
  extent.reach_m += offset_max_m;
  return extent;
}

// Links of a station on both sides: two wheels and their knuckles.
Extent extent_of(const std::vector<WheelStation>& stations, std::size_t other_links) {
  Extent extent{other_links + 4 * stations.size(), 0};
  for (const WheelStation& station : stations) extent.reach(station.p_B_m);
  return extent;
}

Extent extent_of(const RockerBogie& suspension) {
  Extent extent = extent_of(suspension.stations, 4);
  extent.reach(suspension.rocker.p_B_pivot_m);
  if (suspension.bogie) extent.reach(suspension.bogie->p_B_pivot_m);
  return extent;
}

Extent extent_of(const SkidSteer& suspension) {
  Extent extent = extent_of(suspension.stations, 2);
  if (suspension.rocker) extent.reach(suspension.rocker->p_B_pivot_m);
  return extent;
}

Extent extent_of(const Legged& suspension) {
  Extent extent;
  for (const Limb& limb : suspension.limbs) {
    extent.links += limb.joints.size() + 2;
    extent.reach(limb.p_B_wheel_m);
    for (const LimbJoint& joint : limb.joints) extent.reach(joint.p_B_m);
  }
  return extent;
}

}  // namespace

std::vector<std::string> size_faults(const RoverSpec& spec) {
  std::vector<std::string> faults;
  const VehicleConfig& vehicle = spec.vehicle;
  if (vehicle.chassis_size_m.maxCoeff() > reach_max_m ||
      vehicle.chassis_clearance_m > reach_max_m) {
    faults.push_back(fmt::format(
        "the chassis is {:g} m long, {:g} m wide, {:g} m high and {:g} m over the ground; {:g} m "
        "each is the most",
        vehicle.chassis_size_m.x(), vehicle.chassis_size_m.y(), vehicle.chassis_size_m.z(),
        vehicle.chassis_clearance_m, reach_max_m));
  }
  const Extent extent =
      std::visit([](const auto& suspension) { return extent_of(suspension); }, spec.suspension);
  if (extent.links > links_max) {
    faults.push_back(fmt::format("its suspension has {} arms, knuckles and wheels; {} is the most",
                                 extent.links, links_max));
  }
  if (extent.reach_m > reach_max_m) {
    faults.push_back(
        fmt::format("its wheels and joints lie up to {:g} m from its middle; {:g} m is the most",
                    extent.reach_m, reach_max_m));
  }
  if (spec.configurations.size() > configurations_max) {
    faults.push_back(fmt::format("it has {} configurations; {} is the most",
                                 spec.configurations.size(), configurations_max));
  }
  return faults;
}

}  // namespace lsos
