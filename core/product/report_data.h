// The data of a report, read from a run's log in one pass over each layer.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "plan/plan.h"
#include "planet/site_frame.h"
#include "product/thinned_notes.h"
#include "product/thinned_rows.h"
#include "record/log.h"
#include "record/quantities.h"

namespace lsos {

// A series has at most about four points per stretch, besides those at the starts and ends of
// events. `report_places_max`: places of a rover on the map. The log has all samples.
inline constexpr int report_stretches = 1000;
inline constexpr std::size_t report_event_points_max = 1000, report_places_max = 5000;

// A point of the map: metres east and north in the site frame.
struct ReportPoint {
  double x_m = 0, y_m = 0;
};
using ReportLine = std::vector<ReportPoint>;

// Columns of ReportRover::position.
enum PositionColumn : std::size_t {
  position_x,
  position_y,
  position_lon_deg,
  position_lat_deg,
  position_heading_rad,  // clockwise from the site's north
  position_columns
};

// How much of a log is read for a page.
struct ReportScope {
  int stretches = report_stretches;
  std::size_t places_max = report_places_max;
  std::vector<const Quantity*> quantities;  // those that have a series; by default the plotted ones
  // Frame of the log's x_m, y_m where that is not the frame of the map.
  const SiteFrame* log_site = nullptr;

  ReportScope();
};

struct ReportRover {
  ReportRover(const std::string& rover_id, const SampleTotals& totals, const ReportScope& scope);

  std::string id, type;
  std::string colour;   // #rrggbb
  std::size_t samples;  // in the log
  ThinnedRows position;
  std::vector<std::pair<std::string, ThinnedRows>> series;  // by column of the log
  std::vector<ReportLine> drawn, planned;
  // Values of the last sample, for a run without a summary.
  double distance_m = 0, last_s = 0;
};

struct ReportPair {
  std::string from_id, to_id;
  using Spans = std::vector<std::pair<double, double>>;  // from, to, s
  Spans visible_s, link_s;
  std::map<std::string, Spans> hidden_s, relayed_s;  // key: by what
};

struct ReportDistance {
  std::string from_id, to_id;
  ThinnedRows distance_m;
};

struct ReportAsset {
  std::string id, type;
  ReportPoint place;
};

struct ReportData {
  Instant start;
  double end_s = 0;
  std::vector<ReportRover> rovers;             // in order of ids
  std::vector<EventRow> events;                // by rover, then sequence
  std::map<std::string, Activity> activities;  // by event type
  ThinnedNotes notes;
  std::vector<ReportPair> pairs;
  std::vector<ReportDistance> distances;  // between rovers
  std::vector<ReportAsset> assets;
  std::map<std::string, std::string> run;
  std::vector<std::string> quantities;  // names of the series that rovers have
  int stretches = report_stretches;     // that their series were thinned to
  std::vector<std::string> left_out;    // what the page lacks of the log, and says so
};

// `site`: the frame of the map, and of the log's x_m, y_m unless the scope has another.
ReportData read_report_data(const LogReader& log, const Plan& plan, const SiteFrame& site,
                            const ReportScope& scope = {});

// Adds what the plan has on the map: types and drawn lines of the rovers in `data`, and assets.
void add_drawn(const Plan& plan, const SiteFrame& site, ReportData& data);

// The site frame of a log, estimated from its first sample; accurate enough to draw a map.
SiteFrame site_of(const LogReader& log, const Plan& plan);

// Colour of the rover at that index in the order of ids: "#ff0000".
std::string web_colour(std::size_t place);

}  // namespace lsos
