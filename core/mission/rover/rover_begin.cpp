// A rover that begins as another run left it, or goes on as it was measured to be.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mission/port/equipment_fault.h"
#include "mission/rover/rover_agent.h"
#include "planet/ellipsoid.h"

namespace lsos {

namespace {

// How near to the wanted place and heading it must come to rest, and how often that is tried.
constexpr double off_max_m = 1e-4, off_max_rad = 1e-6;
constexpr int tries_max = 8;

double number_or(const std::map<std::string, double>& numbers, const std::string& name,
                 double otherwise) {
  const auto found = numbers.find(name);
  return found == numbers.end() ? otherwise : found->second;
}

}  // namespace

void RoverAgent::begin(const RoverStart& start) {
  try {
    begin_as(start);
  } catch (const EquipmentFault& fault) {
    throw InputError(rover_.place, fmt::format("Rover '{}': {}", rover_.id, fault.what()));
  }
}

void RoverAgent::begin_as(const RoverStart& start) {
  // What is broken holds while the rover settles: locked wheels, joints that do not turn. A panel
  // that is stuck must first be where it is stuck, and a battery be as small as it has become.
  for (const Breakage& breakage : start.breakages) {
    if (breakage.what != "panel") apply(resolved(breakage), now_);
  }
  Vehicle& vehicle = motion_.vehicle();
  if (start.stance && vehicle.posture() != nullptr) {
    std::vector<Vec3> hubs_B_m = vehicle.posture()->hubs_B_m();
    for (std::size_t i = 0; i < hubs_B_m.size(); ++i) {
      const auto hub = start.stance->hubs_B_m.find(vehicle.config().limbs[i].name);
      if (hub != start.stance->hubs_B_m.end()) hubs_B_m[i] = hub->second;
    }
    vehicle.stand_on(hubs_B_m, start.stance->is_level);
    routes_.start_on(hubs_B_m);
  }
  stand_at(start.place.value_or(rover_.start),
           start.heading_rad.value_or(rover_.heading_rad.value_or(0)), joints_of(start), false);
  tally_.add(motion_.report());
  begin_panels(start);
  begin_masts(start);
  power_.begin_with(start.energy_j, start.resources);
  for (const Breakage& breakage : start.breakages) {
    const BreakageOfParts of_parts = resolved(breakage);
    if (breakage.what == "panel") apply(of_parts, now_);
    journal_.note("fault", breakage_json(breakage, of_parts));
  }
}

std::vector<double> RoverAgent::joints_of(const RoverStart& start) const {
  std::vector<double> joints;
  for (const LinkConfig& link : motion_.config().links) {
    joints.push_back(number_or(start.joints, link.name, link.initial));
  }
  return joints;
}

// A vehicle that is put down moves a little until it rests, so it is put down again, by as much
// beside the place as it had moved. `is_again`: in the middle of a run.
void RoverAgent::stand_at(const Geodetic& wanted, double wanted_rad,
                          const std::vector<double>& joints, bool is_again) {
  const SiteFrame& site = motion_.ground().site();
  Vehicle& vehicle = motion_.vehicle();
  Geodetic at = wanted;
  double heading_rad = wanted_rad;
  for (int tried = 0; tried < tries_max; ++tried) {
    const std::string hindrance = is_again ? vehicle.place_again(at, heading_rad, joints)
                                           : vehicle.place(at, heading_rad, joints);
    if (!hindrance.empty()) {
      throw InputError(rover_.place, fmt::format("Rover '{}': {}", rover_.id, hindrance));
    }
    motion_.read();
    const VehicleReport& report = motion_.report();
    const double height_m = motion_.place().height_m;
    Vec3 off_S_m = site.p_S_m({wanted.lon_rad, wanted.lat_rad, height_m}) - report.p_S_m;
    const Vec3 up_S = site.up_S(report.p_S_m);
    off_S_m -= off_S_m.dot(up_S) * up_S;
    const double off_rad = std::remainder(wanted_rad - report.heading_rad, 2 * std::numbers::pi);
    if (off_S_m.norm() <= off_max_m && std::abs(off_rad) <= off_max_rad) break;
    at = site.geodetic(site.p_S_m({at.lon_rad, at.lat_rad, height_m}) + off_S_m);
    heading_rad += off_rad;
  }
  update_view();
}

void RoverAgent::begin_panels(const RoverStart& start) {
  PanelArray& panels = power_.panels();
  const SiteFrame& site = motion_.ground().site();
  const Mat3 R_BS = motion_.part_poses().front().R_SB.transpose();
  const Vec3& p_S_m = motion_.report().p_S_m;
  for (std::size_t i = 0; i < panels.specs().size(); ++i) {
    const PanelSpec& spec = panels.specs()[i];
    const auto found = start.panels.find(spec.name);
    if (found == start.panels.end()) continue;
    const RoverStart::Panel& panel = found->second;
    PanelAngles angles = spec.rest;
    if (panel.face) {
      const Vec3 face_S =
          std::cos(panel.face->elevation_rad) * site.horizontal_S(panel.face->azimuth_rad, p_S_m) +
          std::sin(panel.face->elevation_rad) * site.up_S(p_S_m);
      angles = facing(spec, spec.rest, R_BS * face_S);
    } else if (panel.goes_up) {
      journal_.warn(fmt::format("{}: the panel '{}' was on its way up: it begins stowed", rover_.id,
                                spec.name));
    }
    panels.begin(i, panel.face.has_value(), angles, panel.steering);
  }
}

void RoverAgent::begin_masts(const RoverStart& start) {
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < antennas_.specs().size(); ++i) {
    const AntennaSpec& antenna = antennas_.specs()[i];
    const auto found = start.masts_m.find(antenna.name);
    if (!antenna.is_stowable() || found == start.masts_m.end()) continue;
    const double full_m = (antenna.p_B_m - *antenna.stowed_p_B_m).norm();
    const bool is_up = found->second >= full_m * (1 - rounding);
    if (!is_up && found->second > full_m * rounding) {
      journal_.warn(fmt::format("{}: the antenna '{}' was on its way: it begins stowed", rover_.id,
                                antenna.name));
    }
    antennas_.begin(i, is_up);
  }
}

// Where it is measured and where it is simulated, it can have driven since the start: else the
// place is not of this rover, or its numbers are in another order.
void RoverAgent::check_reach(const Geodetic& measured, const Place& row) const {
  constexpr double inaccuracy_m = 100;
  const Body& body = motion_.ground().site().body();
  const double off_m = surface_distance_m(body, motion_.place(), measured);
  const double reach_m = 2 * motion_.config().speed_max_mps * seconds(now_) + inaccuracy_m;
  if (off_m <= reach_m) return;
  throw InputError(
      row, fmt::format("{} cannot go on from {:.6f},{:.6f}: that is {:.1f} km from where it is "
                       "simulated, farther than it can have driven{}",
                       rover_.id, lon_deg(measured), lat_deg(measured), off_m / 1000,
                       off_m > 10 * reach_m ? "; are longitude and latitude exchanged?" : ""));
}

Correction RoverAgent::correct(const MeasuredState& measured) {
  Correction correction;
  if (measured.place || measured.heading_rad) correct_place(measured, correction);
  if (measured.charge || measured.energy_j) correct_charge(measured, correction);
  return correction;
}

void RoverAgent::correct_place(const MeasuredState& measured, Correction& correction) {
  if (!motion_.fault().empty()) {
    throw InputError(measured.row, fmt::format("Rover '{}' cannot go on from another place: {}",
                                               rover_.id, motion_.fault()));
  }
  if (measured.place) check_reach(*measured.place, measured.row);
  const VehicleReport before = motion_.report();
  const bool was_parked = is_parked();
  stand_at(measured.place.value_or(motion_.place()),
           measured.heading_rad.value_or(before.heading_rad), motion_.joints(), true);
  const VehicleReport& after = motion_.report();
  correction.moved_m = (after.p_S_m - before.p_S_m).norm();
  correction.turned_rad =
      std::remainder(after.heading_rad - before.heading_rad, 2 * std::numbers::pi);
  if (!was_parked) correction.stopped_mps = before.speed_mps;
  tally_.go_on_from(after);
  drive_.go_on_from_here();
  if (was_parked) power_.begin_motion();
}

void RoverAgent::correct_charge(const MeasuredState& measured, Correction& correction) {
  if (!power_.has_battery()) {
    throw InputError(measured.row,
                     fmt::format("Rover '{}' has no battery, but a measured charge", rover_.id));
  }
  constexpr double noise = 0.05;  // of what the battery holds, about empty and full
  const double capacity_j = power_.capacity_j();
  const double energy_j = measured.charge ? *measured.charge * capacity_j : *measured.energy_j;
  if (!(energy_j >= -noise * capacity_j && energy_j <= (1 + noise) * capacity_j)) {
    throw InputError(
        measured.row,
        fmt::format("Rover '{}' cannot go on with {:.6g} J: its battery holds 0 to {:.6g} J",
                    rover_.id, energy_j, capacity_j));
  }
  correction.charge_before = power_.account().energy_j / capacity_j;
  const double held_j = std::clamp(energy_j, 0.0, capacity_j);
  if (held_j != energy_j) {
    journal_.warn(fmt::format("{}: a charge of {:.2f} % was measured; it goes on with {:.0f} %",
                              rover_.id, 100 * energy_j / capacity_j, 100 * held_j / capacity_j));
  }
  power_.set_energy(held_j);
}

}  // namespace lsos
