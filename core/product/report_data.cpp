#include "product/report_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/polyline.h"
#include "base/units.h"
#include "picture/rover_colors.h"
#include "product/drive_marks.h"
#include "product/shown_rows.h"

namespace lsos {

namespace {

constexpr double shown_line_tolerance_m = 0.2;

ReportLine simplified_line(const ReportLine& line) {
  std::vector<Vec2> points_m;
  for (const ReportPoint& point : line) points_m.emplace_back(point.x_m, point.y_m);
  ReportLine simple;
  for (const Vec2& point_m : simplified(points_m, shown_line_tolerance_m)) {
    simple.push_back({point_m.x(), point_m.y()});
  }
  return simple;
}

ReportPoint map_point(const SiteFrame& site, const Geodetic& place) {
  const Vec3 p_S_m = site.p_S_m({place.lon_rad, place.lat_rad, site.origin().height_m});
  return {p_S_m.x(), p_S_m.y()};
}

ReportLine map_line(const SiteFrame& site, const std::vector<Geodetic>& places) {
  ReportLine line;
  for (const Geodetic& place : places) line.push_back(map_point(site, place));
  return simplified_line(line);
}

// Heading relative to the map's axes: near a pole the local north turns with each step.
double heading_on_map_rad(const SiteFrame& site, const SampleRow& row) {
  const Vec3 ahead_S = site.horizontal_S(row.heading_rad, row.p_S_m);
  return std::atan2(ahead_S.x(), ahead_S.y());
}

// Chooses the rows of a rover that are shown over time and on the map.
struct Thinning {
  EventMarks of_series;
  DriveMarks of_places;
  KeptRows places;
};

void add_position(const SampleRow& row, const SiteFrame& site, ThinnedRows& position) {
  position.add(seconds(row.time), std::array{row.p_S_m.x(), row.p_S_m.y(), lon_deg(row.place),
                                             lat_deg(row.place), heading_on_map_rad(site, row)});
}

void read_samples(const LogReader& log, const SiteFrame& site, const ReportScope& scope,
                  ReportData& data) {
  std::map<std::string, ReportRover> rovers;
  std::map<std::string, Thinning> thinnings;
  for (const auto& [id, totals] : log.sample_totals()) {
    rovers.try_emplace(id, id, totals, scope);
    thinnings.try_emplace(id, Thinning{EventMarks(data.events, id, report_event_points_max),
                                       DriveMarks(totals, data.events, id, scope.places_max),
                                       {}});
  }
  const auto add = [&](const SampleRow& row) {
    const auto known = rovers.find(row.rover_id);
    if (known == rovers.end())
      return;  // in a run that goes on: its first row was written after counting
    ReportRover& rover = known->second;
    Thinning& thinning = thinnings.at(row.rover_id);
    const double time_s = seconds(row.time);
    thinning.places.add(row, thinning.of_places.next(row));
    const WantedRows wanted = thinning.of_series.next(row.time);
    const bool is_moving = row.speed_mps > moving_mps;
    for (std::size_t k = 0; k < scope.quantities.size(); ++k) {
      rover.series[k].second.add(time_s, std::array{row.*scope.quantities[k]->value}, is_moving,
                                 wanted);
    }
    rover.distance_m = row.distance_m;
    rover.last_s = time_s;
  };
  log.for_each_sample([&](const SampleRow& row) {
    if (scope.log_site == nullptr) return add(row);
    SampleRow moved = row;
    moved.p_S_m = site.p_S_m_from_fixed(scope.log_site->p_F_m(row.p_S_m));
    add(moved);
  });
  for (auto& [id, rover] : rovers) {
    for (const SampleRow& row : thinnings.at(id).places.rows())
      add_position(row, site, rover.position);
    rover.position.finish();
    for (auto& [name, series] : rover.series) series.finish();
    rover.colour = web_colour(data.rovers.size());
    data.rovers.push_back(std::move(rover));
  }
}

ReportRover* find_rover(ReportData& data, const std::string& id) {
  const auto found = std::ranges::find(data.rovers, id, &ReportRover::id);
  return found == data.rovers.end() ? nullptr : &*found;
}

void read_planned(const LogReader& log, const SiteFrame& site, ReportData& data) {
  const ShownRows paths = for_each_shown_path(log, [&](const PlannedPathRow& path) {
    if (ReportRover* rover = find_rover(data, path.rover_id)) {
      rover->planned.push_back(map_line(site, path.line));
    }
  });
  if (!paths.is_whole()) data.left_out.push_back(shown_text(paths, "planned paths"));
}

// Sight or link between two ends that is not over: since when, from rows of `pairs` after the last
// interval in the log.
struct OpenSight {
  struct Since {
    SimTime closed_until{-1};
    std::optional<SimTime> begin;

    void add(SimTime time, bool is_on) {
      if (time <= closed_until) return;
      if (!is_on) begin.reset();
      if (is_on && !begin) begin = time;
    }
  };
  Since visible, link;
  SimTime last{};
};

void read_pairs(const LogReader& log, ReportData& data) {
  std::map<std::pair<std::string, std::string>, ThinnedRows> distances;
  const ThinnedRows::Count count{log.pair_count(), 0};
  std::map<std::pair<std::string, std::string>, ReportPair> pairs;
  std::map<std::pair<std::string, std::string>, OpenSight> open;
  const auto add = [&](const std::string& from_id, const std::string& to_id, bool is_link,
                       SimTime begin, SimTime end) {
    ReportPair& pair = pairs[{from_id, to_id}];
    pair.from_id = from_id;
    pair.to_id = to_id;
    (is_link ? pair.link_s : pair.visible_s).emplace_back(seconds(begin), seconds(end));
  };
  ShownRows intervals;
  log.for_each_sight_interval([&](const SightIntervalRow& row) {
    const bool is_shown = ++intervals.in_log <= shown_intervals_max;
    if (is_shown) ++intervals.shown;
    if (row.kind == "hidden" || row.kind == "relayed") {
      if (!is_shown) return;
      ReportPair& pair = pairs[{row.from_id, row.to_id}];
      pair.from_id = row.from_id;
      pair.to_id = row.to_id;
      auto& spans_by = row.kind == "hidden" ? pair.hidden_s : pair.relayed_s;
      spans_by[row.by].emplace_back(seconds(row.start), seconds(row.end));
      return;
    }
    const bool is_link = row.kind == "link";
    if (is_shown) add(row.from_id, row.to_id, is_link, row.start, row.end);
    OpenSight& sight = open[{row.from_id, row.to_id}];
    (is_link ? sight.link : sight.visible).closed_until = row.end;
  });
  if (!intervals.is_whole()) {
    data.left_out.push_back(
        shown_text(intervals, "intervals in which rovers and Earth see each other, the first"));
  }
  log.for_each_pair([&](const PairRow& row) {
    OpenSight& sight = open[{row.from_id, row.to_id}];
    sight.visible.add(row.time, row.visible != 0);
    sight.link.add(row.time, row.link != 0);
    sight.last = row.time;
    if (!find_rover(data, row.from_id) || !find_rover(data, row.to_id)) return;
    const auto [at, is_new] =
        distances.try_emplace({row.from_id, row.to_id}, count, report_stretches, 1, 1);
    at->second.add(seconds(row.time), std::array{row.distance_m});
  });
  for (auto& [ids, series] : distances) {
    series.finish();
    data.distances.push_back({ids.first, ids.second, std::move(series)});
  }
  // Intervals that had not ended when the log did.
  for (const auto& [ids, sight] : open) {
    const auto& [visible, link, last] = sight;
    if (visible.begin) add(ids.first, ids.second, false, *visible.begin, last);
    if (link.begin) add(ids.first, ids.second, true, *link.begin, last);
  }
  for (auto& [ids, pair] : pairs) data.pairs.push_back(std::move(pair));
}

}  // namespace

ReportScope::ReportScope() {
  for (const Quantity& quantity : lsos::quantities()) {
    if (quantity.is_plotted) quantities.push_back(&quantity);
  }
}

ReportRover::ReportRover(const std::string& rover_id, const SampleTotals& totals,
                         const ReportScope& scope)
    : id(rover_id),
      samples(totals.rows),
      position({scope.places_max, 0}, static_cast<int>(scope.places_max), position_columns, 2) {
  for (const Quantity* quantity : scope.quantities) {
    series.emplace_back(quantity->name,
                        ThinnedRows({totals.rows, totals.moving}, scope.stretches, 1, 1));
  }
}

std::string web_colour(std::size_t place) {
  const std::string_view bgr = rover_colors[place % rover_colors.size()];
  return fmt::format("#{}{}{}", bgr.substr(4, 2), bgr.substr(2, 2), bgr.substr(0, 2));
}

SiteFrame site_of(const LogReader& log, const Plan& plan) {
  LSOS_ASSERT(plan.mission.planet != nullptr);
  std::optional<SampleRow> first;
  log.for_each_sample([&](const SampleRow& row) {
    if (!first || (row.time == first->time && row.rover_id < first->rover_id)) first = row;
  });
  if (!first) return SiteFrame(*plan.mission.planet, {});
  if (plan.rovers.empty()) return SiteFrame(*plan.mission.planet, first->place);
  // The plan does not say its height, which a sample's two places do. Each turn leaves a part of
  // the error that is as small as the height beside the body's radius.
  Geodetic origin = site_of(plan);
  origin.height_m = 0;
  for (int turn = 0; turn < 3; ++turn) {
    const SiteFrame site(*plan.mission.planet, origin);
    origin.height_m += first->place.height_m - site.geodetic(first->p_S_m).height_m;
  }
  return SiteFrame(*plan.mission.planet, origin);
}

void add_drawn(const Plan& plan, const SiteFrame& site, ReportData& data) {
  for (const PlanRover& planned : plan.rovers) {
    if (ReportRover* rover = find_rover(data, planned.id)) rover->type = planned.type;
  }
  for (const PlanEvent& event : plan.events) {
    ReportRover* rover = find_rover(data, event.rover_id);
    if (rover == nullptr || event.geometry.points.size() < 2) continue;
    ReportLine line = map_line(site, event.geometry.points);
    if (event.geometry.kind == GeometryKind::polygon) line.push_back(line.front());
    rover->drawn.push_back(std::move(line));
    for (const std::vector<Geodetic>& hole : event.geometry.holes) {
      rover->drawn.push_back(map_line(site, hole));
      rover->drawn.back().push_back(rover->drawn.back().front());
    }
  }
  for (const PlanAsset& asset : plan.assets) {
    data.assets.push_back({asset.id, asset.type, map_point(site, asset.position)});
  }
}

ReportData read_report_data(const LogReader& log, const Plan& plan, const SiteFrame& site,
                            const ReportScope& scope) {
  ReportData data;
  data.stretches = scope.stretches;
  for (const Quantity* quantity : scope.quantities) data.quantities.emplace_back(quantity->name);
  data.start = log.start();
  data.end_s = seconds(log.last_sample_time());
  data.run = log.run();
  data.events = log.events();
  data.activities = plan.activities;
  std::ranges::sort(data.events, {}, [](const EventRow& event) {
    return std::pair(event.rover_id, event.sequence);
  });
  read_samples(log, site, scope, data);
  add_drawn(plan, site, data);
  read_planned(log, site, data);
  data.notes = thinned_notes(log);
  read_pairs(log, data);
  return data;
}

}  // namespace lsos
