#include "product/comparison/telemetry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/csv.h"
#include "product/comparison/telemetry_columns.h"

namespace lsos {

namespace {

constexpr std::size_t told_of_a_reason = 5;
// Clocks that differ by more do not show the same time; less is rounding.
constexpr double clocks_differ_s = 0.01;

// What tables write where nothing was measured.
bool is_blank(const std::string& cell) {
  constexpr std::array<std::string_view, 8> blanks{"",    "nan",  "NaN", "NAN",
                                                   "n/a", "NULL", "NA",  "-"};
  return std::ranges::find(blanks, cell) != blanks.end();
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string allowed_text(const Quantity& quantity) {
  if (std::isinf(quantity.greatest)) return fmt::format("at least {:.6g}", quantity.least);
  if (std::isinf(quantity.least)) return fmt::format("at most {:.6g}", quantity.greatest);
  return fmt::format("{:.6g} to {:.6g}", quantity.least, quantity.greatest);
}

// Reads the rows under a heading.
class RowReader {
 public:
  RowReader(const RunExtent& run, std::vector<TelemetryColumn> columns, Telemetry& telemetry)
      : run_(run), columns_(std::move(columns)), telemetry_(telemetry) {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const TelemetryColumn& column = columns_[k];
      if (column.kind == TelemetryKind::quantity) telemetry_.quantities.push_back(column.quantity);
      if (column.kind == TelemetryKind::lon) telemetry_.has_places = true;
    }
  }

  void read(const CsvRow& row) {
    ++telemetry_.rows;
    if (row.cells.size() > columns_.size()) {
      fault(row, "cells",
            fmt::format("has {} cells under {} headings{}", row.cells.size(), columns_.size(),
                        "; a decimal comma needs ';' or tabs as "
                        "separators, and quotes"));
      return;
    }
    const std::optional<SimTime> time = time_of(row);
    const std::optional<std::string> rover_id = rover_of(row);
    MeasuredRow measured;
    measured.line = row.line;
    const bool has_values = read_values(row, measured);
    if (!time || !rover_id) return;
    if (!has_values) return;
    measured.time = *time;
    telemetry_.by_rover[*rover_id].push_back(std::move(measured));
    ++telemetry_.rows_used;
  }

 private:
  void fault(const CsvRow& row, const std::string& reason, std::string what) {
    telemetry_.unusable.push_back({row.line, reason, std::move(what)});
  }

  const TelemetryColumn* column(TelemetryKind kind) const {
    const auto found = std::ranges::find(columns_, kind, &TelemetryColumn::kind);
    return found == columns_.end() ? nullptr : &*found;
  }

  std::string cell(const CsvRow& row, const TelemetryColumn* of) const {
    if (of == nullptr) return "";
    const auto k = static_cast<std::size_t>(of - columns_.data());
    return k < row.cells.size() && !is_blank(row.cells[k]) ? row.cells[k] : "";
  }

  // A number of a column; absent where nothing was measured or it cannot be read.
  std::optional<double> number(const CsvRow& row, const TelemetryColumn& of) {
    const std::string text = cell(row, &of);
    if (text.empty()) return {};
    const Parsed<double> value = of.value(text);
    if (!value) fault(row, of.heading, fmt::format("{}: {}", of.heading, value.why));
    return value.value;
  }

  std::optional<SimTime> time_of(const CsvRow& row) {
    const TelemetryColumn* const elapsed = column(TelemetryKind::time);
    const TelemetryColumn* const utc = column(TelemetryKind::utc);
    std::optional<double> time_s;
    const std::string utc_text = cell(row, utc);
    if (!utc_text.empty()) {
      const Parsed<Instant> instant = parse_utc(utc_text);
      if (!instant) {
        fault(row, utc->heading, fmt::format("{}: {}", utc->heading, instant.why));
        return {};
      }
      time_s = seconds(*instant.value - run_.start);
    }
    if (!cell(row, elapsed).empty()) {
      const std::optional<double> since_start_s = number(row, *elapsed);
      if (!since_start_s) return {};
      if (!time_s) {
        time_s = since_start_s;
      } else if (std::abs(*time_s - *since_start_s) > clocks_differ_s) {
        fault(row, "two times",
              fmt::format("{} is {:.6g} s after the run's start, {} says {:.6g} s; leave one out",
                          utc->heading, *time_s, elapsed->heading, *since_start_s));
        return {};
      }
    }
    if (!time_s) {
      fault(row, "no time", "has no time");
      return {};
    }
    if (!(*time_s >= 0 && *time_s <= seconds(run_.end))) {
      fault(row, "outside",
            fmt::format("is at {:.10g} s, outside the run: 0 to {:.10g} s, {} to {}", *time_s,
                        seconds(run_.end), format_utc(run_.start),
                        format_utc(run_.start + run_.end)));
      return {};
    }
    return from_seconds(*time_s);
  }

  std::optional<std::string> rover_of(const CsvRow& row) {
    const std::string id = cell(row, column(TelemetryKind::rover));
    if (id.empty() && run_.rovers.size() == 1) return run_.rovers.front();
    if (id.empty()) {
      fault(row, "no rover", fmt::format("names no rover; the run has {}", listed(run_.rovers)));
      return {};
    }
    if (std::ranges::find(run_.rovers, id) != run_.rovers.end()) return id;
    fault(row, "rover " + id,
          fmt::format("there is no rover '{}' in the run; it has {}{}", id, listed(run_.rovers),
                      did_you_mean(id, run_.rovers)));
    return {};
  }

  // Whether anything was measured.
  bool read_values(const CsvRow& row, MeasuredRow& measured) {
    bool has_any = false, is_blank_row = true;
    for (const TelemetryColumn& column : columns_) {
      if (column.kind == TelemetryKind::quantity) {
        is_blank_row &= cell(row, &column).empty();
        std::optional<double> value = number(row, column);
        if (value && !is_possible(row, column, *value)) value.reset();
        measured.values.push_back(value.value_or(not_modelled));
        has_any |= value.has_value();
      }
    }
    if (telemetry_.has_places) {
      const TelemetryColumn &lon = *column(TelemetryKind::lon), &lat = *column(TelemetryKind::lat);
      is_blank_row &= cell(row, &lon).empty() && cell(row, &lat).empty();
      const std::optional<double> lon_rad = number(row, lon), lat_rad = number(row, lat);
      if (lon_rad && lat_rad && is_place(row, degrees(*lon_rad), degrees(*lat_rad))) {
        measured.lon_deg = degrees(*lon_rad);
        measured.lat_deg = degrees(*lat_rad);
        has_any = true;
      } else if (cell(row, &lon).empty() != cell(row, &lat).empty()) {
        fault(row, "half a place",
              fmt::format("has {} alone of a place; both are wanted",
                          cell(row, &lon).empty() ? lat.heading : lon.heading));
      }
    }
    if (is_blank_row) fault(row, "no values", "has no measured value");
    return has_any;
  }

  // Angles are the same after whole turns, and small numbers may be noise about a bound.
  bool is_possible(const CsvRow& row, const TelemetryColumn& column, double value) {
    const Quantity* const logged = column.quantity->logged;
    if (logged == nullptr || column.quantity->is_angle()) return true;
    constexpr double noise = 0.05;
    if (value >= logged->least - noise && value <= logged->greatest + noise) return true;
    fault(row, column.heading + " out of range",
          fmt::format("{}: {} is out of range: {} is {}{}", column.heading, cell(row, &column),
                      column.quantity->name, allowed_text(*logged),
                      column.quantity->name == "charge" && column.factor == 1
                          ? "; per cent want the heading 'charge (%)'"
                          : ""));
    return false;
  }

  bool is_place(const CsvRow& row, double lon_deg, double lat_deg) {
    if (std::abs(lat_deg) <= 90 && std::abs(lon_deg) <= 360) return true;
    fault(row, "place",
          fmt::format("longitude {:.10g}, latitude {:.10g}: no place; latitudes are "
                      "-90 to 90 degrees, longitudes -180 to 180",
                      lon_deg, lat_deg));
    return false;
  }

  const RunExtent& run_;
  std::vector<TelemetryColumn> columns_;
  Telemetry& telemetry_;
};

// Columns without which no row can be used are faults of the heading.
void check_heading(const CsvRow& heading, const RunExtent& run,
                   std::vector<TelemetryColumn>& columns, Telemetry& telemetry) {
  const auto fault = [&](std::string what) {
    telemetry.unusable.push_back({heading.line, "heading", std::move(what)});
  };
  const auto has = [&](TelemetryKind kind) {
    return std::ranges::find(columns, kind, &TelemetryColumn::kind) != columns.end();
  };
  for (const TelemetryColumn& column : columns) {
    if (!column.fault.empty()) fault(fmt::format("column '{}': {}", column.heading, column.fault));
  }
  if (!has(TelemetryKind::time) && !has(TelemetryKind::utc)) {
    fault("there is no column of times: 'time_s' (seconds since the run's start) or 'utc'");
  }
  if (!has(TelemetryKind::rover) && run.rovers.size() > 1) {
    fault(fmt::format("there is no column 'rover_id', and the run has {}", listed(run.rovers)));
  }
  if (has(TelemetryKind::lon) != has(TelemetryKind::lat)) {
    fault(fmt::format("there is no column '{}': a place needs 'lon_deg' and 'lat_deg'",
                      has(TelemetryKind::lon) ? "lat_deg" : "lon_deg"));
    for (TelemetryColumn& column : columns) {
      if (column.kind == TelemetryKind::lon || column.kind == TelemetryKind::lat) {
        column.kind = TelemetryKind::unusable;
      }
    }
  }
  if (!has(TelemetryKind::quantity) && !has(TelemetryKind::lon)) {
    fault(
        "there is no column to compare: 'lon_deg' and 'lat_deg', or logged quantities, such as "
        "'speed_mps', 'Energy (kWh)', 'charge'");
  }
}

}  // namespace

std::vector<Fault> faults_of(const Telemetry& telemetry, Severity severity) {
  std::map<std::string, std::size_t> counts;
  std::vector<Fault> faults;
  for (const Unusable& unusable : telemetry.unusable) {
    const std::size_t count = ++counts[unusable.reason];
    if (count > told_of_a_reason && unusable.reason != "heading") continue;
    faults.push_back({severity, {telemetry.file, unusable.line}, unusable.what});
  }
  for (const auto& [reason, count] : counts) {
    if (count <= told_of_a_reason || reason == "heading") continue;
    const auto last = std::ranges::find(telemetry.unusable.rbegin(), telemetry.unusable.rend(),
                                        reason, &Unusable::reason);
    faults.push_back(
        {severity,
         {telemetry.file, last->line},
         fmt::format("the last of {} more like it ({}){}", count - told_of_a_reason, reason,
                     severity == Severity::warning ? "; --json lists all" : "")});
  }
  return faults;
}

Telemetry read_telemetry(const std::string& file, std::string_view text, const RunExtent& run) {
  Telemetry telemetry;
  telemetry.file = file;
  const CsvTable table = parse_csv(text);
  if (table.rows.empty()) {
    throw InputError({file, table.fault_line},
                     table.fault.empty() ? "has no heading: a table of telemetry begins with the "
                                           "names of its columns, such as time_s,rover_id,speed_mps"
                                         : table.fault);
  }
  std::vector<TelemetryColumn> columns = telemetry_columns(table.rows.front().cells);
  check_heading(table.rows.front(), run, columns, telemetry);
  const bool has_time = std::ranges::any_of(columns, [](const TelemetryColumn& column) {
    return column.kind == TelemetryKind::time || column.kind == TelemetryKind::utc;
  });
  const bool has_values = std::ranges::any_of(columns, [](const TelemetryColumn& column) {
    return column.kind == TelemetryKind::quantity || column.kind == TelemetryKind::lon;
  });
  const bool has_rovers =
      run.rovers.size() == 1 ||
      std::ranges::find(columns, TelemetryKind::rover, &TelemetryColumn::kind) != columns.end();
  // Each row would only repeat what the heading lacks.
  if (has_time && has_values && has_rovers) {
    RowReader reader(run, std::move(columns), telemetry);
    for (std::size_t k = 1; k < table.rows.size(); ++k) reader.read(table.rows[k]);
    if (table.rows.size() == 1) telemetry.unusable.push_back({0, "no rows", "has no rows"});
  }
  if (!table.fault.empty()) {
    telemetry.unusable.push_back({table.fault_line, "quotes", table.fault});
  }
  if (telemetry.rows_used == 0) throw InputError(faults_of(telemetry, Severity::error));
  for (auto& [id, rows] : telemetry.by_rover) {
    std::ranges::stable_sort(rows, {}, &MeasuredRow::time);
  }
  return telemetry;
}

}  // namespace lsos
