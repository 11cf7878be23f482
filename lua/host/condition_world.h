// What is known, when a plan is checked, of the things its conditions can name.
#pragma once

#include <optional>
#include <set>
#include <string>

namespace lsos {

struct ConditionWorld {
  std::string own_id;               // the event's rover
  std::set<std::string> ids;        // of rovers and assets
  std::set<std::string> resources;  // that the event's rover carries
  // False where there may be others, because faults of the plan keep them from being read.
  bool are_ids_known = true, are_resources_known = true;
  // Capabilities of the event's rover, where they are known.
  std::optional<double> battery_capacity_j = {}, speed_max_mps = {};
  bool is_without_panels = false, is_without_battery = false;
  // Extent of the plan's places, as far as they are known; lon_deg is absent around 180 degrees.
  struct Span {
    double low, high;
  };
  std::optional<Span> lon_deg = {}, lat_deg = {};
  std::optional<double> max_duration_s = {};  // given by the plan
};

}  // namespace lsos
