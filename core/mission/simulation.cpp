#include "mission/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mission/ahead/equipment_warnings.h"
#include "mission/model/site.h"
#include "planet/ellipsoid.h"

namespace lsos {

namespace {

// A rover that is not at rest this long after its last event is taken to slide for ever; the
// mission then ends without waiting for it.
constexpr SimTime coming_to_rest{60'000'000};

}  // namespace

Simulation::Simulation(SimulationSetup setup)
    : setup_(std::move(setup)),
      pool_(std::min(setup_.threads, static_cast<int>(setup_.plan.rovers.size()))) {
  LSOS_ASSERT(!setup_.plan.rovers.empty());
  const Geodetic start = setup_.plan.rovers.front().start;
  ground_ = drivable_ground_at(setup_.terrain, *setup_.plan.mission.planet, start,
                               setup_.plan.mission.seed);
  const double g_mps2 = gravity_mps2(*setup_.plan.mission.planet, ground_->site().origin());
  for (const PlanRover& rover : setup_.plan.rovers) {
    vehicles_[{rover.model(), rover.configuration}] =
        make_vehicle(setup_.rover_models.at(rover.model()).spec, rover.configuration, g_mps2);
  }
  check_soil();
  legs_ = std::make_unique<PlannedLegs>(*ground_, setup_.plan.mission.seed);
  legs_->recall(setup_.cached_legs);
  place_assets();
  build();
  place_rovers();
  plan_routes();
  make_light();
  make_sight();
}

void Simulation::check_soil() const {
  Faults faults;
  const double g_mps2 = gravity_mps2(*setup_.plan.mission.planet, ground_->site().origin());
  for (const PlanRover& rover : setup_.plan.rovers) {
    const VehicleConfig& vehicle = vehicles_.at({rover.model(), rover.configuration});
    const auto wheels = std::ranges::count_if(
        vehicle.links, [](const LinkConfig& link) { return link.wheel.has_value(); });
    const double load_n = vehicle.mass_kg() * g_mps2 / static_cast<double>(wheels);
    for (const LinkConfig& link : vehicle.links) {
      if (!link.wheel) continue;
      std::string fault;
      for (const Soil& soil : ground_->soils()) {
        if (fault.empty()) fault = soil_fault(soil, *link.wheel, load_n, g_mps2);
      }
      if (fault.empty()) continue;
      faults.error(rover.place, fmt::format("Rover '{}': {}", rover.id, fault));
      break;
    }
  }
  faults.throw_if_errors();
}

Simulation::~Simulation() = default;

void Simulation::build() {
  rovers_.clear();
  host_ = setup_.make_host();
  machine_ = synthesise(setup_.plan, host_->declarations());
  for (const RoverMachine& rover : machine_.rovers) {
    rovers_.push_back({std::make_unique<RoverAgent>(
                           rover.rover, setup_.rover_models.at(rover.rover.model()),
                           vehicles_.at({rover.rover.model(), rover.rover.configuration}), *ground_,
                           sources_, *legs_, static_cast<const Surroundings&>(*this)),
                       EventSequence(rover, machine_.mission, *ground_),
                       SimTime{},
                       {},
                       true});
    if (routes_ahead_.empty()) continue;
    rovers_.back().agent->routes().set_ahead(routes_ahead_[rovers_.size() - 1].legs);
  }
}

void Simulation::place_rovers() {
  Faults faults;
  const auto plans_its_route = [&](const PlanEvent& event) {
    try {
      return host_->route_settings(event.type, {event.params, {}}, machine_.mission.start_time)
          .has_value();
    } catch (const ScriptError&) {
      return false;  // plan_routes() reports it
    }
  };
  for (std::size_t i = 0; i < rovers_.size(); ++i) {
    try {
      rovers_[i].agent->place(default_heading_rad(machine_.rovers[i], ground_->site()));
    } catch (const InputError& error) {
      faults.add(error.faults());
    }
    faults.add(site_faults(machine_.rovers[i], *ground_, plans_its_route));
  }
  if (!faults.has_errors()) check_starts_overlap(faults);
  throw_with_advice(faults);
}

// Warnings about the ground explain errors that it causes, so they are reported together.
void Simulation::throw_with_advice(Faults& faults) const {
  if (!faults.has_errors()) return;
  faults.add(ground_->advice());
  throw InputError(faults.sorted());
}

void Simulation::plan_routes() {
  if (!setup_.plans_ahead) return;
  Faults faults;
  routes_ahead_.resize(rovers_.size());
  for (std::size_t i = 0; i < rovers_.size(); ++i) {
    RoverAgent& agent = *rovers_[i].agent;
    RouteAhead ahead = plan_ahead(machine_.rovers[i], machine_.mission, agent.view().heading_rad,
                                  *host_, *ground_, agent.routes(), sources_, setup_.on_planning);
    faults.add(ahead.faults);
    const PlanRover& rover = machine_.rovers[i].rover;
    faults.add(equipment_warnings(machine_.rovers[i], machine_.mission,
                                  setup_.rover_models.at(rover.model()), *host_, ground_->site()));
    routes_ahead_[i] = {agent.id(), std::move(ahead.legs), std::move(ahead.passed),
                        std::move(ahead.drawn)};
    agent.routes().set_ahead(routes_ahead_[i].legs);
  }
  // Legs are kept also when one has no route: finding that out takes longest.
  if (setup_.cache_legs) setup_.cache_legs(legs_->kept());
  throw_with_advice(faults);
  route_faults_ = faults.sorted();
}

std::vector<Fault> Simulation::advice() const {
  std::vector<Fault> advice = ground_->advice();
  advice.insert(advice.end(), route_faults_.begin(), route_faults_.end());
  for (const RoverMachine& rover : machine_.rovers) {
    const std::vector<Fault> coarse = coarse_ground(rover, *ground_);
    if (coarse.empty()) continue;
    advice.insert(advice.end(), coarse.begin(), coarse.end());
    break;
  }
  return advice;
}

void Simulation::start() {
  for (Rover& rover : rovers_) {
    rover.agent->routes().log_ahead(rover.agent->id());
    rover.agent->observe();
  }
  // Sunlight and sight are evaluated first, so that the first decisions of scripts know them.
  if (light_) update_sunlight();
  if (sight_) update_sight();
  for (Rover& rover : rovers_) rover.agent->update_flows();
  exchange();
}

void Simulation::advance(std::optional<SimTime> until) {
  if (is_finished_) return;
  const SimTime next = until ? std::min(*until, next_time()) : next_time();
  if (next > setup_.plan.mission.max_duration) {
    // The clock stops at the last exchange within MaxDuration.
    now_ = setup_.plan.mission.max_duration - setup_.plan.mission.max_duration % exchange_period;
    for (Rover& rover : rovers_) rover.agent->update_energy(now_);
    stop(setup_.plan.mission.has_max_duration
             ? "MaxDuration is over"
             : fmt::format("MaxDuration is over, {:.0f} h by default",
                           seconds(setup_.plan.mission.max_duration) / 3600));
    return;
  }
  LSOS_ASSERT(next > now_);
  std::vector<RoverAgent*> active;
  for (Rover& rover : rovers_) {
    if (!rover.agent->is_parked()) active.push_back(rover.agent.get());
  }
  LSOS_ASSERT(active.empty() || next == now_ + exchange_period);
  pool_.for_each(active.size(), [&](std::size_t i) { active[i]->advance(); });
  now_ = next;
  exchange();
}

SimTime Simulation::next_time() {
  std::optional<SimTime> wake, next;
  bool may_wake = false;
  const auto earlier = [](std::optional<SimTime>& first, std::optional<SimTime> other) {
    if (other && (!first || *other < *first)) first = other;
  };
  for (const Rover& rover : rovers_) {
    if (!rover.agent->is_parked()) return now_ + exchange_period;
    may_wake |= rover.wake || rover.agent->power().waits_for_reserve();
    earlier(wake, rover.wake);
    earlier(wake, quiet_wake(rover));
    earlier(next, next_sample(rover));
  }
  if (!may_wake || !wake) {
    // Every rover waits for another. Cycles in the plan are found before the run, so a script waits
    // for something that never comes: until MaxDuration nothing happens but rows of the log.
    wake = setup_.plan.mission.max_duration + exchange_period;
  }
  return log_ == nullptr ? *wake : std::min(*wake, *next);
}

void Simulation::exchange() {
  for (Rover& rover : rovers_) {
    rover.was_parked = rover.agent->is_parked();
    rover.agent->observe();
    rover.agent->update_energy(now_);
    take_warnings(rover);  // also for a rover whose events are over
    const RoverPower& power = rover.agent->power();
    const bool is_news = power.has_reserve_changed() || power.has_reached_charge();
    if (is_news && !rover.sequence.is_finished()) rover.wake = now_;
  }
  avoid_rovers();
  avoid_assets();
  run_scripts();
  for (Rover& rover : rovers_) rover.agent->control();
  for (const Rover& rover : rovers_) {
    if (rover.sequence.aborts_mission().empty()) continue;
    stop(fmt::format("'{}' of {} failed and aborts the mission", rover.sequence.aborts_mission(),
                     rover.agent->id()),
         true);
    break;
  }
  // The motion of all rovers is set before any is evaluated, so that their order does not matter.
  for (Rover& rover : rovers_) rover.motion = motion_of(rover);
  if (light_) update_sunlight();
  if (sight_) update_sight();
  share_power();
  for (Rover& rover : rovers_) rover.agent->settle_energy();
  // Rovers that still roll come to rest first, so that the last rows show where they stop.
  is_finished_ =
      is_finished_ || std::ranges::all_of(rovers_, [&](const Rover& rover) {
        return rover.sequence.is_finished() &&
               (rover.agent->is_parked() || now_ - rover.sequence.last_end() > coming_to_rest);
      });
  log_rows();
  if (setup_.save_every_exchange) {
    const std::string state = save();
    build();
    restore(state);
  }
}

void Simulation::run_scripts() {
  const std::size_t ended_before = events_ended();
  for (Rover& rover : rovers_) {
    const bool is_due = rover.wake && *rover.wake <= now_;
    if (rover.sequence.is_finished() || (rover.agent->is_parked() && !is_due)) continue;
    rover.sequence.run(now_, *rover.agent, *host_, *this);
    rover.wake = rover.sequence.wake(now_);
    take_warnings(rover);
  }
  // An event that waits for one that has ended may start at the next exchange.
  if (events_ended() == ended_before) return;
  for (Rover& rover : rovers_) {
    if (!rover.sequence.is_finished()) {
      rover.wake = std::min(rover.wake.value_or(now_ + exchange_period), now_ + exchange_period);
    }
  }
}

void Simulation::stop(const std::string& reason, bool is_failure) {
  for (Rover& rover : rovers_) {
    rover.sequence.stop(now_, *rover.agent, *host_, *this, reason, is_failure);
    take_warnings(rover);
  }
  is_finished_ = true;
}

void Simulation::take_warnings(Rover& rover) {
  for (const auto& warnings : {rover.sequence.take_warnings(), rover.agent->take_warnings()}) {
    warnings_.insert(warnings_.end(), warnings.begin(), warnings.end());
  }
}

std::vector<EventRow> Simulation::events() const {
  std::vector<EventRow> rows;
  for (const Rover& rover : rovers_) {
    for (std::size_t i = 0; i < rover.sequence.records().size(); ++i) {
      rows.push_back(rover.sequence.row(i));
    }
  }
  return rows;
}

double Simulation::progress() const {
  double ended = static_cast<double>(events_ended());
  for (const Rover& rover : rovers_) ended += rover.agent->drive_share();
  const auto events = static_cast<double>(setup_.plan.events.size());
  return events > 0 ? std::min(1.0, ended / events) : 1;
}

std::size_t Simulation::events_ended() const {
  std::size_t count = 0;
  for (const Rover& rover : rovers_) {
    count += static_cast<std::size_t>(std::ranges::count_if(
        rover.sequence.records(), [](const EventRecord& r) { return r.end.has_value(); }));
  }
  return count;
}

std::vector<RoverResult> Simulation::results() const {
  std::vector<RoverResult> results;
  for (const Rover& rover : rovers_) {
    const RoverAgent& agent = *rover.agent;
    RoverResult result;
    result.id = agent.id();
    result.distance_m = agent.view().distance_m;
    for (const EventRecord& record : rover.sequence.records()) {
      if (record.ready && record.end) {
        result.duration_s = std::max(result.duration_s, seconds(*record.end));
      }
    }
    result.drive_s = agent.drive_s();
    result.elevation_gain_m = agent.elevation_gain_m();
    result.slope_max_rad = agent.slope_max_rad();
    result.slip_greatest = agent.slip().greatest();
    result.slip_p95 = agent.slip().p95();
    result.slip_rolling = agent.slip().greatest_rolling();
    result.driven_s = agent.slip().driven_s();
    result.mean_mps = agent.slip().mean_mps();
    result.mean_requested_mps = agent.slip().mean_requested_mps();
    if (agent.power().has_battery()) {
      result.energy_start_j = agent.power().energy_at_start_j();
      result.energy_end_j = agent.power().account().energy_j;
      result.energy_used_j = agent.energy_used_j();
      result.solar_j = agent.solar_j();
      result.external_j = agent.power().view().external_j;
    }
    result.resources = agent.power().resources();
    results.push_back(result);
  }
  return results;
}

std::vector<std::string> Simulation::assumptions() const {
  std::vector<std::string> assumptions;
  for (const auto& [key, vehicle] : vehicles_) {
    for (const std::string& assumption : vehicle.assumptions) {
      // Configurations of one type share their assumptions.
      if (std::ranges::find(assumptions, assumption) == assumptions.end()) {
        assumptions.push_back(assumption);
      }
    }
  }
  const bool has_routes = std::ranges::any_of(
      routes_ahead_, [](const RoverRoutesAhead& way) { return !way.legs.empty(); });
  if (has_routes) {
    assumptions.push_back(
        "planned routes: wheels share the load evenly, and all roll when turning on the spot");
  }
  add_light_assumptions(assumptions);
  if (setup_.terrain.is_synthetic) {
    const bool is_placed = std::holds_alternative<ReliefSurface>(setup_.terrain.layers.back());
    assumptions.push_back(fmt::format("{}: the terrain is synthetic{}", setup_.terrain.name,
                                      is_placed
                                          ? ": landforms at their places, no measured heights"
                                          : " and laid out from the start of the first rover"));
  }
  return assumptions;
}

std::string Simulation::save() {
  Archive a = Archive::writer();
  a.tag("simulation")(now_)(is_finished_)(warnings_);
  for (StandingAsset& asset : assets_) a(asset.sun);
  if (sun_over_end_) a(*sun_over_end_);
  if (sight_) sight_->archive(a);
  a(assets_logged_);
  for (Rover& rover : rovers_) {
    a (*rover.agent)(rover.wake)(rover.logged);
    rover.sequence.archive(a, *host_);
  }
  return a.bytes();
}

void Simulation::restore(const std::string& bytes) {
  Archive a = Archive::reader(bytes);
  a.tag("simulation")(now_)(is_finished_)(warnings_);
  for (StandingAsset& asset : assets_) a(asset.sun);
  if (sun_over_end_) a(*sun_over_end_);
  if (sight_) sight_->archive(a);
  a(assets_logged_);
  for (Rover& rover : rovers_) {
    a (*rover.agent)(rover.wake)(rover.logged);
    rover.sequence.archive(a, *host_);
  }
  if (!a.is_exhausted()) throw Archive::Mismatch("saved state is longer than the program expects");
}

}  // namespace lsos
