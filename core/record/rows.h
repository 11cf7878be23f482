// The rows of a run's log, as values. A NaN number (not_modelled) is NULL in the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.h"
#include "base/sim_time.h"
#include "base/vector.h"
#include "planet/body.h"

namespace lsos {

// Layer `samples`: one rover at one time.
struct SampleRow {
  SimTime time{};
  std::string rover_id;
  Geodetic place;                     // reference point, with its own height
  double elevation_m = not_modelled;  // of the ground under it, raster datum
  Vec3 p_S_m = Vec3::Zero();
  double roll_rad = 0, pitch_rad = 0, heading_rad = 0;
  double speed_mps = 0, distance_m = 0, slope_rad = not_modelled;
  double slip = not_modelled, slip_max = not_modelled, sinkage_m = not_modelled;
  double energy_j = not_modelled, charge = not_modelled, energy_rate_w = not_modelled;
  double solar_w = not_modelled, solar_available_w = not_modelled, external_w = not_modelled;
  double load_w = not_modelled, drive_w = not_modelled, loss_w = not_modelled;
  double solar_j = not_modelled, external_j = not_modelled, load_j = not_modelled;
  double drive_j = not_modelled, loss_j = not_modelled;
  double sun_fraction = not_modelled, incidence = not_modelled;
  std::string event;  // label of the running event, "" = none (NULL)
  std::string phase;
};

// Layer `joints`: the pose for pictures, one row per joint or mast, rover and time.
struct JointRow {
  SimTime time{};
  std::string rover_id;
  std::string joint;
  double angle_rad = not_modelled;    // of a revolute joint
  double extension_m = not_modelled;  // of a prismatic joint, of a mast
};

// Layer `pairs`: what one end sees of another at one time.
struct PairRow {
  SimTime time{};
  std::string from_id, to_id;
  double distance_m = 0;                   // between reference points; Earth: its centre
  std::int64_t visible = 0;                // 0 or 1, antenna to antenna; Earth: its disc's centre
  double visible_fraction = not_modelled;  // of Earth's disc
  std::int64_t link = 0;                   // 0 or 1
  std::string relay;  // ids that join the two without a direct link, comma-separated; "" = NULL
};

// Layer `sight_intervals`: times during which one end saw another or did not, was linked to it, or
// was joined to it by others alone.
struct SightIntervalRow {
  std::string from_id, to_id;
  std::string kind;  // "visible", "hidden", "link" or "relayed"
  SimTime start{}, end{};
  double light_time_s = 0;  // from one to the other, at its start
  // Comma-separated: what hides it, "ground" or the ids of rovers and assets whose bodies do; or
  // the ids that relay; "" = NULL.
  std::string by = {};
};

// Layer `panels`: exposure and power of one panel.
struct PanelRow {
  SimTime time{};
  std::string rover_id;
  std::string panel;
  double sun_fraction = not_modelled;
  double incidence = not_modelled;                                  // sun_fraction times the cosine
  double power_w = not_modelled;                                    // before curtailment
  double azimuth_rad = not_modelled, elevation_rad = not_modelled;  // of its face; NaN: stowed
};

// Layer `resources`.
struct ResourceRow {
  SimTime time{};
  std::string rover_id;
  std::string resource;
  double amount = 0;
};

enum class EventStatus {
  not_started,
  waiting,
  running,
  completed,
  failed,
  skipped,
  incomplete,
  disabled
};
constexpr EventStatus last_value(EventStatus) { return EventStatus::disabled; }
const char* to_string(EventStatus status);

// Layer `events`: (rover_id, sequence) is its key; writing it again updates the row.
struct EventRow {
  std::string rover_id;
  std::int64_t sequence = 0;
  std::string type, label;
  EventStatus status = EventStatus::not_started;
  std::string reason;  // "" = NULL
  std::optional<SimTime> ready, start, end;
  double distance_m = not_modelled, energy_used_j = not_modelled, solar_j = not_modelled;
  bool is_prevented = false;      // not started because of a failure; not a column
  std::optional<Geodetic> place;  // where the rover was when it ended (or started)
};

// Layer `phases`: one phase of one event, written when it ends.
struct PhaseRow {
  std::string rover_id;
  std::int64_t sequence = 0;
  std::string phase;
  SimTime start{};
  std::optional<SimTime> end;
};

// Layer `planned_paths`: a leg as it was planned.
struct PlannedPathRow {
  SimTime time{};
  std::string rover_id;
  std::int64_t sequence = 0;  // of the event
  std::int64_t leg = 0;       // number of the waypoint that it leads to, from 1
  std::int64_t attempt = 0;   // counted from 0
  double length_m = 0, duration_s = 0, energy_j = 0, slope_max_rad = 0;
  Geodetic steepest;  // where slope_max_rad is
  std::vector<Geodetic> line;
};

// Layer `standing_orders`, which is no part of the contract or of the digest: what goes on to hold
// of a rover though no event runs, and cannot be seen in the other layers. A row is written with
// the first sample after it has changed.
struct OrderRow {
  static constexpr const char *panel = "panel", *limb = "limb";
  static constexpr const char *stowed = "stowed", *level = "level", *parallel = "parallel";

  SimTime time{};
  std::string rover_id;
  std::string part;   // panel or limb
  std::string name;   // of that panel or limb
  std::string order;  // of a panel: stowed or how it is steered; of limbs: level, parallel
  double azimuth_rad = not_modelled, elevation_rad = not_modelled;    // of a panel: its orientation
  double x_m = not_modelled, y_m = not_modelled, z_m = not_modelled;  // of a limb: its hub, frame B

  // Whether it orders the same, whenever it was written.
  bool orders_same(const OrderRow& other) const;
};

// Layer `notes`: messages of events, findings, decisions.
struct NoteRow {
  SimTime time{};
  std::string rover_id;
  std::int64_t sequence = 0;
  std::string name;
  std::string fields_json;  // an object, keys sorted
  Geodetic place;

  void archive(Archive& a) {
    LSOS_ARCHIVE(a, time, rover_id, sequence, name, fields_json, place.lon_rad, place.lat_rad,
                 place.height_m);
  }
  bool is_sound() const;  // its fields are an object
};

}  // namespace lsos
