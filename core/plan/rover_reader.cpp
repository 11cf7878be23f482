#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/visible_text.h"
#include "plan/geometry.h"
#include "plan/mission_reader.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// Rovers and assets share one set of ids. "Earth" is reserved for the planet in the log's pairs,
// "ground" for what hides a view.
void check_id(FieldReader& fields, const std::string& field_name, const std::string& id,
              IdPlaces& ids) {
  if (id == "Earth") fields.error(field_name, "this name stands for the planet in the log");
  if (id == "ground") fields.error(field_name, "this name stands for the ground in the log");
  if (id.find(',') != std::string::npos) {
    fields.error(field_name, "a comma is not allowed: it stands between ids in lists");
  }
  if (has_control_characters(id)) {
    fields.error(field_name, "line ends and other control characters are not allowed in an id");
  }
  const Place& place = fields.subject().place;
  const auto [first, is_new] = ids.emplace(id, place);
  if (!is_new) {
    fields.error(field_name,
                 fmt::format("is taken; the first is at {}", line_text(first->second, place.file)));
  }
}

std::vector<std::string> type_names(const Declarations& declarations, bool is_asset) {
  std::vector<std::string> names;
  for (const auto& [name, type] : declarations.rover_types) {
    if (type.is_asset == is_asset) names.push_back(name);
  }
  return names;
}

// The type of rover or asset of that name. When there is none, reports a fault and returns nullptr.
const Declarations::RoverType* find_type(FieldReader& fields, const std::string& field_name,
                                         const std::string& name, bool wants_asset,
                                         const Declarations& declarations) {
  const char* wanted = wants_asset ? "asset" : "rover";
  const auto found = declarations.rover_types.find(name);
  if (found != declarations.rover_types.end() && found->second.is_asset == wants_asset) {
    return &found->second;
  }
  if (const auto broken = declarations.broken_rovers.find(name);
      broken != declarations.broken_rovers.end()) {
    fields.add(broken->second);
    fields.error(field_name, "its script is broken");
    return nullptr;
  }
  const std::vector<std::string> names = type_names(declarations, wants_asset);
  if (found != declarations.rover_types.end()) {
    fields.error(field_name, fmt::format("is no {}; there are {}", wanted, listed(names)));
    return nullptr;
  }
  std::string hint = Suggestions(names)(name);
  if (hint.empty()) hint = fmt::format("; there are {}", listed(names));
  fields.error(field_name, fmt::format("there is no such {} type{}", wanted, hint));
  return nullptr;
}

void check_configuration(FieldReader& fields, const Declarations::RoverType& type,
                         const std::string& name) {
  const std::vector<std::string>& known = type.configurations;
  if (std::ranges::find(known, name) != known.end()) return;
  std::string hint = Suggestions(known)(name);
  if (hint.empty()) {
    hint = known.empty() ? "; it has none" : fmt::format("; there are {}", listed(known));
  }
  fields.error("RoverConfig", fmt::format("the rover has no such configuration{}", hint));
}

std::optional<Geodetic> read_position(const PlanPlacemark& ours, const FieldReader& fields,
                                      Faults& faults) {
  constexpr std::array wanted{GeometryKind::point};
  const auto geometry = read_geometry(*ours.placemark, wanted, fields.subject(), faults);
  if (!geometry) return {};
  return geometry->points.front();
}

std::string text_or_empty(const FieldValues& values, const std::string& key) {
  const auto* text = find_value<std::string>(values, key);
  return text == nullptr ? std::string() : *text;
}

struct DraftRover {
  PlanRover rover;
  std::vector<std::string> defaults;
};

DraftRover read_rover(const PlanPlacemark& ours, const ReadContext& context, IdPlaces& ids,
                      PlanGaps& gaps) {
  FieldReader fields(subject_of(ours, "RoverId", context), ours.data, context.faults);
  DraftRover draft;
  fields.check_names({rover_fields()});
  const FieldValues values = fields.read(rover_fields(), &draft.defaults);

  PlanRover& rover = draft.rover;
  rover.place = fields.subject().place;
  rover.id = text_or_empty(values, "rover_id");
  rover.type = text_or_empty(values, "rover_type");
  rover.configuration = text_or_empty(values, "rover_config");
  rover.variant = text_or_empty(values, "variant");
  if (rover.id.empty()) {
    gaps.rover_ids = true;
  } else {
    check_id(fields, "RoverId", rover.id, ids);
  }
  if (!rover.type.empty()) {
    const auto* type = find_type(fields, "RoverType", rover.type, false, context.declarations);
    if (type != nullptr && !rover.configuration.empty()) {
      check_configuration(fields, *type, rover.configuration);
    }
  }
  if (const auto* heading_rad = find_value<double>(values, "heading_rad")) {
    rover.heading_rad = *heading_rad;
  } else {
    draft.defaults.push_back(
        fmt::format("{}: Heading = toward its first waypoint", fields.subject().name));
  }
  if (const auto* charge = find_value<double>(values, "initial_charge")) {
    rover.initial_charge = *charge;
  }
  if (const SourceField* field = fields.find("OnFailure")) {
    rover.on_failure = {field->text, field->line};
  }
  if (ours.placemark->is_from_camera) {
    const SourceField* heading = fields.find("Heading");
    context.faults.warning(
        fields.subject().place,
        fmt::format("{}: its place stands in a Camera, as GDAL writes points with a field Heading: "
                    "Heading = {} is read there, without the unit that it may have had",
                    fields.subject().name, heading == nullptr ? "none" : heading->text));
  }
  const std::optional<Geodetic> start = read_position(ours, fields, context.faults);
  rover.start = start.value_or(Geodetic{});
  if (!start) gaps.unplaced_rovers.insert(rover.id);
  return draft;
}

PlanAsset read_asset(const PlanPlacemark& ours, const ReadContext& context, IdPlaces& ids,
                     PlanGaps& gaps) {
  FieldReader fields(subject_of(ours, "AssetId", context), ours.data, context.faults);
  fields.check_names({asset_fields()});
  const FieldValues values = fields.read(asset_fields(), nullptr);

  PlanAsset asset;
  asset.place = fields.subject().place;
  asset.id = text_or_empty(values, "asset_id");
  asset.type = text_or_empty(values, "asset_type");
  if (asset.id.empty()) {
    gaps.asset_ids = true;
  } else {
    check_id(fields, "AssetId", asset.id, ids);
  }
  if (!asset.type.empty()) {
    find_type(fields, "AssetType", asset.type, true, context.declarations);
  }
  if (const auto* height_m = find_value<double>(values, "height_m")) {
    asset.antenna_height_m = *height_m;
  }
  asset.position = read_position(ours, fields, context.faults).value_or(Geodetic{});
  return asset;
}

}  // namespace

std::vector<PlanRover> read_rovers(const std::vector<PlanPlacemark>& rovers,
                                   const ReadContext& context, IdPlaces& ids, PlanGaps& gaps,
                                   std::vector<std::string>& defaults) {
  if (rovers.empty()) {
    context.faults.error({context.source_file, 0},
                         "has no Rover; at least one is wanted: a Placemark with "
                         "<SchemaData schemaUrl=\"#Rover\">");
  }
  std::vector<DraftRover> drafts;
  drafts.reserve(rovers.size());
  for (const PlanPlacemark& ours : rovers) drafts.push_back(read_rover(ours, context, ids, gaps));
  std::ranges::stable_sort(drafts, {}, [](const DraftRover& d) { return d.rover.id; });
  std::vector<PlanRover> result;
  for (DraftRover& draft : drafts) {
    result.push_back(std::move(draft.rover));
    defaults.insert(defaults.end(), draft.defaults.begin(), draft.defaults.end());
  }
  return result;
}

std::vector<PlanAsset> read_assets(const std::vector<PlanPlacemark>& assets,
                                   const ReadContext& context, IdPlaces& ids, PlanGaps& gaps) {
  std::vector<PlanAsset> result;
  for (const PlanPlacemark& ours : assets) result.push_back(read_asset(ours, context, ids, gaps));
  std::ranges::stable_sort(result, {}, &PlanAsset::id);
  return result;
}

}  // namespace lsos
