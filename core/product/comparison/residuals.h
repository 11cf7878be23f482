// What was measured minus what was simulated at the same time.
//
// Simulated values are interpolated linearly in time between the two samples of the rover's log
// around a measurement, angles the shorter way round; at the time of a sample they are that
// sample's. Where the log has no value on either side (NULL) there is no residual.
//
// The residual of a place has three numbers: metres along the simulated track (positive: measured
// ahead of the simulated place), across it (positive: to the left), and the distance of the two.
// Along is the direction of the simulated motion between the two samples, or the rover's heading
// where it moved less than a centimetre.
#pragma once

#include <string>
#include <vector>

#include "planet/body.h"
#include "product/comparison/telemetry.h"

namespace lsos {

struct Residual {
  double time_s = 0;
  double measured = not_modelled, simulated = not_modelled;  // NaN for those of a place
  double residual = 0;
};

// The residuals of one rover and quantity, in order of time.
struct ResidualSeries {
  std::string rover_id;
  std::string quantity;  // name with its SI unit: "speed_mps", "place_along_m"
  std::string title;     // "Speed, m/s"
  std::vector<Residual> residuals;
  std::size_t without_simulated = 0;  // measurements for which the log has no value
};

struct MeasuredPlace {
  double time_s = 0, lon_deg = 0, lat_deg = 0;
};

// Statistics of a series during one event, between events, or all along.
struct ResidualStatistics {
  std::size_t count = 0;
  double mean = 0, rms = 0;
  double greatest = 0, greatest_s = 0;  // the residual farthest from 0, and when
};
struct ResidualSummary {
  std::string rover_id, quantity;
  enum class Span { all, event, between } span = Span::all;
  std::int64_t sequence = 0;  // of the event
  std::string label;
  ResidualStatistics statistics;
};

struct Residuals {
  std::vector<ResidualSeries> series;                        // by rover, then in order of columns
  std::map<std::string, std::vector<MeasuredPlace>> places;  // by rover
  std::vector<ResidualSummary> summaries;  // by rover; all along first, then by event
};

Residuals residuals(const LogReader& log, const Body& body, const Telemetry& telemetry);

}  // namespace lsos
