#include "product/study/study_json.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "product/column_json.h"
#include "product/packed_numbers.h"
#include "product/study/histogram.h"
#include "product/study/quantiles.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;
using Kind = StudyColumn::Kind;

std::string floats(const std::vector<double>& values) { return packed<float>(values); }

double to_centimetres(double length_m) { return std::round(length_m * 100) / 100; }

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

// Values in 16 bits between the least and the greatest; the last number stands for none. The step
// is at most 1/65534 of their range, finer than any plot.
Json in_16_bits(const std::vector<double>& values) {
  constexpr double steps = 65534, none = 65535;
  double low = 1e300, high = -1e300;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) return nullptr;
  const double step = high > low ? (high - low) / steps : 1;
  std::vector<double> numbers;
  numbers.reserve(values.size());
  for (const double value : values) {
    numbers.push_back(std::isfinite(value) ? (value - low) / step : none);
  }
  return {{"low", low}, {"step", step}, {"v", packed<std::uint16_t>(numbers)}};
}

Json ellipse_json(const std::optional<SpreadEllipse>& ellipse) {
  if (!ellipse) return nullptr;
  return {{"x_m", ellipse->centre_m.x()},          {"y_m", ellipse->centre_m.y()},
          {"semi_major_m", ellipse->semi_major_m}, {"semi_minor_m", ellipse->semi_minor_m},
          {"angle_rad", ellipse->angle_rad},       {"cases", ellipse->cases}};
}

Json band_json(const std::optional<BandValues>& band) {
  if (!band) return nullptr;
  return Json::array({band->p5, band->p50, band->p95});
}

void add_place(Json& json, const std::optional<Geodetic>& place, const SiteFrame& site) {
  if (!place) return;
  const Vec3 p_S_m = site.p_S_m({place->lon_rad, place->lat_rad, site.origin().height_m});
  json["x_m"] = to_centimetres(p_S_m.x());
  json["y_m"] = to_centimetres(p_S_m.y());
}

// Every so many of them, so that a page has about a thousand.
std::vector<double> thinned(const std::vector<double>& values) {
  constexpr std::size_t values_max = 1000;
  const std::size_t stride =
      std::max<std::size_t>(1, (values.size() + values_max - 1) / values_max);
  std::vector<double> kept;
  for (std::size_t i = 0; i < values.size(); i += stride) kept.push_back(values[i]);
  return kept;
}

// Ellipses of one rover over time; NaN where too few cases are under way.
Json spreads_json(const RoverCourses& courses) {
  std::vector<double> x_m, y_m, semi_major_m, semi_minor_m, angle_rad;
  for (const PlaceSpread& spread : courses.spreads) {
    const auto ellipse = spread.ellipse();
    x_m.push_back(ellipse ? ellipse->centre_m.x() : not_modelled);
    y_m.push_back(ellipse ? ellipse->centre_m.y() : not_modelled);
    semi_major_m.push_back(ellipse ? ellipse->semi_major_m : not_modelled);
    semi_minor_m.push_back(ellipse ? ellipse->semi_minor_m : not_modelled);
    angle_rad.push_back(ellipse ? ellipse->angle_rad : not_modelled);
  }
  return {{"interval_s", courses.spread_interval_s},
          {"x_m", floats(x_m)},
          {"y_m", floats(y_m)},
          {"semi_major_m", floats(semi_major_m)},
          {"semi_minor_m", floats(semi_minor_m)},
          {"angle_rad", floats(angle_rad)}};
}

}  // namespace

Json table_json(const StudyResults& results, std::size_t shown) {
  Json columns = Json::array();
  for (std::size_t i = 0; i < results.columns.size(); ++i) {
    const StudyColumn& column = results.columns[i];
    if (column.kind == Kind::machine || column.name == "log_sha256") continue;
    Json values = Json::array();
    for (std::size_t k = 0; k < shown; ++k) values.push_back(json_value(results.cases[k][i]));
    columns.push_back({{"name", column.name},
                       {"kind", to_string(column.kind)},
                       {"unit", column.unit},
                       {"sentence", column.sentence},
                       {"is_text", column.type == ColumnType::text},
                       {"values", std::move(values)}});
  }
  return columns;
}

Json outcomes_json(const StudyResults& results) {
  const std::vector<std::string> statuses = results.texts(results.column("status"));
  const std::vector<std::string> reasons = results.texts(results.column("reason"));
  const std::vector<double> numbers = results.numbers(results.column("case"));
  std::map<std::pair<std::string, std::string>, std::vector<std::int64_t>> found;
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    found[{statuses[i], reasons[i]}].push_back(std::llround(numbers[i]));
  }
  std::vector<std::pair<std::string, std::string>> order;
  for (const auto& [outcome, cases] : found) order.push_back(outcome);
  std::ranges::stable_sort(order, std::greater<>(),
                           [&](const auto& outcome) { return found[outcome].size(); });
  Json outcomes = Json::array();
  for (const auto& outcome : order) {
    outcomes.push_back(
        {{"status", outcome.first}, {"reason", outcome.second}, {"cases", found[outcome]}});
  }
  return outcomes;
}

Json bands_json(const StudyResults& results) {
  Json bands = Json::array();
  for (const StudyBand& band : results.bands) {
    bands.push_back({{"rover_id", band.rover_id},
                     {"quantity", band.quantity},
                     {"t", packed<double>(thinned(band.times_s))},
                     {"p5", floats(thinned(band.p5))},
                     {"p50", floats(thinned(band.p50))},
                     {"p95", floats(thinned(band.p95))},
                     {"share_reached", floats(thinned(band.share_reached))}});
  }
  return bands;
}

Json arrivals_json(const StudyResults& results, const CaseCourses& courses, const SiteFrame& site) {
  Json arrivals = Json::array();
  for (std::size_t i = 0; i < results.arrivals.size(); ++i) {
    const StudyArrival& arrival = results.arrivals[i];
    const EventPlaces& ended = courses.events[i];
    Json json{{"rover_id", arrival.rover_id},
              {"sequence", arrival.sequence},
              {"type", arrival.type},
              {"label", arrival.label},
              {"share_reached", arrival.share_reached},
              {"cases", arrival.cases},
              {"end_s", band_json(arrival.end_s)},
              {"charge", band_json(arrival.charge)},
              {"ellipse", ellipse_json(ended.spread.ellipse())},
              {"ended_s", floats(ended.ended_s)}};
    add_place(json, arrival.place, site);
    arrivals.push_back(std::move(json));
  }
  return arrivals;
}

Json ends_json(const StudyResults& results, const SiteFrame& site) {
  Json ends = Json::array();
  for (const StudyEnd& end : results.ends) {
    Json json{{"case", end.number},
              {"rover_id", end.rover_id},
              {"sequence", end.sequence},
              {"label", end.label},
              {"time_s", number_or_null(end.time_s)},
              {"status", end.status},
              {"reason", end.reason}};
    add_place(json, end.place, site);
    ends.push_back(std::move(json));
  }
  return ends;
}

Json courses_json(const CaseCourses& courses) {
  Json rovers = Json::array();
  for (const RoverCourses& of : courses.rovers) {
    rovers.push_back({{"rover_id", of.rover_id},
                      {"interval_s", of.interval_s},
                      {"times", of.times},
                      {"spreads", spreads_json(of)},
                      {"x_m", in_16_bits(of.x_m)},
                      {"y_m", in_16_bits(of.y_m)},
                      {"charge", in_16_bits(of.charge)},
                      {"distance_m", in_16_bits(of.distance_m)}});
  }
  return rovers;
}

Json numbers_json(const StudyResults& results, const std::vector<StudyNumber>& numbers) {
  std::vector<bool> is_completed;
  for (const std::string& status : results.texts(results.column("status"))) {
    is_completed.push_back(status == "completed");
  }
  Json all = Json::array();
  for (const StudyNumber& number : numbers) {
    std::vector<double> values = number.values;
    const Quantiles found = quantiles_of(values);
    Json bars = Json::array();
    for (const HistogramBar& bar : histogram(number.values, is_completed)) {
      bars.push_back({bar.from, bar.to, bar.completed, bar.other});
    }
    all.push_back(
        {{"name", number.name},
         {"column", number.column ? Json(results.columns[*number.column].name) : Json(nullptr)},
         {"kind", number.column ? to_string(results.columns[*number.column].kind) : ""},
         {"unit", number.unit},
         {"sentence", number.sentence},
         {"count", found.count},
         {"missing", number.values.size() - found.count},
         {"quantiles",
          found.count > 0 ? Json::array({found.p5, found.p50, found.p95}) : Json(nullptr)},
         {"bars", bars}});
  }
  return all;
}

Json influence_json(const Influence& found) {
  Json rows = Json::array();
  for (const auto& row : found.cells) {
    Json cells = Json::array();
    for (const InfluenceCell& cell : row) {
      Json json{{"rho", nullptr}, {"p", nullptr}, {"is_found", cell.is_found}, {"share", nullptr}};
      if (cell.correlation) {
        json["rho"] = cell.correlation->rho;
        json["p"] = number_or_null(cell.correlation->p);
        json["cases"] = cell.correlation->cases;
      }
      if (cell.share) {
        json["share"] = cell.share->share;
        json["share_p"] = cell.share->p;
        json["is_share_found"] = cell.is_share_found;
        json["classes"] = cell.share->classes;
      }
      cells.push_back(std::move(json));
    }
    rows.push_back(std::move(cells));
  }
  return rows;
}

}  // namespace lsos
