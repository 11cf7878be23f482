// The heading of a table of telemetry: what each of its columns has, and in which unit.
#pragma once

#include <string>
#include <vector>

#include "base/parsed.h"
#include "product/comparison/measured_quantity.h"

namespace lsos {

enum class TelemetryKind { unusable, ignored, time, utc, rover, lon, lat, quantity };

struct TelemetryColumn {
  std::string heading;
  TelemetryKind kind = TelemetryKind::unusable;
  const MeasuredQuantity* quantity = nullptr;
  // A bare number in it is `factor` times this unit.
  const Unit* unit = nullptr;
  double factor = 1;
  std::string fault;  // why it is unusable

  // A cell of it in SI.
  Parsed<double> value(const std::string& cell) const;
};

// Reads "speed_mps", "speed_kmph", "Speed (km/h)", "Speed, m/s", "utc", "rover_id", "lon_deg".
TelemetryColumn telemetry_column(const std::string& heading);

// The columns of a heading. One that gives again what an earlier one gives is unusable.
std::vector<TelemetryColumn> telemetry_columns(const std::vector<std::string>& headings);

}  // namespace lsos
