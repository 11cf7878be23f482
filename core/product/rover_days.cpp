#include "product/rover_days.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "base/csv.h"
#include "base/files.h"
#include "planet/sunlight.h"

namespace lsos {

namespace {

// Sums since the start of the mission, and what is read off between two samples.
constexpr std::array cumulative{&SampleRow::distance_m, &SampleRow::solar_j, &SampleRow::external_j,
                                &SampleRow::load_j,     &SampleRow::drive_j, &SampleRow::loss_j};

double lesser(double a, double b) { return std::isnan(a) || b < a ? b : a; }
double greater(double a, double b) { return std::isnan(a) || b > a ? b : a; }

// A sample between two others.
SampleRow between(const SampleRow& before, const SampleRow& after, SimTime time) {
  const double share = seconds(time - before.time) / seconds(after.time - before.time);
  SampleRow row = before;
  row.time = time;
  for (const auto value : cumulative) {
    row.*value = before.*value + share * (after.*value - before.*value);
  }
  row.charge = before.charge + share * (after.charge - before.charge);
  return row;
}

// Elevation of the Sun's middle where a rover was.
using SunElevation = std::function<double(const SampleRow&)>;

// Cuts the samples of one rover into days.
class DayCutter {
 public:
  explicit DayCutter(SunElevation sun_elevation_rad)
      : sun_elevation_rad_(std::move(sun_elevation_rad)) {}

  void add(const SampleRow& row) {
    note_dawn_and_dusk(row);
    if (!before_) {
      begin(row);
      before_ = row;
      return;
    }
    for (SimTime midnight = next_midnight(); midnight < row.time; midnight = next_midnight()) {
      const SampleRow cut = between(*before_, row, midnight);
      pass(cut, row.speed_mps);
      end();
      begin(cut);
      before_ = cut;
    }
    pass(row, row.speed_mps);
    before_ = row;
  }

  std::vector<RoverDay> take() {
    if (before_ && !days_.empty()) end();
    // Nothing happens on a day that ends as it begins.
    if (days_.size() > 1 && days_.back().from_s >= days_.back().to_s) days_.pop_back();
    for (const auto& [day, crossing] : crossings_) {
      if (day >= days_.size()) continue;
      days_[day].charge_dawn = crossing.dawn;
      days_[day].charge_dusk = crossing.dusk;
    }
    return std::move(days_);
  }

 private:
  SimTime next_midnight() const { return static_cast<int>(days_.size()) * day_length; }

  void begin(const SampleRow& row) {
    RoverDay& day = days_.emplace_back();
    first_ = row;
    day.rover_id = row.rover_id;
    day.day = static_cast<int>(days_.size());
    day.from_s = seconds(row.time);
    day.charge_start = day.charge_min = day.charge_max = row.charge;
    day.max_slope_rad = row.slope_rad;
    if (!std::isnan(row.sun_fraction)) day.sunlit_s = 0;
  }

  // A crossing of the horizon counts for the day on which the sample after it is. The Sun is looked
  // at every few minutes, in which it moves by a degree and the charge is linear.
  void note_dawn_and_dusk(const SampleRow& row) {
    constexpr SimTime step{300'000'000};
    if (sun_ && row.time - sun_->time < step) return;
    const SunSample now{row.time, sun_elevation_rad_(row), row.charge};
    const std::optional<SunSample> then = std::exchange(sun_, now);
    if (!then || !(then->elevation_rad * now.elevation_rad < 0)) return;
    const double share = then->elevation_rad / (then->elevation_rad - now.elevation_rad);
    const double charge = std::lerp(then->charge, now.charge, share);
    Crossing& crossing = crossings_[static_cast<std::size_t>(row.time / day_length)];
    if (now.elevation_rad > 0 && std::isnan(crossing.dawn)) crossing.dawn = charge;
    if (now.elevation_rad < 0) crossing.dusk = charge;
  }

  // Up to a row: a rover that stands at one end of a stretch has driven if it moves at the other.
  void pass(const SampleRow& row, double speed_mps) {
    RoverDay& day = days_.back();
    const double span_s = seconds(row.time - before_->time);
    if (std::max(before_->speed_mps, speed_mps) > moving_mps) day.drive_s += span_s;
    if (before_->sun_fraction > 0) day.sunlit_s += span_s;
    day.charge_min = lesser(day.charge_min, row.charge);
    day.charge_max = greater(day.charge_max, row.charge);
    day.max_slope_rad = greater(day.max_slope_rad, row.slope_rad);
    last_ = row;
  }

  void end() {
    RoverDay& day = days_.back();
    const SampleRow& last = last_ ? *last_ : first_;
    const auto since = [&](double SampleRow::*value) { return last.*value - first_.*value; };
    day.to_s = seconds(last.time);
    day.distance_m = since(&SampleRow::distance_m);
    day.solar_j = since(&SampleRow::solar_j);
    day.external_j = since(&SampleRow::external_j);
    day.energy_used_j =
        since(&SampleRow::load_j) + since(&SampleRow::drive_j) + since(&SampleRow::loss_j);
    day.charge_end = last.charge;
    last_.reset();
  }

  struct Crossing {
    double dawn = not_modelled, dusk = not_modelled;  // charge
  };
  struct SunSample {
    SimTime time;
    double elevation_rad, charge;
  };

  SunElevation sun_elevation_rad_;
  std::optional<SunSample> sun_;               // where the Sun was looked at last
  std::map<std::size_t, Crossing> crossings_;  // by day, from 0
  std::vector<RoverDay> days_;
  SampleRow first_;
  std::optional<SampleRow> before_, last_;
};

// The body of a log; nullptr when it does not say.
const Body* body_of(const LogReader& log) {
  const std::map<std::string, std::string> run = log.run();
  const auto planet = run.find("planet");
  return planet == run.end() ? nullptr : find_body(planet->second);
}

using DaysByRover = std::map<std::string, std::vector<RoverDay>>;

RoverDay* day_at(DaysByRover& rovers, const std::string& id, SimTime time) {
  const auto rover = rovers.find(id);
  if (rover == rovers.end() || rover->second.empty()) return nullptr;
  const auto number = static_cast<std::size_t>(time / day_length);
  return &rover->second[std::min(number, rover->second.size() - 1)];
}

void count_events(const LogReader& log, DaysByRover& rovers) {
  for (const EventRow& event : log.events()) {
    if (!event.start) continue;
    RoverDay* const begun = day_at(rovers, event.rover_id, *event.start);
    if (begun != nullptr && event.type == "EVA") ++begun->evas;
    if (!event.end) continue;
    if (RoverDay* const ended = day_at(rovers, event.rover_id, *event.end)) ++ended->events_ended;
  }
}

void add_earth(const LogReader& log, DaysByRover& rovers) {
  bool has_earth = false;
  log.for_each_pair([&](const PairRow& row) { has_earth |= row.to_id == "Earth"; });
  if (!has_earth) return;
  for (auto& [id, days] : rovers) {
    for (RoverDay& day : days) day.earth_visible_s = day.earth_link_s = 0;
  }
  log.for_each_sight_interval([&](const SightIntervalRow& row) {
    const auto rover = rovers.find(row.from_id);
    if (row.kind != "visible" && row.kind != "link") return;
    if (row.to_id != "Earth" || rover == rovers.end()) return;
    for (RoverDay& day : rover->second) {
      const double from_s = std::max(day.from_s, seconds(row.start));
      const double to_s = std::min(day.to_s, seconds(row.end));
      if (to_s <= from_s) continue;
      (row.kind == "link" ? day.earth_link_s : day.earth_visible_s) += to_s - from_s;
    }
  });
}

}  // namespace

std::vector<RoverDay> rover_days(const LogReader& log) {
  const Body* const body = body_of(log);
  const SunElevation sun_elevation_rad = [&](const SampleRow& row) {
    if (body == nullptr) return not_modelled;
    return sunlight(*body, row.place, log.start() + row.time, 0).seen.elevation_rad;
  };
  std::map<std::string, DayCutter> cutters;
  log.for_each_sample([&](const SampleRow& row) {
    cutters.try_emplace(row.rover_id, sun_elevation_rad).first->second.add(row);
  });
  DaysByRover rovers;
  for (auto& [id, cutter] : cutters) rovers[id] = cutter.take();
  count_events(log, rovers);
  add_earth(log, rovers);
  std::vector<RoverDay> days;
  for (const auto& [id, of_rover] : rovers) {
    days.insert(days.end(), of_rover.begin(), of_rover.end());
  }
  return days;
}

std::vector<RoverDay> days_of_long_run(const LogReader& log) {
  if (!log.has_samples() || log.last_sample_time() <= day_length) return {};
  return rover_days(log);
}

void write_days(const std::string& run_dir) {
  if (!std::filesystem::exists(run_dir + "/summary.json")) return;
  const LogReader log(run_dir + "/log.gpkg");
  const std::vector<RoverDay> days = days_of_long_run(log);
  if (!days.empty()) write_file(run_dir + "/days.csv", days_csv(days, log.start()));
}

const std::vector<DayColumn>& day_columns() {
  static const std::vector<DayColumn> columns{
      {"from_s", &RoverDay::from_s},
      {"to_s", &RoverDay::to_s},
      {"distance_m", &RoverDay::distance_m},
      {"drive_s", &RoverDay::drive_s},
      {"energy_used_j", &RoverDay::energy_used_j},
      {"solar_j", &RoverDay::solar_j},
      {"external_j", &RoverDay::external_j},
      {"charge_start", &RoverDay::charge_start},
      {"charge_min", &RoverDay::charge_min},
      {"charge_max", &RoverDay::charge_max},
      {"charge_end", &RoverDay::charge_end},
      {"charge_dawn", &RoverDay::charge_dawn},
      {"charge_dusk", &RoverDay::charge_dusk},
      {"sunlit_s", &RoverDay::sunlit_s},
      {"earth_visible_s", &RoverDay::earth_visible_s},
      {"earth_link_s", &RoverDay::earth_link_s},
      {"max_slope_rad", &RoverDay::max_slope_rad},
      {"events_ended", &RoverDay::events_ended},
      {"evas", &RoverDay::evas},
  };
  return columns;
}

std::string days_csv(const std::vector<RoverDay>& days, Instant start) {
  std::string csv = "rover_id,day,from_utc";
  for (const DayColumn& column : day_columns()) csv += fmt::format(",{}", column.name);
  csv += '\n';
  for (const RoverDay& day : days) {
    csv += fmt::format("{},{},{}", csv_cell(day.rover_id), day.day,
                       format_utc(start + from_seconds(day.from_s)));
    for (const DayColumn& column : day_columns()) {
      const double value = day.*column.value;
      csv += std::isnan(value) ? "," : fmt::format(",{:.10g}", value);
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace lsos
