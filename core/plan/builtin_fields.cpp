// The fields that exist without any script: those of MissionInfo, Rover and Asset, and those that
// every event has.
#include "base/sim_time.h"
#include "plan/declaration.h"
#include "planet/body.h"

namespace lsos {

namespace {

FieldDeclaration field(const char* name, const char* key, FieldKind kind, const char* doc) {
  FieldDeclaration declaration;
  declaration.name = name;
  declaration.key = key;
  declaration.kind = kind;
  declaration.doc = doc;
  return declaration;
}

FieldDeclaration required(const char* name, const char* key, FieldKind kind, const char* doc) {
  FieldDeclaration declaration = field(name, key, kind, doc);
  declaration.is_required = true;
  return declaration;
}

FieldDeclaration with_default(FieldDeclaration declaration, FieldValue value) {
  declaration.default_value = std::move(value);
  return declaration;
}

FieldDeclaration in_range(FieldDeclaration declaration, const char* unit,
                          std::optional<double> min_si, std::optional<double> max_si) {
  declaration.unit = find_unit(unit);
  declaration.min_si = min_si;
  declaration.max_si = max_si;
  return declaration;
}

FieldDeclaration planet_field() {
  FieldDeclaration declaration =
      required("Planet", "planet", FieldKind::choice, "body that the mission drives on");
  for (const Body& body : all_bodies()) declaration.choices.emplace_back(body.name);
  return declaration;
}

}  // namespace

const std::vector<FieldDeclaration>& common_event_fields() {
  static const std::vector<FieldDeclaration> fields{
      with_default(field("Enabled", "enabled", FieldKind::boolean, "false: the event is left out"),
                   true),
      field("StartTime", "start_time", FieldKind::utc, "the event does not start before"),
      field("StartAfter", "start_after", FieldKind::text,
            "events that must have ended: labels or ROVER/SEQUENCE, comma-separated"),
      field("StartWhen", "start_when", FieldKind::text,
            "the event waits until this holds: charge > 0.8 and sun_fraction > 0"),
      field("SkipWhen", "skip_when", FieldKind::text,
            "the event is skipped if this holds before it starts"),
      field("StopWhen", "stop_when", FieldKind::text,
            "the event fails when this holds while it runs; OnFailure says what follows"),
      field("WarnWhen", "warn_when", FieldKind::text,
            "a warning and a note each time this begins to hold while the event runs; it stops "
            "nothing"),
      in_range(field("Timeout", "timeout_s", FieldKind::duration,
                     "the event fails when it takes longer, from the start of its first phase"),
               "s", seconds(exchange_period), longest_duration_s),
      with_default(field("OnFailure", "on_failure", FieldKind::text,
                         "what follows a failure: stop, skip, abort, goto LABEL"),
                   std::string("stop")),
  };
  return fields;
}

const std::vector<FieldDeclaration>& event_identity_fields() {
  static const std::vector<FieldDeclaration> fields{
      required("RoverId", "rover_id", FieldKind::text, "the rover whose event this is"),
      required("Sequence", "sequence", FieldKind::integer,
               "place among the rover's events, ascending; gaps are fine"),
  };
  return fields;
}

const std::vector<FieldDeclaration>& mission_fields() {
  static const std::vector<FieldDeclaration> fields{
      planet_field(),
      required("StartTime", "start_time", FieldKind::utc, "moment at which the simulation starts"),
      required("Terrain", "terrain", FieldKind::text,
               "name of a terrain script, or path of a raster, relative to the plan"),
      field("TerrainBeyond", "terrain_beyond", FieldKind::text,
            "the ground where the raster of Terrain ends, as far as the horizon: a coarser raster "
            "or a terrain script"),
      field("Soil", "soil", FieldKind::text,
            "a script in terrain/soils/: what the ground is made of, in place of the terrain's "
            "own soil"),
      field("SoilVariant", "soil_variant", FieldKind::text,
            "changes to the numbers of the soil: cohesion_pa = 300; friction_rad = 35 deg"),
      field("SiteOrigin", "site_origin", FieldKind::text,
            "LON,LAT where x and y are 0 and from which generated ground is laid out; default the "
            "start of the first rover by RoverId"),
      in_range(with_default(field("Seed", "seed", FieldKind::integer, "of all random numbers"),
                            std::int64_t{0}),
               "1", 0, {}),
      in_range(with_default(field("LogInterval", "log_interval_s", FieldKind::duration,
                                  "time between log rows of a moving rover, in steps of 0.1 s"),
                            2.0),
               "s", seconds(exchange_period), longest_duration_s),
      in_range(field("ParkedLogInterval", "parked_log_interval_s", FieldKind::duration,
                     "time between log rows of a parked rover; default 60 s, or LogInterval where "
                     "that is longer"),
               "s", seconds(exchange_period), longest_duration_s),
      in_range(field("MaxDuration", "max_duration_s", FieldKind::duration,
                     "the run ends there as incomplete; default by what the plan says of times, "
                     "366 d where a condition may keep it waiting"),
               "s", seconds(exchange_period), longest_duration_s),
      field("OnFailure", "on_failure", FieldKind::text,
            "what follows a failure where neither the event nor its Rover says it: stop, skip, "
            "abort, goto LABEL (the next later event of the rover so called, else stop)"),
      field("CaseOf", "case_of", FieldKind::text,
            "a plan, relative to this one, of which this is a case (see sweep): scripts and "
            "rasters are found beside that plan"),
      field("CaseOfSha256", "case_of_sha256", FieldKind::text,
            "SHA-256 of that plan's file: whoever wrote this case had it"),
  };
  return fields;
}

const std::vector<FieldDeclaration>& rover_fields() {
  static const std::vector<FieldDeclaration> fields{
      required("RoverId", "rover_id", FieldKind::text, "unique name of the rover"),
      required("RoverType", "rover_type", FieldKind::text, "its script in rovers/"),
      field("RoverConfig", "rover_config", FieldKind::text,
            "initial configuration that the script defines"),
      field("Variant", "variant", FieldKind::text,
            "changes to the numbers of its script: battery.capacity_j = 60 kWh; cruise_speed_mps = "
            "1.5"),
      in_range(field("Heading", "heading_rad", FieldKind::number,
                     "at the start, clockwise from true north; default toward its first waypoint"),
               "deg", {}, {}),
      in_range(with_default(field("InitialCharge", "initial_charge", FieldKind::number,
                                  "of the battery at the start"),
                            1.0),
               "1", 0, 1),
      field("OnFailure", "on_failure", FieldKind::text,
            "what follows a failure where the event does not say it: stop, skip, abort, goto "
            "LABEL (the next later event so called, else stop)"),
  };
  return fields;
}

const std::vector<FieldDeclaration>& asset_fields() {
  static const std::vector<FieldDeclaration> fields{
      required("AssetId", "asset_id", FieldKind::text, "unique name, also among rovers"),
      required("AssetType", "asset_type", FieldKind::text, "its script in rovers/"),
      in_range(field("Height", "height_m", FieldKind::number, "of its antenna above ground"), "m",
               0, {}),
  };
  return fields;
}

std::vector<std::span<const FieldDeclaration>> fields_of(const std::string& name,
                                                         const Declarations& declarations) {
  if (name == "MissionInfo") return {mission_fields()};
  if (name == "Rover") return {rover_fields()};
  if (name == "Asset") return {asset_fields()};
  return {event_identity_fields(), common_event_fields(), declarations.events.at(name).fields};
}

}  // namespace lsos
