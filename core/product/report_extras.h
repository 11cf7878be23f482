// Parts of report.html that do not come from the log: the ground, pictures, batteries.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record/rows.h"

namespace lsos {

// A picture in a format that browsers show.
struct EmbeddedPicture {
  std::string mime;  // image/jpeg
  std::string bytes;
};

// The ground under a mission, in the site's frame.
struct ReportMap {
  double left_m = 0, bottom_m = 0, right_m = 0, top_m = 0;
  EmbeddedPicture relief;
  double lowest_m = 0, highest_m = 0;
  double missing_share = 0;  // share of the map where no ground is known
  // Dark where the ground does not see the Sun at the time `shadow_s`.
  std::optional<EmbeddedPicture> shadow;
  double shadow_s = 0;
  double sunlit_share = not_modelled;  // share of the map
  // Distances towards the Sun from the map's centre: to the end of the ground, and up to which
  // ground may hide the Sun; NaN where the ground does not end before.
  double ground_reaches_m = not_modelled, ground_matters_m = not_modelled;
};

struct ReportPicture {
  std::string rover_id;
  double time_s = 0;
  std::string title;  // "Start", an event's label
  std::string view;   // "from behind"
  EmbeddedPicture picture;
};

struct ReportBattery {
  double capacity_j = 0, reserve_j = 0;
};

// Parts that need the ground and the scripts of the plan, which may be missing when a log is read.
struct ReportExtras {
  std::optional<ReportMap> map;
  std::vector<ReportPicture> pictures;
  std::map<std::string, ReportBattery> batteries;  // by rover id
  std::string estimate;                            // text of the run's estimate.json, "" for none
  std::vector<std::string> left_out;               // parts missing from the page, and why
};

}  // namespace lsos
