// A mission plan as values: the contents of a KML document's Placemarks, checked, in SI, each with
// the line it came from.
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

// A terrain as a plan names it.
struct TerrainName {
  std::string name;  // of a terrain script, or path of a raster (resolved); "": not given
  bool is_raster = false;
  std::string as_written;  // text of the plan; hashed instead of the resolved path

  const std::string& hashed() const { return is_raster ? as_written : name; }
};

// What OnFailure of MissionInfo or a Rover says of events that say nothing of their own, as
// written; its text is "" when there is none. The events have taken it over already.
struct FailureDefault {
  std::string text;
  int line = 0;
};

struct MissionInfo {
  Place place;
  const Body* planet = nullptr;
  Instant start_time;
  TerrainName terrain;
  TerrainName terrain_beyond;  // the ground beyond the edges of `terrain`
  std::string soil;            // script in terrain/soils/, in place of the terrain's; "": none
  std::string soil_variant;    // changes to that soil's numbers, as written; "": none
  std::string case_of;         // see Plan::home, as written; "": none
  std::uint64_t seed = 0;
  SimTime log_interval{2'000'000};
  SimTime parked_log_interval{60'000'000};
  SimTime max_duration{366LL * 86400 * 1'000'000};
  bool has_max_duration = false;  // given in the plan; false: default_max_duration() gives it
  FailureDefault on_failure;      // of all rovers
  // Origin of the site frame, about which generated ground is laid out, as written, at height 0.
  // Absent: the start of the first rover, see site_of().
  std::optional<Geodetic> site = {};
  // The same of the run with whose end the mission begins: it comes before `site`.
  std::optional<Geodetic> earlier_site = {};
};

struct PlanRover {
  Place place;
  std::string id;
  std::string type;                   // script in rovers/
  std::string configuration;          // "": the type's default
  std::string variant;                // changes to the type's numbers, as written; "": none
  Geodetic start;                     // height 0: rovers stand on the ground
  std::optional<double> heading_rad;  // clockwise from true north
  double initial_charge = 1;
  FailureDefault on_failure;  // comes before the mission's

  // Name of the rover's set of numbers: its type, with the changes to them.
  std::string model() const { return variant.empty() ? type : type + " with " + variant; }
};

// An object that stands on the ground and is not a rover: a habitat, a comm station.
struct PlanAsset {
  Place place;
  std::string id;
  std::string type;  // script in rovers/ whose kind is an asset
  Geodetic position;
  std::optional<double> antenna_height_m;  // above ground; absent: the type's own
};

struct PlanGeometry {
  GeometryKind kind = GeometryKind::none;
  std::vector<Geodetic> points;  // one for a Point; for a Polygon its outline, each corner once
  // The holes of a Polygon, each corner once. They lie inside the outline and touch neither it nor
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
  std::map<std::string, FieldValue> params;  // by script key; without absent optional ones
  bool has_all_params = true;                // false: some could not be read, because of faults

  bool is_enabled = true;
  std::optional<Instant> start_time;
  struct Reference {
    std::string rover_id;
    std::int64_t sequence = 0;
    auto operator<=>(const Reference&) const = default;
  };
  std::vector<Reference> start_after;
  // A Lua expression over logged quantities, as written; its text is "" when there is none.
  struct Condition {
    std::string text;
    int line = 0;
  };
  Condition start_when, skip_when, stop_when, warn_when;
  std::optional<SimTime> timeout;
  OnFailure on_failure = OnFailure::stop;
  std::int64_t go_to_sequence = 0;  // with OnFailure::go_to
  // When it takes effect whatever its rover does, since the mission's start: it needs no turn, see
  // EventDeclaration::at. Absent: in its turn.
  std::optional<SimTime> at = {};
};

// What the faults of a plan leave open. Faults that may merely follow from these are not reported.
struct PlanGaps {
  bool start_time = false;                // MissionInfo's
  bool rover_ids = false;                 // the id of a rover cannot be read
  bool asset_ids = false;                 // the id of an asset cannot be read
  std::set<std::string> unread_ids;       // of rovers and assets whose Placemark cannot be read
  std::set<std::string> unplaced_rovers;  // ids of rovers whose Point cannot be read
  // The first Sequence from which it is open where a rover drives; key: RoverId.
  std::map<std::string, std::int64_t> open_drives;
  bool drives_of_any = false;  // a drive belongs to a rover that cannot be told

  bool has_ids() const { return rover_ids || asset_ids; }
};

struct Plan {
  std::string file;
  // The plan beside which scripts and rasters lie: `file`, or the one that CaseOf names. Relative
  // to the working folder.
  std::string home;
  MissionInfo mission;
  std::vector<PlanRover> rovers;               // in byte order of id
  std::vector<PlanEvent> events;               // sorted by rover id, then sequence
  std::vector<PlanAsset> assets;               // in byte order of id
  int decoration_count = 0;                    // Placemarks that do not belong to the plan
  std::vector<std::string> defaults;           // values filled in: "Route 'leg 2': Speed = 1 m/s"
  std::map<std::string, Activity> activities;  // by event type, of the types that say one
  PlanGaps gaps;

  // SHA-256 of the plan's contents in a fixed order, without file name and lines.
  std::string hash() const;
};

// SHA-256 of all that an event says, without file and line.
std::string event_hash(const PlanEvent& event);

// Where the origin of the site frame is, at height 0. The plan must have a rover.
const Geodetic& site_of(const Plan& plan);

// The rover with that id; nullptr when there is none, or more than one.
const PlanRover* rover_of(const Plan& plan, const std::string& rover_id);

// Reads a KML, KMZ or GeoPackage file and checks it against the declarations. All faults are
// collected in `faults`, warnings too. The plan is complete only when there are no errors;
// otherwise `gaps` says what is open.
Plan read_plan(const std::string& file, const Declarations& declarations, Faults& faults);

struct KmlSource;
struct SourcePlacemark;
// What Plan::home is to be of a plan that is read from `file`.
std::string home_of(const KmlSource& source, const std::string& file);
// Reads a plan from Placemarks of another source. Paths in it are relative to the folder of `file`.
Plan read_plan(const std::string& file, const KmlSource& source, const Declarations& declarations,
               Faults& faults);
// Reads one more event for a plan; its references may point to events of the plan. Throws
// InputError.
PlanEvent read_event(const SourcePlacemark& placemark, const Plan& plan,
                     const Declarations& declarations);

}  // namespace lsos
