#include "lua/app/horizon_answer.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/error.h"
#include "base/rounded_distance.h"
#include "base/rounding.h"
#include "base/units.h"
#include "view/ground/highest_ground.h"
#include "view/ground/horizon_march.h"
#include "view/ground/horizon_reach.h"

namespace lsos {

AnswerRow horizon_answer(const Ground& ground, const Geodetic& from, double step_deg) {
  constexpr double resolution_m = 0.5;  // a rock that hides more than a wheel or a foot
  HorizonMarch march(ground, resolution_m);
  const auto eye = march.eye(from, from.height_m);
  if (!eye) {
    throw InputError({}, fmt::format("--from {},{}: there is no ground; the terrain does not reach "
                                     "there, or its samples are missing",
                                     lon_deg(from), lat_deg(from)));
  }
  const SiteFrame& site = ground.site();
  const Vec3 north_S = site.north_S(eye->p_S_m), east_S = site.east_S(eye->p_S_m);
  const double dip_rad = horizon_dip_rad(site.body(), eye->height_m);
  const double straight_up_rad = radians(90);
  AnswerRow answer = AnswerRow::array();
  double nearest_m = std::numeric_limits<double>::infinity();
  std::size_t over_end = 0;
  for (int k = 0; k * step_deg < 360 - 1e-9; ++k) {
    const double azimuth_rad = radians(k * step_deg);
    const Vec3 along_S = std::cos(azimuth_rad) * north_S + std::sin(azimuth_rad) * east_S;
    const double far_m =
        ground.has_end() ? horizon_reach_m(site.body(), eye->height_m, -dip_rad) : 0;
    const HorizonPoint found = march.towards(*eye, along_S, -dip_rad, straight_up_rad, far_m);
    AnswerRow row{{"azimuth_deg", computed(k * step_deg)},
                  {"elevation_deg", computed(degrees(found.elevation_rad))},
                  {"distance_m", nullptr}};
    if (found.is_known) row["distance_m"] = computed(found.distance_m);
    const double matters_m = horizon_reach_m(site.body(), eye->height_m, found.elevation_rad);
    if (found.end_m && *found.end_m < matters_m) {
      row["ground_reaches_m"] = std::round(*found.end_m);
      nearest_m = std::min(nearest_m, *found.end_m);
      ++over_end;
    }
    answer.push_back(row);
  }
  if (over_end > 0) {
    const std::string warning = fmt::format(
        "the ground ends before the horizon that counts in {} of {} directions, {} away at the "
        "nearest; what stands there may be higher; --beyond lays a coarser terrain around it",
        over_end, answer.size(), rounded_distance(nearest_m));
    print_message("warning: {}\n", warning);
    for (AnswerRow& row : answer) {
      if (row.contains("ground_reaches_m")) row["warnings"] = {warning};
    }
  }
  return answer;
}

}  // namespace lsos
