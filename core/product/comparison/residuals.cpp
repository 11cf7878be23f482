#include "product/comparison/residuals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "planet/site_frame.h"

namespace lsos {

namespace {

constexpr double standing_m = 0.01;  // a shorter way between samples has no direction
constexpr std::array<std::pair<const char*, const char*>, 3> place_series{
    {{"place_along_m", "Place along the track, m"},
     {"place_across_m", "Place across the track, m"},
     {"place_distance_m", "Place, distance, m"}}};

// Two samples of a rover and a time between them.
struct Between {
  const SampleRow& before;
  const SampleRow& after;
  double share = 0;  // of the time from one to the other

  double value(const MeasuredQuantity& quantity) const {
    const double a = quantity.value(before), b = quantity.value(after);
    if (share == 0) return a;
    if (share == 1) return b;
    return a + share * difference(quantity, b, a);
  }
};

struct AlongAcross {
  double along_m = 0, across_m = 0;
};

AlongAcross place_residual(const Body& body, const MeasuredRow& row, const Between& at) {
  const Vec3 a_F_m = p_F_m(body, at.before.place), b_F_m = p_F_m(body, at.after.place);
  const Geodetic simulated = geodetic(body, Vec3(a_F_m + at.share * (b_F_m - a_F_m)));
  // At the simulated place, where x is east and y north, both places being on the ground there.
  const SiteFrame here(body, simulated);
  const Vec3 away_S_m =
      here.p_S_m(geodetic_from_degrees(row.lon_deg, row.lat_deg, simulated.height_m));
  Vec3 ahead_S = here.R_FS().transpose() * (b_F_m - a_F_m);
  ahead_S.z() = 0;
  if (ahead_S.norm() < standing_m) {
    ahead_S = here.horizontal_S(at.before.heading_rad, Vec3::Zero());
  }
  ahead_S.normalize();
  return {away_S_m.dot(ahead_S), ahead_S.x() * away_S_m.y() - ahead_S.y() * away_S_m.x()};
}

// The series of one rover, filled as its samples pass.
class RoverResiduals {
 public:
  RoverResiduals(const std::string& rover_id, const Telemetry& telemetry, const Body& body)
      : telemetry_(telemetry), body_(body), rows_(telemetry.by_rover.at(rover_id)) {
    for (const MeasuredQuantity* quantity : telemetry.quantities) {
      series_.push_back({rover_id, quantity->name, quantity->title, {}, 0});
    }
    if (!telemetry.has_places) return;
    for (const auto& [name, title] : place_series) {
      series_.push_back({rover_id, name, title, {}, 0});
    }
  }

  void pass(const SampleRow& sample) {
    for (; next_ < rows_.size() && rows_[next_].time <= sample.time; ++next_) {
      const SampleRow& before = before_ ? *before_ : sample;
      const double span_s = seconds(sample.time - before.time);
      const double since_s = seconds(rows_[next_].time - before.time);
      add(rows_[next_], {before, sample, span_s > 0 ? since_s / span_s : 1});
    }
    before_ = sample;
  }

  // Series in which anything was measured.
  std::vector<ResidualSeries> series() && {
    for (; next_ < rows_.size(); ++next_) miss(rows_[next_]);
    std::erase_if(series_, [](const ResidualSeries& series) {
      return series.residuals.empty() && series.without_simulated == 0;
    });
    return std::move(series_);
  }
  const std::vector<MeasuredPlace>& places() const { return places_; }

 private:
  // A row after the last sample, as of a rover that was parked when its run was killed.
  void miss(const MeasuredRow& row) {
    for (std::size_t k = 0; k < series_.size(); ++k) {
      const bool is_place = k >= telemetry_.quantities.size();
      if (!std::isnan(is_place ? row.lon_deg : row.values[k])) ++series_[k].without_simulated;
    }
  }
  void add(const MeasuredRow& row, const Between& at) {
    const double time_s = seconds(row.time);
    for (std::size_t k = 0; k < telemetry_.quantities.size(); ++k) {
      const MeasuredQuantity& quantity = *telemetry_.quantities[k];
      const double measured = row.values[k], simulated = at.value(quantity);
      if (std::isnan(measured)) continue;
      if (std::isnan(simulated)) {
        ++series_[k].without_simulated;
        continue;
      }
      series_[k].residuals.push_back(
          {time_s, measured, simulated, difference(quantity, measured, simulated)});
    }
    if (std::isnan(row.lon_deg)) return;
    const auto [along_m, across_m] = place_residual(body_, row, at);
    const std::array values_m{along_m, across_m, std::hypot(along_m, across_m)};
    for (std::size_t k = 0; k < values_m.size(); ++k) {
      series_[telemetry_.quantities.size() + k].residuals.push_back(
          {time_s, not_modelled, not_modelled, values_m[k]});
    }
    places_.push_back({time_s, row.lon_deg, row.lat_deg});
  }

  const Telemetry& telemetry_;
  const Body& body_;
  const std::vector<MeasuredRow>& rows_;
  std::size_t next_ = 0;
  std::optional<SampleRow> before_;
  std::vector<ResidualSeries> series_;
  std::vector<MeasuredPlace> places_;
};

class Statistics {
 public:
  void add(const Residual& one) {
    ++found_.count;
    sum_ += one.residual;
    squares_ += one.residual * one.residual;
    if (found_.count == 1 || std::abs(one.residual) > std::abs(found_.greatest)) {
      found_.greatest = one.residual;
      found_.greatest_s = one.time_s;
    }
  }
  ResidualStatistics result() const {
    ResidualStatistics result = found_;
    const auto count = static_cast<double>(std::max<std::size_t>(1, found_.count));
    result.mean = sum_ / count;
    result.rms = std::sqrt(squares_ / count);
    return result;
  }

 private:
  ResidualStatistics found_;
  double sum_ = 0, squares_ = 0;
};

// The event that a rover was in at a time: that which has begun last, its end included.
const EventRow* event_at(const std::vector<const EventRow*>& events, double time_s) {
  const EventRow* found = nullptr;
  for (const EventRow* event : events) {
    if (seconds(*event->start) > time_s || (event->end && seconds(*event->end) < time_s)) continue;
    if (found == nullptr || *event->start >= *found->start) found = event;
  }
  return found;
}

void summarize(const ResidualSeries& series, const std::vector<EventRow>& events,
               std::vector<ResidualSummary>& summaries) {
  std::vector<const EventRow*> started;
  for (const EventRow& event : events) {
    if (event.rover_id == series.rover_id && event.start) started.push_back(&event);
  }
  Statistics all, between;
  std::map<const EventRow*, Statistics> by_event;
  for (const Residual& one : series.residuals) {
    all.add(one);
    const EventRow* event = event_at(started, one.time_s);
    (event != nullptr ? by_event[event] : between).add(one);
  }
  using Span = ResidualSummary::Span;
  summaries.push_back({series.rover_id, series.quantity, Span::all, 0, "", all.result()});
  for (const EventRow* event : started) {
    if (!by_event.contains(event)) continue;
    summaries.push_back({series.rover_id, series.quantity, Span::event, event->sequence,
                         event->label, by_event.at(event).result()});
  }
  if (between.result().count > 0) {
    summaries.push_back({series.rover_id, series.quantity, Span::between, 0, "", between.result()});
  }
}

}  // namespace

Residuals residuals(const LogReader& log, const Body& body, const Telemetry& telemetry) {
  std::map<std::string, RoverResiduals> rovers;
  for (const auto& [id, rows] : telemetry.by_rover) {
    rovers.try_emplace(id, id, telemetry, body);
  }
  log.for_each_sample([&](const SampleRow& row) {
    const auto found = rovers.find(row.rover_id);
    if (found != rovers.end()) found->second.pass(row);
  });
  std::vector<EventRow> events = log.events();
  std::ranges::stable_sort(
      events, {}, [](const EventRow& event) { return std::pair(event.start, event.sequence); });
  Residuals found;
  for (auto& [id, rover] : rovers) {
    if (!rover.places().empty()) found.places[id] = rover.places();
    for (ResidualSeries& series : std::move(rover).series()) {
      summarize(series, events, found.summaries);
      found.series.push_back(std::move(series));
    }
  }
  std::ranges::stable_sort(found.summaries, {}, [](const ResidualSummary& summary) {
    return std::tuple(summary.rover_id, summary.span, summary.sequence);
  });
  return found;
}

}  // namespace lsos
