#include "product/study/bands.h"

#include <algorithm>
#include <cmath>

#include "product/study/case_series.h"
#include "product/study/quantiles.h"

namespace lsos {

namespace {

const TableLayer bands_layer{"bands",
                             LayerGeometry::none,
                             {{"rover_id", ColumnType::text},
                              {"quantity", ColumnType::text},
                              {"time_s"},
                              {"p5"},
                              {"p50"},
                              {"p95"},
                              {"share_reached"},
                              {"cases", ColumnType::integer}}};

const TableLayer arrivals_layer{"arrivals",
                                LayerGeometry::point,
                                {{"rover_id", ColumnType::text},
                                 {"sequence", ColumnType::integer},
                                 {"type", ColumnType::text},
                                 {"label", ColumnType::text},
                                 {"end_s_p5"},
                                 {"end_s_p50"},
                                 {"end_s_p95"},
                                 {"charge_p5"},
                                 {"charge_p50"},
                                 {"charge_p95"},
                                 {"share_reached"},
                                 {"cases", ColumnType::integer}}};

constexpr std::size_t series_longitude = 2;  // of series_quantities

// Longitudes on both sides of 180 degrees are neighbours.
double near_to(double lon_deg, double reference_deg) {
  constexpr double turn_deg = 360;
  return lon_deg - turn_deg * std::round((lon_deg - reference_deg) / turn_deg);
}

double within_half_turn(double lon_deg) { return near_to(lon_deg, 0); }

// The values of all cases at some times, time by time.
using Block = std::vector<std::vector<double>>;

Block read_block(const std::vector<SeriesFile>& series, const std::string& rover,
                 std::size_t quantity, std::size_t from, std::size_t count) {
  Block block(count);
  for (std::vector<double>& values : block) values.reserve(series.size());
  std::optional<double> reference_deg;
  for (const SeriesFile& file : series) {
    std::vector<double> values = file.values(rover, quantity, from, count);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (quantity == series_longitude) {
        if (!reference_deg) reference_deg = values[i];
        values[i] = near_to(values[i], *reference_deg);
      }
      block[i].push_back(values[i]);
    }
  }
  return block;
}

void write_band(const std::vector<SeriesFile>& series, const std::string& rover,
                std::size_t quantity, TableFile& table) {
  constexpr std::size_t values_max = 4'000'000;
  std::size_t times = 0;
  for (const SeriesFile& file : series) times = std::max(times, file.count(rover));
  const std::size_t count = std::max<std::size_t>(1, values_max / series.size());
  for (std::size_t from = 0; from < times; from += count) {
    Block block = read_block(series, rover, quantity, from, std::min(count, times - from));
    for (std::size_t i = 0; i < block.size(); ++i) {
      Quantiles found = quantiles_of(block[i]);
      if (found.count == 0) continue;
      if (quantity == series_longitude) {
        for (double* each : {&found.p5, &found.p50, &found.p95}) *each = within_half_turn(*each);
      }
      table.write({rover, std::string(series_quantities[quantity]),
                   static_cast<double>(from + i) * series.front().interval_s(), found.p5, found.p50,
                   found.p95, static_cast<double>(found.count) / static_cast<double>(series.size()),
                   static_cast<std::int64_t>(found.count)});
    }
  }
}

}  // namespace

void write_bands(const std::vector<std::string>& files, const std::vector<std::string>& rovers,
                 TableFile& table) {
  table.begin(bands_layer);
  std::vector<SeriesFile> series;
  for (const std::string& file : files) series.emplace_back(file);
  if (series.empty()) return;
  for (const std::string& rover : rovers) {
    for (std::size_t i = 0; i < series_quantities.size(); ++i) write_band(series, rover, i, table);
  }
}

void Arrivals::add(const CaseRecord& record) {
  ++cases_;
  for (const CaseRecord::Event& event : record.events) {
    if (event.status != "completed" || !event.end_s) continue;
    Reached& reached = reached_[{event.rover_id, event.sequence}];
    reached.end_s.push_back(*event.end_s);
    if (event.charge) reached.charge.push_back(*event.charge);
  }
}

void Arrivals::write(TableFile& table) {
  table.begin(arrivals_layer);
  for (const PlannedEvent& event : events_) {
    Reached& reached = reached_[{event.rover_id, event.sequence}];
    const Quantiles end = quantiles_of(reached.end_s), charge = quantiles_of(reached.charge);
    const auto cell = [](const Quantiles& of, double value) {
      return of.count > 0 ? ColumnValue{value} : ColumnValue{};
    };
    const double share =
        cases_ == 0 ? 0 : static_cast<double>(end.count) / static_cast<double>(cases_);
    table.write(
        {event.rover_id, event.sequence, event.type, event.label, cell(end, end.p5),
         cell(end, end.p50), cell(end, end.p95), cell(charge, charge.p5), cell(charge, charge.p50),
         cell(charge, charge.p95), share, static_cast<std::int64_t>(cases_)},
        event.place);
  }
}

}  // namespace lsos
