#include "vehicle/footprint.h"

#include "vehicle/drive_control.h"
#include "vehicle/limb_stance.h"

namespace lsos {

Footprint footprint_at_rest(const VehicleConfig& config) {
  const VehicleConfig vehicle = as_it_stands(config);
  Vec2 low_m = -vehicle.chassis_size_m.head<2>() / 2, high_m = -low_m;
  for (const WheelLayout::WheelPlace& place : wheel_layout(vehicle).wheels) {
    const Wheel& wheel = *vehicle.links[static_cast<std::size_t>(place.link)].wheel;
    const Vec2 half_m(wheel.radius_m, wheel.width_m / 2);
    low_m = low_m.cwiseMin(place.p_B_m - half_m);
    high_m = high_m.cwiseMax(place.p_B_m + half_m);
  }
  return {(low_m + high_m) / 2, Vec2::UnitX(), (high_m - low_m) / 2};
}

}  // namespace lsos
