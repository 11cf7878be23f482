#include "mission/rover/rover_agent.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/stop_signal.h"
#include "vehicle/limb_hindrance.h"

namespace lsos {

namespace {

constexpr double default_antenna_above_m = 0.3;  // default antenna above the top of the shapes

}  // namespace

RoverAgent::RoverAgent(const PlanRover& rover, const RoverModel& model, const VehicleConfig& config,
                       const Ground& ground, std::span<const PowerSource> sources,
                       PlannedLegs& legs, const Surroundings& surroundings)
    : rover_(rover),
      surroundings_(&surroundings),
      journal_(rover.id),
      motion_(config, ground),
      drive_(motion_, journal_),
      shape_(model.shapes, config),
      power_(model.power, rover.initial_charge, sources),
      antennas_(antennas_of(model, shape_.top_m() + default_antenna_above_m)),
      breakable_parts_(breakable_parts(config, model.power, antennas_.specs())),
      routes_(config, model.limits, load_w(model.power.loads, {}), ground, legs) {
  view_.id = rover.id;
  view_.type = rover.type;
  view_.cruise_speed_mps = config.cruise_speed_mps;
  view_.length_m = 2 * motion_.footprint_at_rest().half_m.x();
  if (model.limits.slope_max_rad) view_.slope_max_rad = *model.limits.slope_max_rad;
  view_.turning_radius_m = config.can_turn_on_spot ? 0 : config.turning_radius_min_m;
}

void RoverAgent::place(double default_heading_rad) {
  const std::string hindrance =
      motion_.vehicle().place(rover_.start, rover_.heading_rad.value_or(default_heading_rad));
  if (!hindrance.empty()) {
    throw InputError(rover_.place, fmt::format("Rover '{}': {}", rover_.id, hindrance));
  }
  motion_.read();
  update_view();
  tally_.add(motion_.report());
  drive_.warn_of_stance();
  if (!view_.stance_fault.empty()) {
    journal_.warn(fmt::format("{}: {}", rover_.id, view_.stance_fault));
  }
}

void RoverAgent::advance() { motion_.vehicle().advance(exchange_period); }

bool RoverAgent::observe(SimTime now) {
  if (is_parked()) {
    const bool is_carried = drive_.is_carried(), has_ended = drive_.carry(now);
    if (is_carried) update_view();
    return has_ended;
  }
  motion_.read();
  update_view();
  tally_.add(motion_.report());
  drive_.observe();
  return false;
}

void RoverAgent::update_energy(SimTime now) {
  now_ = now;
  power_.begin(now, view_.p_S_m, view_.drive_w, is_at_rest());
  if (supply_watch_.observe(power_, now, journal_)) drive_.fail("the battery is empty");
  if (power_.keeps_reserve()) drive_.fail(reserve_text(power_));
}

void RoverAgent::keep_track() {
  if (!track_) track_.emplace();
  if (motion_.report().is_finite) track_->add(view_.p_S_m.head<2>());
}

void RoverAgent::control() {
  drive_.warn_of_slope(now_);
  drive_.control();
  update_view();
}

double RoverAgent::accepted_w(double offered_w) {
  power_.set_antennas(antennas_.power_w(now_));
  return power_.accepted_w(offered_w, is_at_rest() && now_ >= limbs_move_until_);
}

void RoverAgent::settle_energy() {
  update_flows();
  supply_watch_.settle(power_, now_, journal_);
}

void RoverAgent::update_flows() {
  power_.set_antennas(antennas_.power_w(now_));
  std::optional<double> expected_w;
  if (now_ < limbs_move_until_) expected_w = limbs_w_;
  if (drive_.is_carried()) expected_w = drive_.foreseen()->power_w();
  power_.set_expected_drive(expected_w);
  power_.settle(is_at_rest() && !expected_w);
}

void RoverAgent::release() {
  tally_.end_event();
  brake();
  power_.set_claims({});
  update_flows();
}

void RoverAgent::update_view() {
  const VehicleReport& report = motion_.report();
  const Geodetic place = motion_.place();
  view_.p_S_m = report.p_S_m;
  view_.lon_rad = place.lon_rad;
  view_.lat_rad = place.lat_rad;
  view_.elevation_m = report.elevation_m;
  view_.heading_rad = report.heading_rad;
  view_.pitch_rad = report.pitch_rad;
  view_.roll_rad = report.roll_rad;
  view_.speed_mps = report.speed_mps;
  view_.distance_m = motion_.distance_m();
  view_.slope_rad = report.slope_rad;
  view_.slip = report.slip;
  view_.sinkage_m = report.sinkage_m;
  view_.drive_w = motion_.drive_w();
  view_.drive_j = motion_.drive_j();
  view_.length_m = 2 * motion_.footprint_at_rest().half_m.x();
  view_.is_parked = is_at_rest();
  view_.is_adjusting = motion_.is_adjusting() && !(foresees_ && is_parked());
  view_.clearance_m = posture_clearance_m(motion_.vehicle());
  view_.stance_fault = stance_fault(motion_.vehicle());
}

Vec3 RoverAgent::antenna_S_m() const {
  return motion_.part_poses().front().point_S_m(antennas_.p_B_m(now_));
}

void RoverAgent::follow(const Path3& path_S_m, const FollowSettings& settings) {
  if (!foresees_) return drive_.follow(path_S_m, settings);
  drive_.foresee(estimate(path_S_m, settings), now_);
  update_view();
}

DriveEstimate RoverAgent::estimate(const Path3& path_S_m, const FollowSettings& settings) {
  return routes_.estimate(view_.p_S_m, motion_.report().yaw_rad, path_S_m, settings);
}

void RoverAgent::pursue_foreseen(const RoverAgent& leader, bool has_leader_ended) {
  const std::optional<double> speed_mps = motion_.config().speed_max_mps;
  drive_.pursue_foreseen(leader.drive_, has_leader_ended, now_, [&](const Path3& line_S_m) {
    return estimate(line_S_m, {.speed_mps = speed_mps});
  });
}

void RoverAgent::follow_rover(const PursuitSettings& settings) {
  const std::string& leader = settings.leader_id;
  if (leader == rover_.id) throw std::runtime_error("a rover does not follow itself");
  if (!surroundings_->has_rover(leader)) {
    const bool is_asset = surroundings_->place_S_m(leader).has_value();
    throw std::runtime_error(is_asset
                                 ? fmt::format("'{}' is an asset, which does not drive", leader)
                                 : fmt::format("there is no rover '{}'", leader));
  }
  if (foresees_) return drive_.foresee_pursuit(settings);
  drive_.follow_rover(settings);
}

PlannedRoute RoverAgent::plan_path(const Path3& waypoints_S_m, std::int64_t first,
                                   const RouteSettings& settings) {
  if (const PostureControl* posture = motion_.vehicle().posture()) {
    routes_.stand_on(posture->hubs_B_m());
  }
  RouteSettings around = settings;
  for (const std::string& id : settings.around) {
    if (auto obstacle = surroundings_->obstacle(id)) around.standing.push_back(*obstacle);
  }
  const Task task("a route is planned");
  PlannedRoute route = routes_.plan(rover_.id, now_, journal_.sequence(),
                                    {view_.p_S_m, view_.heading_rad}, waypoints_S_m, first, around);
  for (const std::string& warning : routes_.take_warnings()) journal_.warn(warning);
  return route;
}

std::optional<GroundView> RoverAgent::ground_at(const Vec3& p_S_m) const {
  const Ground& ground = motion_.ground();
  const GroundSample sample = Ground::Probe(ground).sample(p_S_m);
  if (!sample.is_ground()) return {};
  return GroundView{p_S_m - sample.gap_m * sample.up_S, sample.elevation_m,
                    std::acos(std::clamp(sample.normal_S.dot(sample.up_S), -1.0, 1.0)),
                    ground.soils()[static_cast<std::size_t>(sample.soil)].name};
}

Vec3 RoverAgent::ahead_S_m(double distance_m) const {
  const Ground& ground = motion_.ground();
  const SiteFrame& site = ground.site();
  const Vec3& p_S_m = view_.p_S_m;
  const Vec3 there_S_m = p_S_m + distance_m * site.horizontal_S(view_.heading_rad, p_S_m);
  Geodetic there = site.geodetic(there_S_m);
  there.height_m = ground.elevation_m(there).value_or(there.height_m);
  return site.p_S_m(there);
}

Deployment RoverAgent::deploy_antenna(const std::string& antenna, bool up,
                                      std::optional<double> duration_s) {
  return antennas_.deploy(antenna, up, duration_s, now_);
}

double RoverAgent::set_posture(const PostureRequest& request) {
  const PostureTime time = lsos::set_posture(motion_.vehicle(), request);
  if (foresees_ && motion_.config().posture) {
    const double before_m = view_.clearance_m;
    motion_.take_posture();  // at once: the event waits all the same
    update_view();
    const double gravity_mps2 =
        motion_.ground().site().gravity_S_mps2(motion_.report().p_S_m).norm();
    const PostureWork work =
        expected_work(motion_.vehicle(), time, view_.clearance_m - before_m, gravity_mps2);
    limbs_move_until_ = now_ + from_seconds(work.takes_s);
    limbs_w_ = work.energy_j / work.takes_s;
    return work.takes_s;
  }
  drive_.wake_in_other_stance();
  view_.is_adjusting = motion_.is_adjusting();
  return time.takes_s;
}

void RoverAgent::archive(Archive& a) {
  std::int64_t noted_sequence = journal_.sequence();
  a.tag("rover");
  LSOS_ARCHIVE(a, motion_, drive_, track_, tally_, power_, supply_watch_, antennas_, routes_, now_,
               noted_sequence);
  journal_.set_sequence(noted_sequence);
  if (a.is_reading()) update_view();
}

}  // namespace lsos
