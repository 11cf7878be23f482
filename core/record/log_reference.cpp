#include "record/log_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/error.h"
#include "record/column_titles.h"
#include "record/layers.h"

namespace lsos {

namespace {

constexpr std::string_view head = R"(# The log

A run leaves `log.gpkg`, a GeoPackage: QGIS opens it, `sqlite3` and `pandas.read_sql` read its tables,
`geopandas.read_file(file, layer='samples')` its places. Numbers are SI, and a column's name says its
unit; a quantity that the rover has no part for is NULL. `time_s` counts from the mission's StartTime.
GIS tools show the titles in place of the names.
)";

struct LayerText {
  std::string_view layer, text;
};
constexpr std::array layer_texts{
    LayerText{"samples",
              "One rover at one time: every LogInterval while it moves, every "
              "ParkedLogInterval while it stands, and at each change between the two."},
    LayerText{"events", "One event of the plan, with what came of it."},
    LayerText{"phases", "One phase of an event, when it ends."},
    LayerText{"pairs", "What one rover, asset or Earth sees of another at one time."},
    LayerText{"sight_intervals", "How long one end saw another or did not, or was joined to it."},
    LayerText{"panels", "What the Sun did for one panel."},
    LayerText{"joints", "One joint or mast of a rover."},
    LayerText{"resources", "What is left of a resource."},
    LayerText{"planned_paths", "One leg of a planned route, when it was planned."},
    LayerText{"notes", "What events log: findings, decisions, prints."},
    LayerText{"run", "What the run was made of, a row a key."},
};

const char* type_text(ColumnType type) {
  switch (type) {
    case ColumnType::integer:
      return "integer";
    case ColumnType::real:
      return "number";
    case ColumnType::text:
      return "text";
    case ColumnType::utc:
      return "UTC text";
  }
  return "";
}

const char* geometry_text(LayerGeometry geometry) {
  switch (geometry) {
    case LayerGeometry::point:
      return " Points.";
    case LayerGeometry::line:
      return " Lines.";
    case LayerGeometry::none:
      break;
  }
  return "";
}

}  // namespace

std::string log_reference() {
  std::string text(head);
  for (const LayerSpec& layer : contract_layers()) {
    const auto* const about = std::ranges::find(layer_texts, layer.name, &LayerText::layer);
    LSOS_ASSERT(about != layer_texts.end());
    text += fmt::format("\n## `{}`\n\n{}{}\n\n| column | type | title | |\n|---|---|---|---|\n",
                        layer.name, about->text, geometry_text(layer.geometry));
    for (const ColumnSpec& column : layer.columns) {
      const ColumnTitle title = column_title(layer.name, column.name);
      text += fmt::format("| `{}` | {} | {} | {} |\n", column.name, type_text(column.type),
                          title.title, title.meaning);
    }
  }
  return text;
}

}  // namespace lsos
