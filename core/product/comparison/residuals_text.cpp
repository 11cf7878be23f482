#include "product/comparison/residuals_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "product/comparison/text_table.h"
#include "product/quantity_text.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;

constexpr int digits = 4;  // no instrument measures more of a residual

std::string heading_of(const ResidualSummary& summary) {
  switch (summary.span) {
    case ResidualSummary::Span::all:
      return fmt::format("rover {}, all along", summary.rover_id);
    case ResidualSummary::Span::event:
      return fmt::format("event {}/{} {}", summary.rover_id, summary.sequence, summary.label);
    case ResidualSummary::Span::between:
      return fmt::format("rover {}, between events", summary.rover_id);
  }
  return "";
}

// Rows by event, with all quantities of it beneath each other.
std::vector<std::pair<std::string, std::vector<Cells>>> blocks(const Residuals& found) {
  std::vector<std::pair<std::string, std::vector<Cells>>> all;
  for (const ResidualSummary& summary : found.summaries) {
    const std::string heading = heading_of(summary);
    auto block = std::ranges::find(all, heading, [](const auto& each) { return each.first; });
    if (block == all.end()) {
      all.push_back({heading, {{"", "count", "mean", "rms", "greatest", "at"}}});
      block = std::prev(all.end());
    }
    const ResidualStatistics& of = summary.statistics;
    const std::string& name = summary.quantity;
    if (of.count == 0) {
      block->second.push_back({name, "0", "-", "-", "-", "-"});
      continue;
    }
    block->second.push_back({name, std::to_string(of.count), change_text(name, of.mean, digits),
                             quantity_text(name, of.rms, digits),
                             change_text(name, of.greatest, digits),
                             clock_text(from_seconds(of.greatest_s))});
  }
  return all;
}

std::string name_of(ResidualSummary::Span span) {
  switch (span) {
    case ResidualSummary::Span::all:
      return "all";
    case ResidualSummary::Span::event:
      return "event";
    case ResidualSummary::Span::between:
      return "between events";
  }
  return "";
}

}  // namespace

nlohmann::ordered_json summaries_json(const Residuals& found) {
  Json array = Json::array();
  for (const ResidualSummary& summary : found.summaries) {
    const ResidualStatistics& of = summary.statistics;
    const bool is_event = summary.span == ResidualSummary::Span::event;
    const auto unless_empty = [&](double value) { return of.count > 0 ? Json(value) : Json(); };
    array.push_back({{"rover_id", summary.rover_id},
                     {"during", name_of(summary.span)},
                     {"sequence", is_event ? Json(summary.sequence) : Json()},
                     {"label", is_event ? Json(summary.label) : Json()},
                     {"quantity", summary.quantity},
                     {"count", of.count},
                     {"mean", unless_empty(of.mean)},
                     {"rms", unless_empty(of.rms)},
                     {"greatest", unless_empty(of.greatest)},
                     {"greatest_time_s", unless_empty(of.greatest_s)}});
  }
  return array;
}

std::string to_json(const Residuals& found, const Telemetry& telemetry, const std::string& run) {
  Json unusable = Json::array();
  for (const Unusable& each : telemetry.unusable) {
    unusable.push_back({{"line", each.line}, {"what", each.what}});
  }
  Json without = Json::array();
  for (const ResidualSeries& series : found.series) {
    if (series.without_simulated == 0) continue;
    without.push_back({{"rover_id", series.rover_id},
                       {"quantity", series.quantity},
                       {"count", series.without_simulated}});
  }
  const Json document = {{"run", run},
                         {"telemetry", telemetry.file},
                         {"residual", "measured - simulated"},
                         {"interpolation", "linear in time between samples"},
                         {"rows", telemetry.rows},
                         {"rows_used", telemetry.rows_used},
                         {"residuals", summaries_json(found)},
                         {"without_simulated", without},
                         {"unusable", unusable}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_text(const Residuals& found, const Telemetry& telemetry, const std::string& run) {
  std::string text = fmt::format(
      "{} against {}: {} of {} rows used\nmeasured - simulated, interpolated linearly in time "
      "between samples\n",
      telemetry.file, run, telemetry.rows_used, telemetry.rows);
  if (!found.places.empty()) {
    text += "place along: ahead of the simulated place on its track; across: to the left of it\n";
  }
  for (const ResidualSeries& series : found.series) {
    if (series.without_simulated == 0) continue;
    text += fmt::format("{}, {}: {} of {} measured values have none in the log to be set against\n",
                        series.rover_id, series.quantity, series.without_simulated,
                        series.without_simulated + series.residuals.size());
  }
  for (const auto& [heading, rows] : blocks(found)) {
    text += fmt::format("\n{}\n{}", heading, text_table(rows));
  }
  return text;
}

}  // namespace lsos
