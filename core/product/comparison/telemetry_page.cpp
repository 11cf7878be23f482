#include "product/comparison/telemetry_page.h"

#include <algorithm>
#include <array>

#include "product/comparison/residuals_text.h"
#include "product/report_document.h"
#include "product/report_map.h"
#include "product/report_page.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;

const MeasuredQuantity* quantity_named(const Telemetry& telemetry, const std::string& name) {
  const auto found = std::ranges::find(
      telemetry.quantities, name, [](const MeasuredQuantity* quantity) { return quantity->name; });
  return found == telemetry.quantities.end() ? nullptr : *found;
}

// Thinned as the run's curves are, so that a million rows can be shown.
Json series_json(const ResidualSeries& series, const Telemetry& telemetry) {
  const MeasuredQuantity* const quantity = quantity_named(telemetry, series.quantity);
  ThinnedRows rows({series.residuals.size(), 0}, report_stretches, 2, 2);
  for (const Residual& one : series.residuals) {
    // Angles lie beside the curve, whatever turn they were measured in.
    const bool is_angle = quantity != nullptr && quantity->is_angle();
    const double measured = is_angle ? one.simulated + one.residual : one.measured;
    rows.add(one.time_s, std::array{measured, one.residual});
  }
  rows.finish();
  return {{"rover_id", series.rover_id},
          {"quantity", series.quantity},
          {"title", series.title},
          {"kind", quantity != nullptr ? quantity->unit->kind : "length"},
          {"count", series.residuals.size()},
          {"measured", packed_series(rows, 0)},
          {"residual", packed_series(rows, 1)}};
}

Json places_json(const std::string& rover_id, const std::vector<MeasuredPlace>& places,
                 const SiteFrame& site) {
  ThinnedRows rows({places.size(), 0}, report_stretches, 2, 2);
  for (const MeasuredPlace& place : places) {
    const Vec3 p_S_m =
        site.p_S_m(geodetic_from_degrees(place.lon_deg, place.lat_deg, site.origin().height_m));
    rows.add(place.time_s, std::array{p_S_m.x(), p_S_m.y()});
  }
  rows.finish();
  return {{"rover_id", rover_id}, {"x", packed_series(rows, 0)}, {"y", packed_series(rows, 1)}};
}

Json telemetry_json(const Telemetry& telemetry, const Residuals& found, const SiteFrame& site) {
  Json unusable = Json::array();
  for (const Fault& fault : faults_of(telemetry, Severity::error)) {
    unusable.push_back(to_string(fault));
  }
  Json series = Json::array(), places = Json::array();
  for (const ResidualSeries& each : found.series) series.push_back(series_json(each, telemetry));
  for (const auto& [id, measured] : found.places) {
    places.push_back(places_json(id, measured, site));
  }
  return {{"file", telemetry.file},
          {"rows", telemetry.rows},
          {"rows_used", telemetry.rows_used},
          {"unusable", unusable},
          {"residuals", summaries_json(found)},
          {"series", series},
          {"places", places}};
}

}  // namespace

std::string telemetry_page(const PictureRun& run, const LogReader& log, const std::string& summary,
                           const Telemetry& telemetry, const Residuals& found,
                           const ReportRequest& request, const std::vector<std::string>& left_out) {
  const Plan& plan = run.files.plan;
  const SiteFrame site = run.ground ? run.ground->site() : site_of(log, plan);
  ReportScope scope;
  for (const MeasuredQuantity* quantity : telemetry.quantities) {
    const bool is_new = quantity->logged != nullptr && !quantity->logged->is_plotted;
    if (is_new) scope.quantities.push_back(quantity->logged);
  }
  const ReportData data = read_report_data(log, plan, site, scope);
  ReportExtras extras;
  if (run.ground) extras.map = report_map(*run.ground, data, request.shadow_at, request.threads);
  extras.batteries = report_batteries(run.files);
  extras.left_out = left_out;
  Json document = report_document(data, plan, site, summary, extras);
  document["telemetry"] = telemetry_json(telemetry, found, site);
  return report_page(document, PageKind::telemetry);
}

}  // namespace lsos
