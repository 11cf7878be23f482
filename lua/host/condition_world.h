// What the questions of a condition can be asked about.
#pragma once

#include <optional>
#include <set>
#include <string>

namespace lsos {

struct ConditionWorld {
  std::string own_id;               // of the event's rover
  std::set<std::string> ids;        // of rovers and assets
  std::set<std::string> resources;  // that the event's rover carries
  // False: there may be others, as faults of the plan keep them from being read.
  bool are_ids_known = true, are_resources_known = true;
  // What the event's rover can do, where it is known.
  std::optional<double> battery_capacity_j = {}, speed_max_mps = {};
  bool is_without_panels = false, is_without_battery = false;
  // Where the plan's things are, as far as they are known; lon_deg is absent around 180 degrees.
  struct Span {
    double low, high;
  };
  std::optional<Span> lon_deg = {}, lat_deg = {};
  std::optional<double> max_duration_s = {};  // that the plan says
};

}  // namespace lsos
