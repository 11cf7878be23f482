#include "product/qgis_style.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "picture/rover_colors.h"
#include "product/qgis_symbol.h"

namespace lsos {

namespace {

struct Symbol {
  std::string value, label;
  QgisOptions options, properties;
};

// A renderer with one symbol per value of a column. `last`: an expression; features for which it is
// 1 are drawn over all others; "": none.
std::string categories(std::string_view column, const std::vector<Symbol>& symbols, bool is_line,
                       const std::string& last = "") {
  std::string values, drawn;
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    const Symbol& symbol = symbols[i];
    values += fmt::format(R"(<category value="{}" symbol="{}" label="{}" render="true"/>)",
                          xml_escaped(symbol.value), i, xml_escaped(symbol.label));
    drawn +=
        qgis_symbol(is_line ? "line" : "marker", std::to_string(i),
                    {{is_line ? "SimpleLine" : "SimpleMarker", symbol.options, symbol.properties}});
  }
  const std::string order =
      last.empty()
          ? ""
          : fmt::format(R"(<orderby><orderByClause asc="1" nullsFirst="1">{}</orderByClause>)"
                        "</orderby>",
                        xml_escaped(last));
  return fmt::format(
      R"(<renderer-v2 type="categorizedSymbol" attr="{}" symbollevels="0" enableorderby="{}" )"
      R"(forceraster="0"><categories>{}</categories><symbols>{}</symbols>{}</renderer-v2>)",
      column, last.empty() ? 0 : 1, values, drawn, order);
}

// "255,0,0,255" from KML's "0000ff".
std::string color_of(std::size_t rover) {
  const std::string_view bgr = rover_colors[rover % rover_colors.size()];
  const auto part = [&](std::size_t at) {
    return std::stoi(std::string(bgr.substr(at, 2)), nullptr, 16);
  };
  return fmt::format("{},{},{},255", part(4), part(2), part(0));
}

std::vector<Symbol> by_rover(const std::vector<std::string>& rovers, const QgisOptions& options,
                             const std::string& color_option, const QgisOptions& properties = {}) {
  std::vector<Symbol> symbols;
  for (std::size_t i = 0; i < rovers.size(); ++i) {
    Symbol symbol{rovers[i], rovers[i], options, properties};
    symbol.options.emplace_back(color_option, color_of(i));
    symbols.push_back(std::move(symbol));
  }
  return symbols;
}

// Small triangles along the drive that point where the rover heads.
std::string samples(const std::vector<std::string>& rovers) {
  const QgisOptions options{{"name", "arrow"},       {"size", "2.6"}, {"size_unit", "MM"},
                            {"outline_style", "no"}, {"angle", "0"},  {"scale_method", "diameter"}};
  return categories("rover_id",
                    by_rover(rovers, options, "color", {{"angle", "degrees(\"heading_rad\")"}}),
                    false);
}

std::string events() {
  struct Status {
    const char *name, *shape, *color;
    const char* size_mm = "3.4";
  };
  constexpr std::array statuses{Status{"completed", "circle", "0,150,60,255"},
                                Status{"failed", "cross_fill", "170,0,60,255", "5.4"},
                                Status{"incomplete", "half_square", "255,140,0,255"},
                                Status{"skipped", "diamond", "150,150,150,255"},
                                Status{"not_started", "circle", "255,255,255,255"}};
  std::vector<Symbol> symbols;
  for (const Status& status : statuses) {
    symbols.push_back({status.name,
                       status.name,
                       {{"name", status.shape},
                        {"size", status.size_mm},
                        {"size_unit", "MM"},
                        {"color", status.color},
                        {"outline_color", "255,255,255,255"},
                        {"outline_width", "0.3"}},
                       {}});
  }
  return categories("status", symbols, false, "if(\"status\" = 'completed', 0, 1)");
}

std::string notes_style() {
  const std::string warns_red =
      R"(if("name" = 'warn_when', color_rgb(215, 25, 28), color_rgb(255, 255, 255)))";
  return qgis_single_symbol(qgis_symbol("marker", "0",
                                        {{"SimpleMarker",
                                          {{"name", "square"},
                                           {"size", "1.6"},
                                           {"color", "255,255,255,255"},
                                           {"outline_color", "60,60,60,255"}},
                                          {{"fillColor", warns_red}}}}));
}

// One label per place, with the texts of all its features.
std::string label(std::string_view column) {
  const std::string place = "round($x, 4) || ',' || round($y, 4)";
  const std::string together = fmt::format(
      R"(if($id = minimum($id, group_by:={1}), concatenate("{0}", group_by:={1}, concatenator:=' / '), NULL))",
      column, place);
  return qgis_labeling(together, QgisPlacement::about_points);
}

// Times at which a feature is shown under the time slider: from `start` on, until `end` if given.
std::string temporal(std::string_view start, std::string_view end) {
  constexpr int from_a_moment = 1, between_moments = 2;
  return fmt::format(
      R"(<temporal enabled="1" mode="{}" startField="{}" endField="{}" durationField="" )"
      R"(durationUnit="min" fixedDuration="0" accumulate="{}" startExpression="" endExpression="" )"
      R"(limitMode="0"><fixedRange><start/><end/></fixedRange></temporal>)",
      end.empty() ? from_a_moment : between_moments, start, end, end.empty() ? 1 : 0);
}

}  // namespace

std::vector<QgisLayer> qgis_layers(const std::vector<std::string>& rovers) {
  const QgisOptions path{{"line_width", "0.5"}, {"line_width_unit", "MM"}, {"line_style", "dash"}};
  return {
      // Events are drawn by their status, which is known from their end on.
      {"events", "Events", "Point", events(), label("label"), temporal("end_utc", "")},
      {"notes", "Notes", "Point", notes_style(), label("name"), "", false},
      {"samples", "Samples", "Point", samples(rovers), "", temporal("utc", "")},
      {"planned_paths", "Planned paths", "Line",
       categories("rover_id", by_rover(rovers, path, "line_color"), true), "", ""},
  };
}

std::string qgis_style(const QgisLayer& layer) {
  return fmt::format(
      "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
      R"(<qgis version="3.22" styleCategories="Symbology|Labeling|Temporal" labelsEnabled="{}">)"
      "{}{}{}</qgis>\n",
      layer.labeling.empty() ? 0 : 1, layer.temporal, layer.renderer, layer.labeling);
}

std::string rover_qgis_color(std::size_t rover, int opacity) {
  const std::string opaque = color_of(rover);
  return fmt::format("{}{}", opaque.substr(0, opaque.rfind(',') + 1), opacity);
}

}  // namespace lsos
