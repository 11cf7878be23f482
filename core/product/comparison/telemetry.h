// Telemetry: measured rows of a table, checked against the run that they are laid over.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "product/comparison/measured_quantity.h"
#include "record/log.h"

namespace lsos {

// One usable row of a rover.
struct MeasuredRow {
  SimTime time{};
  int line = 0;
  double lon_deg = not_modelled, lat_deg = not_modelled;  // NaN: no place was measured
  std::vector<double> values;  // in SI, by Telemetry::quantities; NaN: not measured
};

// A row, a cell or a column that cannot be used. Those of one reason belong together.
struct Unusable {
  int line = 0;
  std::string reason;  // "time_s": the column or rover that it is about
  std::string what;    // what was found, and what is allowed
};

struct Telemetry {
  std::string file;
  std::vector<const MeasuredQuantity*> quantities;
  bool has_places = false;
  std::map<std::string, std::vector<MeasuredRow>> by_rover;  // in order of time
  std::size_t rows = 0, rows_used = 0;
  std::vector<Unusable> unusable;  // in order of lines
};

// The rovers of a run and the time that it covers.
struct RunExtent {
  Instant start;
  SimTime end{};
  std::vector<std::string> rovers;
};

// Throws InputError with all faults where no row can be used.
Telemetry read_telemetry(const std::string& file, std::string_view text, const RunExtent& run);

// The faults as messages. Of many with one reason the first are told, and how many more there are.
std::vector<Fault> faults_of(const Telemetry& telemetry, Severity severity);

}  // namespace lsos
