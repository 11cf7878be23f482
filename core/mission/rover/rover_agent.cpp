#include "mission/rover/rover_agent.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/units.h"
#include "mission/port/note_json.h"

namespace lsos {

namespace {

constexpr double at_rest_mps = 0.005;            // speed below which a braked rover is at rest
constexpr int exchanges_until_parked = 5;        // exchanges at rest after which it is parked
constexpr double rolled_over_rad = 1.2;          // tilt of the chassis (69 deg)
constexpr double driving_mps = 1e-3;             // faster than this counts as driving
constexpr double gain_hysteresis_m = 0.5;        // smaller rises are noise
constexpr double default_antenna_above_m = 0.3;  // default antenna above the top of the shapes

}  // namespace

RoverAgent::RoverAgent(const PlanRover& rover, const RoverModel& model, const VehicleConfig& config,
                       const Ground& ground, std::span<const PowerSource> sources,
                       PlannedLegs& legs, const Surroundings& surroundings)
    : rover_(rover),
      ground_(&ground),
      surroundings_(&surroundings),
      vehicle_(config, ground),
      footprint_at_rest_(footprint_at_rest(config)),
      shape_(model.shapes, config),
      power_(model.power, rover.initial_charge, sources),
      antennas_(model.antennas),
      routes_(config, model.limits, load_w(model.power.loads, {}), ground, legs) {
  if (model.antennas.empty()) {
    AntennaSpec top;
    top.name = "top";
    top.p_B_m.z() = shape_.top_m() + default_antenna_above_m;
    antennas_ = AntennaArray({top});
  }
  view_.id = rover.id;
  view_.type = rover.type;
  view_.cruise_speed_mps = config.cruise_speed_mps;
  view_.length_m = 2 * footprint_at_rest_.half_m.x();
  view_.turning_radius_m = config.can_turn_on_spot ? 0 : config.turning_radius_min_m;
}

void RoverAgent::place(double default_heading_rad) {
  const std::string hindrance =
      vehicle_.place(rover_.start, rover_.heading_rad.value_or(default_heading_rad));
  if (!hindrance.empty()) {
    throw InputError(rover_.place, fmt::format("Rover '{}': {}", rover_.id, hindrance));
  }
  look();
  update_extremes();
}

void RoverAgent::set_wheel(const std::string& name, WheelMode mode) {
  std::vector<std::string> names;
  for (const LinkConfig& link : vehicle_.config().links) {
    if (link.wheel) names.push_back(link.name);
  }
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    throw std::runtime_error(fmt::format("the rover has no wheel '{}'{}; it has {}", name,
                                         did_you_mean(name, names), fmt::join(names, ", ")));
  }
  vehicle_.set_wheel_mode(static_cast<std::size_t>(found - names.begin()), mode);
}

void RoverAgent::advance() { vehicle_.advance(exchange_period); }

void RoverAgent::observe() {
  if (is_parked_) return;
  look();
  update_extremes();
  update_slip();
  if (fault_.empty()) find_faults();
  if (!fault_.empty()) {
    command_ = {};
    has_new_command_ = true;
    return;
  }
  follow_path();
}

// Finds faults after which the rover can no longer drive.
void RoverAgent::find_faults() {
  if (!report_.is_finite) {
    is_broken_ = true;
    fault_ = vehicle_.fault();
    note("broken_dynamics", "{}");
  } else if (!report_.is_on_ground_data) {
    fault_ = fmt::format("left the terrain that is known at {:.6f},{:.6f}", lon_deg(place_now()),
                         lat_deg(place_now()));
    note("left_terrain", "{}");
  } else if (std::hypot(report_.pitch_rad, report_.roll_rad) > rolled_over_rad) {
    fault_ = fmt::format("rolled over (pitch {:.0f} deg, roll {:.0f} deg)",
                         degrees(report_.pitch_rad), degrees(report_.roll_rad));
    note("rollover", fmt::format(R"({{"pitch_rad":{},"roll_rad":{}}})",
                                 note_json(report_.pitch_rad), note_json(report_.roll_rad)));
  }
}

Footprint RoverAgent::footprint(double ahead_s) const {
  return moved(footprint_at_rest_, (report_.p_S_m + ahead_s * report_.v_S_mps).head<2>(),
               report_.yaw_rad + ahead_s * report_.yaw_rate_radps, Vec2::Zero());
}

void RoverAgent::control() {
  if (has_new_command_) {
    if (!command_.is_braking) is_parked_ = view_.is_parked = false;
    if (!is_parked_) vehicle_.command(command_);
    has_new_command_ = false;
  }
  if (is_parked_) return;
  const bool rests = command_.is_braking && !is_driving() && report_.speed_mps < at_rest_mps;
  exchanges_at_rest_ = rests ? exchanges_at_rest_ + 1 : 0;
  if (exchanges_at_rest_ >= exchanges_until_parked || !fault_.empty()) {
    is_parked_ = has_motion_ended_ = true;
    exchanges_at_rest_ = 0;
    vehicle_.halt();
    if (!is_broken_) look();
  }
}

void RoverAgent::look() {
  const VehicleReport report = vehicle_.report();
  if (!report.is_finite) {
    report_.is_finite = false;  // keep the last finite numbers for the log
    return;
  }
  report_ = report;
  joints_ = vehicle_.joint_positions();
  view_.distance_m = vehicle_.distance_m();
  view_.drive_w = vehicle_.drive_w();
  view_.drive_j = vehicle_.drive_j();
  update_view();
}

void RoverAgent::update_view() {
  const Geodetic place = ground_->site().geodetic(report_.p_S_m);
  view_.p_S_m = report_.p_S_m;
  view_.lon_rad = place.lon_rad;
  view_.lat_rad = place.lat_rad;
  view_.elevation_m = report_.elevation_m;
  view_.heading_rad = report_.heading_rad;
  view_.pitch_rad = report_.pitch_rad;
  view_.roll_rad = report_.roll_rad;
  view_.speed_mps = report_.speed_mps;
  view_.slope_rad = report_.slope_rad;
  view_.slip = report_.slip;
  view_.sinkage_m = report_.sinkage_m;
  view_.is_parked = is_parked_;
}

void RoverAgent::update_extremes() {
  const double slope_rad = report_.slope_rad;
  if (!(slope_max_rad_ >= slope_rad) && !std::isnan(slope_rad)) slope_max_rad_ = slope_rad;
  if (report_.speed_mps > driving_mps) drive_time_ += exchange_period;
  // Rises are summed from a low to the next high; a reversal smaller than the hysteresis is
  // ignored.
  const double elevation_m = report_.elevation_m;
  if (std::isnan(elevation_low_m_)) elevation_low_m_ = elevation_high_m_ = elevation_m;
  if (is_rising_) {
    elevation_high_m_ = std::max(elevation_high_m_, elevation_m);
    if (elevation_m < elevation_high_m_ - gain_hysteresis_m) {
      elevation_gain_m_ += elevation_high_m_ - elevation_low_m_;
      elevation_low_m_ = elevation_m;
      is_rising_ = false;
    }
  } else {
    elevation_low_m_ = std::min(elevation_low_m_, elevation_m);
    if (elevation_m > elevation_low_m_ + gain_hysteresis_m) {
      elevation_high_m_ = elevation_m;
      is_rising_ = true;
    }
  }
}

double RoverAgent::elevation_gain_m() const {
  return elevation_gain_m_ + (is_rising_ ? elevation_high_m_ - elevation_low_m_ : 0);
}

Deployment RoverAgent::deploy_antenna(const std::string& antenna, bool up,
                                      std::optional<double> duration_s) {
  return antennas_.deploy(antenna, up, duration_s, now_);
}

std::vector<PartPose> RoverAgent::part_poses() const {
  if (!is_broken_) return vehicle_.part_poses();
  return lsos::part_poses(vehicle_.config(),
                          chassis_pose(ground_->site(), report_.p_S_m, report_.heading_rad,
                                       report_.pitch_rad, report_.roll_rad),
                          joints_);
}

Vec3 RoverAgent::antenna_S_m() const {
  return part_poses().front().point_S_m(antennas_.p_B_m(now_));
}

void RoverAgent::release() {
  drive_time_in_events_ = drive_time_;
  brake();
  power_.set_claims({});
  update_flows();
}

void RoverAgent::note(const std::string& name, const std::string& fields_json) {
  notes_.push_back({noting_sequence_, name, fields_json});
}

std::vector<std::string> RoverAgent::take_warnings() { return std::exchange(warnings_, {}); }

std::vector<RoverAgent::Note> RoverAgent::take_notes() { return std::exchange(notes_, {}); }

Geodetic RoverAgent::place_now() const { return ground_->site().geodetic(report_.p_S_m); }

SampleRow RoverAgent::sample(SimTime now, const std::string& event,
                             const std::string& phase) const {
  SampleRow row;
  row.time = now;
  row.rover_id = rover_.id;
  row.place = place_now();
  row.elevation_m = report_.elevation_m;
  row.p_S_m = report_.p_S_m;
  row.roll_rad = report_.roll_rad;
  row.pitch_rad = report_.pitch_rad;
  row.heading_rad = report_.heading_rad;
  row.speed_mps = report_.speed_mps;
  row.distance_m = view_.distance_m;
  row.slope_rad = report_.slope_rad;
  row.slip = report_.slip;
  row.slip_max = report_.slip_max;
  row.sinkage_m = report_.sinkage_m;
  row.drive_w = view_.drive_w;
  row.drive_j = view_.drive_j;
  power_.fill(row);
  row.event = event;
  row.phase = phase;
  return row;
}

SampleRow RoverAgent::condition_sample(SimTime now, const std::string& event,
                                       const std::string& phase) const {
  SampleRow row = sample(now, event, phase);
  row.slip = is_parked_ ? not_modelled : slip_.now();
  row.slip_max = is_parked_ ? not_modelled : slip_.now_max();
  return row;
}

std::vector<JointRow> RoverAgent::joints(SimTime now) const {
  std::vector<JointRow> rows;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const LinkConfig& link = vehicle_.config().links[i];
    JointRow row{now, rover_.id, link.name};
    (link.joint == JointType::revolute ? row.angle_rad : row.extension_m) = joints_[i];
    rows.push_back(row);
  }
  for (std::size_t i = 0; i < antennas_.specs().size(); ++i) {
    const AntennaSpec& antenna = antennas_.specs()[i];
    if (!antenna.is_stowable()) continue;
    rows.push_back(
        {now, rover_.id, mast_joint(antenna), not_modelled, antennas_.extension_m(i, now)});
  }
  return rows;
}

void RoverAgent::archive(Archive& a) {
  a.tag("rover")(rover_.id)(power_)(antennas_)(routes_)(now_);
  a(has_motion_ended_)(is_shedding_)(has_warned_of_empty_)(has_warned_of_shed_)(has_warned_of_low_);
  a(vehicle_)(follower_)(command_)(has_new_command_)(is_parked_)(is_broken_)(exchanges_at_rest_);
  a(fault_)(drive_failure_)(may_touch_with_chassis_)(noting_sequence_)(joints_)(report_);
  a(view_.distance_m)(view_.drive_w)(view_.drive_j);
  a(slip_)(slope_max_rad_)(elevation_gain_m_)(elevation_low_m_)(elevation_high_m_)(is_rising_);
  a(drive_time_)(drive_time_in_events_);
  if (a.is_reading()) update_view();
}

}  // namespace lsos
