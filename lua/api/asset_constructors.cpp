// lsos.asset: a thing that stands on the ground and is no rover.
#include <fmt/format.h>

#include "lua/api/constructors.h"
#include "lua/api/power_constructors.h"
#include "lua/api/rover_constructors.h"
#include "mission/model/rover_model.h"

namespace lsos {

namespace {

void read_asset(TableReader& t, AssetModel& asset) {
  std::string name;
  t.api_version();
  t.text(optional, "name", name, "The file's name, for readers; nothing else is allowed.");
  t.text(required, "doc", asset.doc, "One sentence that a mission planner understands.");
  t.number(optional, "antenna_height_m", asset.antenna_height_m, not_negative,
           "Above the ground, when the plan gives no Height (default 0).");
  t.number(optional, "antenna_range_max_m", asset.antenna_range_max_m, positive,
           "How far it links to rovers and assets (default no limit).");
  t.boolean(optional, "reaches_earth", asset.reaches_earth, "Links to Earth too (default true).");
  t.number(optional, "supply_w", asset.supply_w, not_negative,
           "Power that it can give, besides that of its panels (default 0).");
  read_panels(t, asset.panels);
  read_shapes(t, asset.shapes);
  t.texts(optional, "assumptions", asset.assumptions,
          "Sentences about numbers that have no source; they go into summary.json.");
  if (t.L() == nullptr) return;
  asset.name = script_name(t.place().file);
  asset.place = t.place();
  if (!name.empty() && name != asset.name) {
    t.fault(fmt::format("name = '{}': must be '{}', the name of the file", name, asset.name));
  }
  for (const Shape& shape : asset.shapes) {
    if (!shape.part.empty()) {
      t.fault(fmt::format("shapes: part = '{}': an asset has no parts that move", shape.part));
    }
  }
}

}  // namespace

std::vector<Constructor> asset_constructors() {
  return {constructor<AssetModel, read_asset>(
      asset_kind, "What a script in rovers/ returns of a thing that does not drive.")};
}

}  // namespace lsos
