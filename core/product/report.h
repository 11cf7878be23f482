// report.html: one page, without a network, that shows what a run came to: warnings, tables, a map,
// plots with one cursor of time, pictures.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "product/report_data.h"

namespace lsos {

// What a browser shows as a picture.
struct EmbeddedPicture {
  std::string mime;  // image/jpeg
  std::string bytes;
};

// The ground under a mission, in the site's frame.
struct ReportMap {
  double left_m = 0, bottom_m = 0, right_m = 0, top_m = 0;
  EmbeddedPicture relief;
  double lowest_m = 0, highest_m = 0;
  double missing_share = 0;  // of the map, where no ground is known
  // Dark where the ground does not see the Sun, then.
  std::optional<EmbeddedPicture> shadow;
  double shadow_s = 0;
  double sunlit_share = not_modelled;  // of the map
  // Towards the Sun from the map's middle: where the ground ends, and as far as it counts; NaN
  // where it does not end before.
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

// What needs the ground and the scripts of the plan, which may be gone when a log is read.
struct ReportExtras {
  std::optional<ReportMap> map;
  std::vector<ReportPicture> pictures;
  std::map<std::string, ReportBattery> batteries;  // by rover id
  std::vector<std::string> left_out;               // what is missing in the page, and why
};

// `summary`: the text of summary.json; "" when there is none: the run has not finished.
std::string report_html(const ReportData& data, const Plan& plan, const SiteFrame& site,
                        const std::string& summary, const ReportExtras& extras);
// The page's data, as it stands inside <script>: no '<' in it.
std::string report_json(const ReportData& data, const Plan& plan, const SiteFrame& site,
                        const std::string& summary, const ReportExtras& extras);

}  // namespace lsos
