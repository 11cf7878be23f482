// A mission plan as values: what the Placemarks of a KML document say, checked, in SI, and each
// with the line it came from.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/sim_time.h"
#include "plan/declaration.h"
#include "planet/body.h"
#include "planet/utc.h"

namespace lsos {

// What a plan says of a terrain.
struct TerrainName {
  std::string name;  // of a terrain script, or path of a raster (resolved); "": not said
  bool is_raster = false;
  std::string as_written;  // what the plan says; hashed in place of a resolved path

  const std::string& hashed() const { return is_raster ? as_written : name; }
};

struct MissionInfo {
  Place place;
  const Body* planet = nullptr;
  Instant start_time;
  TerrainName terrain;
  TerrainName terrain_beyond;  // the ground where the terrain ends
  std::uint64_t seed = 0;
  SimTime log_interval{2'000'000};
  SimTime parked_log_interval{60'000'000};
  SimTime max_duration{366LL * 86400 * 1'000'000};
  bool has_max_duration = false;  // the plan says it; else default_max_duration() does
};

struct PlanRover {
  Place place;
  std::string id;
  std::string type;                   // script in rovers/
  std::string configuration;          // "" = the type's own
  std::string variant;                // changes to the type's numbers, as written; "" = none
  Geodetic start;                     // height 0: rovers stand on the ground
  std::optional<double> heading_rad;  // clockwise from true north
  double initial_charge = 1;

  // What its numbers are known by: its type, with its changes to them.
  std::string model() const { return variant.empty() ? type : type + " with " + variant; }
};

// A thing that stands on the ground and is no rover: a habitat, a comm station.
struct PlanAsset {
  Place place;
  std::string id;
  std::string type;  // script in rovers/ whose kind is an asset
  Geodetic position;
  std::optional<double> antenna_height_m;  // above ground; absent: the type's own
};

struct PlanGeometry {
  GeometryKind kind = GeometryKind::none;
  std::vector<Geodetic> points;  // one for a Point; of a Polygon each corner of its outline once
  // The holes of a Polygon, each corner once. They lie inside the outline, apart from it and from
  // each other.
  std::vector<std::vector<Geodetic>> holes = {};
  int line = 0;
};

enum class OnFailure { stop, skip, abort, go_to };

// One event of a rover, with every field present or filled in from its default.
struct PlanEvent {
  Place place;
  std::string type;
  std::string label;
  std::string rover_id;
  std::int64_t sequence = 0;
  PlanGeometry geometry;
  std::map<std::string, FieldValue> params;  // by script key; optional absent ones are left out
  bool has_all_params = true;                // false: faults keep some from being read

  bool is_enabled = true;
  std::optional<Instant> start_time;
  struct Reference {
    std::string rover_id;
    std::int64_t sequence = 0;
    auto operator<=>(const Reference&) const = default;
  };
  std::vector<Reference> start_after;
  // A Lua expression over logged quantities, as written; "": none.
  struct Condition {
    std::string text;
    int line = 0;
  };
  Condition start_when, skip_when, stop_when;
  std::optional<SimTime> timeout;
  OnFailure on_failure = OnFailure::stop;
  std::int64_t go_to_sequence = 0;  // with OnFailure::go_to
};

// What faults of a plan leave open. Of that nothing is told which may only follow from them.
struct PlanGaps {
  bool start_time = false;                // MissionInfo's
  bool rover_ids = false;                 // a rover has none that can be read
  bool asset_ids = false;                 // the same of an asset
  std::set<std::string> unread_ids;       // of rovers and assets whose Placemark cannot be read
  std::set<std::string> unplaced_rovers;  // by id: their Point cannot be read

  bool has_ids() const { return rover_ids || asset_ids; }
};

struct Plan {
  std::string file;
  MissionInfo mission;
  std::vector<PlanRover> rovers;      // in byte order of id
  std::vector<PlanEvent> events;      // by rover id, then sequence
  std::vector<PlanAsset> assets;      // in byte order of id
  int decoration_count = 0;           // Placemarks that are not ours
  std::vector<std::string> defaults;  // "Route 'leg 2': Speed = 1 m/s", what was filled in
  PlanGaps gaps;

  // SHA-256 of all that the plan says, in a fixed order, without file name and lines.
  std::string hash() const;
};

// The rover with that id; nullptr when there is none, or more than one.
const PlanRover* rover_of(const Plan& plan, const std::string& rover_id);

// Reads and checks a KML or KMZ file against what there is. All faults are collected in `faults`
// (warnings too); the plan is complete only when it has no errors, else `gaps` say what is not.
Plan read_plan(const std::string& file, const Declarations& declarations, Faults& faults);

struct KmlSource;
struct SourcePlacemark;
// The same of Placemarks that come from elsewhere. `file`: what relative paths are relative to.
Plan read_plan(const std::string& file, const KmlSource& source, const Declarations& declarations,
               Faults& faults);
// One more event for a plan, to which its references may point. Throws InputError.
PlanEvent read_event(const SourcePlacemark& placemark, const Plan& plan,
                     const Declarations& declarations);

}  // namespace lsos
