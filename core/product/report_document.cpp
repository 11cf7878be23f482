#include "product/report_document.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/base64.h"
#include "base/units.h"
#include "product/column_json.h"
#include "product/event_kinds.h"
#include "product/packed_numbers.h"
#include "record/columns.h"
#include "record/json_text.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;

std::string times(const ThinnedRows& rows) { return packed<double>(rows.times_s(), 1); }
std::string numbers(const ThinnedRows& rows, std::size_t column) {
  return packed<float>(rows.column(column), 1);
}

Json series(const ThinnedRows& rows) { return packed_series(rows, 0); }

Json line(const ReportLine& points) {
  Json flat = Json::array();
  for (const ReportPoint& point : points) {
    flat.push_back(std::round(point.x_m * 100) / 100);
    flat.push_back(std::round(point.y_m * 100) / 100);
  }
  return flat;
}

Json lines_json(const std::vector<ReportLine>& all) {
  Json array = Json::array();
  for (const ReportLine& points : all) array.push_back(line(points));
  return array;
}

Json position(const ThinnedRows& rows) {
  // 1e-7 degrees are a centimetre on Earth.
  constexpr double per_degree = 1e7;
  return {{"t", times(rows)},
          {"x_m", numbers(rows, position_x)},
          {"y_m", numbers(rows, position_y)},
          {"lon_e7deg", packed<std::int32_t>(rows.column(position_lon_deg), per_degree)},
          {"lat_e7deg", packed<std::int32_t>(rows.column(position_lat_deg), per_degree)},
          {"heading_rad", numbers(rows, position_heading_rad)}};
}

Json battery(const ReportExtras& extras, const std::string& rover_id) {
  const auto found = extras.batteries.find(rover_id);
  if (found == extras.batteries.end()) return nullptr;
  return {{"capacity_j", found->second.capacity_j}, {"reserve_j", found->second.reserve_j}};
}

Json rovers(const ReportData& data, const ReportExtras& extras) {
  Json array = Json::array();
  for (const ReportRover& rover : data.rovers) {
    Json object = {{"id", rover.id},
                   {"type", rover.type},
                   {"colour", rover.colour},
                   {"samples", rover.samples},
                   {"shown", rover.position.times_s().size()},
                   {"last_s", rover.last_s},
                   {"distance_m", rover.distance_m},
                   {"battery", battery(extras, rover.id)},
                   {"drawn", lines_json(rover.drawn)},
                   {"planned", lines_json(rover.planned)},
                   {"position", position(rover.position)}};
    for (const auto& [name, rows] : rover.series) object[name] = series(rows);
    array.push_back(std::move(object));
  }
  return array;
}

// The object that a file of the run holds; null where it holds something else.
Json object_in(const std::string& text) {
  return is_json_object(text) ? Json::parse(text, nullptr, false) : Json();
}

// All columns of each row, and its position on the map.
template <class Row>
Json placed_rows(const std::vector<Row>& rows, const SiteFrame& site) {
  Json array = Json::array();
  for (const Row& row : rows) {
    Json object = Json::object();
    for (const Column<Row>& column : columns<Row>()) {
      object[std::string(column.name)] = json_value(column.value(row, {}));
    }
    if (const std::optional<Geodetic> place = row.place) {
      const Vec3 p_S_m = site.p_S_m(*place);
      object["x_m"] = std::round(p_S_m.x() * 100) / 100;
      object["y_m"] = std::round(p_S_m.y() * 100) / 100;
    }
    array.push_back(std::move(object));
  }
  return array;
}

// The notes, with their fields as an object.
Json notes_json(const ReportData& data, const SiteFrame& site) {
  Json array = placed_rows(data.notes.rows, site);
  for (Json& note : array) {
    const Json fields = note["fields"];
    note["fields"] = fields.is_string() ? Json::parse(fields.get<std::string>(), nullptr, false)
                                        : Json::object();
  }
  return array;
}

Json pairs(const ReportData& data) {
  const auto flat = [](const ReportPair::Spans& intervals) {
    Json array = Json::array();
    for (const auto& [start_s, end_s] : intervals) {
      array.push_back(start_s);
      array.push_back(end_s);
    }
    return array;
  };
  const auto by = [&](const std::map<std::string, ReportPair::Spans>& intervals) {
    Json object = Json::object();
    for (const auto& [what, spans] : intervals) object[what] = flat(spans);
    return object;
  };
  Json array = Json::array();
  for (const ReportPair& pair : data.pairs) {
    array.push_back({{"from", pair.from_id},
                     {"to", pair.to_id},
                     {"visible", flat(pair.visible_s)},
                     {"link", flat(pair.link_s)},
                     {"hidden", by(pair.hidden_s)},
                     {"relayed", by(pair.relayed_s)}});
  }
  return array;
}

Json distances(const ReportData& data) {
  Json array = Json::array();
  for (const ReportDistance& pair : data.distances) {
    array.push_back(
        {{"from", pair.from_id}, {"to", pair.to_id}, {"series", series(pair.distance_m)}});
  }
  return array;
}

std::string data_uri(const EmbeddedPicture& picture) {
  return "data:" + picture.mime + ";base64," + base64(picture.bytes);
}

Json map_of(const std::optional<ReportMap>& map) {
  if (!map) return nullptr;
  Json object = {{"left_m", map->left_m},
                 {"bottom_m", map->bottom_m},
                 {"right_m", map->right_m},
                 {"top_m", map->top_m},
                 {"lowest_m", map->lowest_m},
                 {"highest_m", map->highest_m},
                 {"missing_share", map->missing_share},
                 {"relief", data_uri(map->relief)},
                 {"shadow", nullptr}};
  if (map->shadow) {
    object["shadow"] = data_uri(*map->shadow);
    object["shadow_s"] = map->shadow_s;
    object["sunlit_share"] = map->sunlit_share;
    if (!std::isnan(map->ground_reaches_m)) {
      object["ground_reaches_m"] = map->ground_reaches_m;
      object["ground_matters_m"] = map->ground_matters_m;
    }
  }
  return object;
}

Json pictures_json(const std::vector<ReportPicture>& all) {
  Json array = Json::array();
  for (const ReportPicture& picture : all) {
    array.push_back({{"rover_id", picture.rover_id},
                     {"time_s", picture.time_s},
                     {"title", picture.title},
                     {"view", picture.view},
                     {"src", data_uri(picture.picture)}});
  }
  return array;
}

Json assets(const ReportData& data) {
  Json array = Json::array();
  for (const ReportAsset& asset : data.assets) {
    array.push_back({{"id", asset.id},
                     {"type", asset.type},
                     {"x_m", asset.place.x_m},
                     {"y_m", asset.place.y_m}});
  }
  return array;
}

Json kinds(const ReportData& data) {
  Json array = Json::array();
  for (const EventKind& kind : event_kinds(data.events, data.activities)) {
    array.push_back({{"name", kind.name}, {"colour", kind.colour}, {"types", kind.types}});
  }
  return array;
}

// The frame of the map, and the body's reference surface.
Json site_json(const SiteFrame& site) {
  return {{"lon_deg", lon_deg(site.origin())},
          {"lat_deg", lat_deg(site.origin())},
          {"height_m", site.origin().height_m},
          {"equatorial_radius_m", site.body().equatorial_radius_m},
          {"flattening", site.body().flattening}};
}

// Ends of leap seconds within the run, s after its start. Days in which UTC falls behind the
// elapsed time are bisected until the moment is found.
std::vector<double> leap_ends_s(Instant start, double end_s) {
  constexpr double day_s = 86400, rounding_s = 1e-5;
  // A run that starts within a leap second: counting begins a second earlier.
  const double start_shift_s = format_utc(start).find(":60") != std::string::npos ? 1 : 0;
  const double base_days = utc_days(start + from_seconds(-start_shift_s));
  const auto utc_lag_s = [&](double time_s) {
    return time_s + start_shift_s - (utc_days(start + from_seconds(time_s)) - base_days) * day_s;
  };
  std::vector<double> ends_s;
  for (double from_s = 0; from_s < end_s; from_s += day_s) {
    double low_s = from_s, high_s = std::min(from_s + day_s, end_s);
    const double wanted_s = std::floor(utc_lag_s(from_s) + rounding_s) + 1 - rounding_s;
    if (utc_lag_s(high_s) < wanted_s) continue;
    while (high_s - low_s > rounding_s) {
      const double middle_s = (low_s + high_s) / 2;
      (utc_lag_s(middle_s) < wanted_s ? low_s : high_s) = middle_s;
    }
    ends_s.push_back(std::round(high_s * 1e3) / 1e3);
  }
  return ends_s;
}

}  // namespace

nlohmann::ordered_json packed_series(const ThinnedRows& rows, std::size_t column) {
  if (!rows.has_values(column)) return nullptr;
  return {{"t", times(rows)}, {"v", numbers(rows, column)}};
}

nlohmann::ordered_json report_document(const ReportData& data, const Plan& plan,
                                       const SiteFrame& site, const std::string& summary,
                                       const ReportExtras& extras) {
  Json parsed = object_in(summary);
  if (parsed.is_object()) parsed.erase("events");  // the page takes them from the log
  Json estimate = object_in(extras.estimate);
  return {
      {"plan", plan.file},
      {"body", std::string(plan.mission.planet->name)},
      {"start_utc", format_utc(data.start)},
      {"end_utc", format_utc(data.start + from_seconds(data.end_s))},
      {"end_s", data.end_s},
      {"leap_ends_s", leap_ends_s(data.start, data.end_s)},
      {"terrain", plan.mission.terrain.name},
      {"site", site_json(site)},
      {"summary", parsed},
      {"estimate", estimate},
      {"quantities", data.quantities},
      {"rovers", rovers(data, extras)},
      {"assets", assets(data)},
      {"events", placed_rows(data.events, site)},
      {"notes", notes_json(data, site)},
      {"notes_in_log", data.notes.in_log},
      {"kinds", kinds(data)},
      {"sight", pairs(data)},
      {"distances", distances(data)},
      {"map", map_of(extras.map)},
      {"pictures", pictures_json(extras.pictures)},
      {"left_out", extras.left_out},
      {"run", data.run},
      {"stretches", data.stretches},
  };
}

}  // namespace lsos
