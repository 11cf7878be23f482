#include "lua/host/part_faults.h"

#include <fmt/format.h>

#include <algorithm>

namespace lsos {

std::vector<std::string> part_faults(const std::vector<Shape>& shapes, const PowerSpec& power,
                                     const std::vector<AntennaSpec>& antennas) {
  constexpr std::size_t shapes_max = 1000, others_max = 100;
  constexpr double far_m = 1000;
  std::vector<std::string> faults;
  double farthest_m = 0;
  const auto reach = [&](const Vec3& p_m) {
    farthest_m = std::max(farthest_m, p_m.cwiseAbs().maxCoeff());
  };
  const auto check = [&](const char* what, std::size_t count, std::size_t most) {
    if (count <= most) return;
    faults.push_back(fmt::format("it has {} {}; {} is the most", count, what, most));
  };
  check("shapes", shapes.size(), shapes_max);
  check("panels", power.panels.size(), others_max);
  check("loads", power.loads.size(), others_max);
  check("resources", power.resources.size(), others_max);
  check("antennas", antennas.size(), others_max);
  for (const Shape& shape : shapes) {
    reach(shape.p_B_m);
    reach(shape.size_m);
  }
  for (const PanelSpec& panel : power.panels) {
    reach(panel.p_B_m);
    reach({panel.length_m, panel.width_m, 0});
  }
  for (const AntennaSpec& antenna : antennas) {
    reach(antenna.p_B_m);
    if (antenna.stowed_p_B_m) reach(*antenna.stowed_p_B_m);
  }
  if (farthest_m > far_m) {
    faults.push_back(fmt::format(
        "a shape, panel or antenna lies {0:g} m away or is {0:g} m long; {1:g} m is the most",
        farthest_m, far_m));
  }
  return faults;
}

}  // namespace lsos
