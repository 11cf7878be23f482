#include "mission/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mission/fleet/avoidance.h"
#include "mission/fleet/convoy.h"
#include "mission/fleet/power_sharing.h"
#include "mission/fleet/solids.h"
#include "mission/light/sky_view.h"
#include "mission/model/mission_span.h"
#include "mission/model/site.h"

namespace lsos {

namespace {

// A rover that is not at rest this long after its last event is taken to slide for ever; the
// mission then ends without waiting for it.
constexpr SimTime coming_to_rest{60'000'000};

}  // namespace

Simulation::Simulation(SimulationSetup setup)
    : setup_(std::move(setup)),
      site_(make_site(setup_)),
      log_(setup_.plan.mission),
      pool_(std::min(setup_.threads, static_cast<int>(setup_.plan.rovers.size()))) {
  site_.legs->set_keeper(setup_.cache_legs);
  fleet_.assets = place_assets(setup_, site_);
  build();
  Faults faults = place_rovers(fleet_, machine_, *site_.ground, *host_, setup_.starts);
  throw_with_advice(faults);
  keep_tracks(fleet_, machine_);
  plan_routes();
  make_light_and_sight();
}

Simulation::~Simulation() = default;

void Simulation::build() {
  fleet_.rovers.clear();
  host_ = setup_.make_host();
  machine_ = synthesise(setup_.plan, host_->declarations());
  for (const RoverMachine& rover : machine_.rovers) {
    fleet_.rovers.push_back(
        {std::make_unique<RoverAgent>(rover.rover, setup_.rover_models.at(rover.rover.model()),
                                      site_.vehicle(rover.rover), *site_.ground, site_.sources,
                                      *site_.legs, static_cast<const Surroundings&>(*this)),
         EventSequence(rover, *site_.ground)});
    if (!setup_.is_estimate) continue;
    fleet_.rovers.back().agent->foresee_drives();
    fleet_.rovers.back().sequence.wait_coarsely();
  }
  hand_out_routes();
}

void Simulation::hand_out_routes() {
  for (std::size_t i = 0; i < routes_ahead_.rovers.size(); ++i) {
    fleet_.rovers[i].agent->routes().set_ahead(routes_ahead_.rovers[i].legs);
  }
}

void Simulation::make_light_and_sight() {
  if (setup_.is_preparation) return;
  const auto has_panels = [](const StandingAsset& asset) { return !asset.model.panels.empty(); };
  const auto needs_sun = [](const FleetRover& rover) { return rover.agent->power().needs_sun(); };
  const bool is_lit = std::ranges::any_of(fleet_.rovers, needs_sun) ||
                      std::ranges::any_of(fleet_.assets, has_panels);
  const bool is_earth_seen = site_.ground->site().body().name != earth_id;
  const bool has_sight =
      setup_.keeps_sight && (fleet_.rovers.size() + fleet_.assets.size() > 1 || is_earth_seen);
  if (is_lit || has_sight) renderer_ = std::make_unique<Renderer>();
  if (is_lit) {
    sunlight_ =
        std::make_unique<FleetSunlight>(*site_.ground, *renderer_, setup_.terrain.optical_depth,
                                        setup_.terrain.albedo, setup_.is_estimate);
  }
  if (!has_sight) return;
  sight_ = std::make_unique<FleetSight>(*site_.ground, *renderer_, fleet_, setup_.is_estimate);
}

// Warnings about the ground explain errors that it causes, so they are reported together.
void Simulation::throw_with_advice(Faults& faults) const {
  if (!faults.has_errors()) return;
  faults.add(site_.ground->advice());
  throw InputError(faults.sorted());
}

// Rovers that stand in each other are told of together with legs that have no route.
void Simulation::plan_routes() {
  Faults faults;
  faults.add(overlapping_rovers(fleet_, machine_));
  if (setup_.plans_ahead) {
    routes_ahead_ = lsos::plan_routes(fleet_, machine_, site_, setup_, *host_);
    hand_out_routes();
    // Legs are kept also when one has no route: finding that out takes longest.
    if (setup_.cache_legs) setup_.cache_legs(site_.legs->kept());
    faults.add(routes_ahead_.faults);
  }
  throw_with_advice(faults);
}

void Simulation::start() {
  for (FleetRover& rover : fleet_.rovers) {
    rover.agent->routes().log_ahead(rover.agent->id(), now_);
    rover.agent->observe(now_);
  }
  // Sunlight and sight are evaluated first, so that the first decisions of scripts know them.
  update_light_and_sight();
  for (FleetRover& rover : fleet_.rovers) rover.agent->update_flows();
  exchange();
}

void Simulation::update_light_and_sight() {
  if (sunlight_) sunlight_->update(fleet_, moment());
  if (sight_) log_.write(sight_->update(fleet_, moment()));
}

void Simulation::advance(std::optional<SimTime> until) {
  if (is_finished_) return;
  const SimTime next = until ? std::min(*until, next_time()) : next_time();
  if (next > setup_.plan.mission.max_duration) {
    // The clock stops at the last exchange within MaxDuration.
    now_ = setup_.plan.mission.max_duration - setup_.plan.mission.max_duration % exchange_period;
    for (FleetRover& rover : fleet_.rovers) rover.agent->update_energy(now_);
    stop(setup_.plan.mission.has_max_duration
             ? "MaxDuration is over"
             : fmt::format("MaxDuration is over, {:.0f} h by default",
                           seconds(setup_.plan.mission.max_duration) / 3600));
    return;
  }
  LSOS_ASSERT(next > now_);
  std::vector<RoverAgent*> active;
  for (FleetRover& rover : fleet_.rovers) {
    if (!rover.agent->is_parked()) active.push_back(rover.agent.get());
  }
  LSOS_ASSERT(active.empty() || next == now_ + exchange_period);
  pool_.for_each(active.size(), [&](std::size_t i) { active[i]->advance(); });
  now_ = next;
  exchange();
}

SimTime Simulation::next_time() const {
  std::optional<SimTime> wake, next;
  bool may_wake = false;
  const auto earlier = [](std::optional<SimTime>& first, std::optional<SimTime> other) {
    if (other && (!first || *other < *first)) first = other;
  };
  for (const FleetRover& rover : fleet_.rovers) {
    const RoverAgent& agent = *rover.agent;
    if (!agent.is_parked() || agent.drive().is_to_pursue()) return now_ + exchange_period;
    may_wake |= rover.wake || agent.power().waits_for_reserve();
    may_wake |= rover.sequence.waits_for_charge() || agent.drive().is_carried();
    earlier(wake, rover.wake);
    earlier(wake, quiet_wake(rover));
    earlier(next, log_.next_sample(rover, now_));
  }
  if (!may_wake || !wake) {
    // Every rover waits for another. Cycles in the plan are found before the run, so a script waits
    // for something that never comes: until MaxDuration nothing happens but rows of the log.
    wake = setup_.plan.mission.max_duration + exchange_period;
  }
  return log_.is_open() ? std::min(*wake, *next) : *wake;
}

void Simulation::exchange() {
  for (FleetRover& rover : fleet_.rovers) {
    rover.was_parked = rover.agent->is_parked();
    const bool has_arrived = rover.agent->observe(now_);
    rover.agent->update_energy(now_);
    take_warnings(rover);  // also for a rover whose events are over
    const bool is_news = rover.agent->power().has_news() || has_arrived;
    if (is_news && !rover.sequence.is_finished()) rover.wake = now_;
  }
  lead_followers(fleet_, now_);
  avoid_rovers(fleet_);
  avoid_assets(fleet_);
  run_scripts();
  for (FleetRover& rover : fleet_.rovers) rover.agent->control();
  for (const FleetRover& rover : fleet_.rovers) {
    if (rover.sequence.aborts_mission().empty()) continue;
    stop(fmt::format("'{}' of {} failed and aborts the mission", rover.sequence.aborts_mission(),
                     rover.agent->id()),
         true);
    break;
  }
  // The motion of all rovers is set before any is evaluated, so that their order does not matter.
  for (FleetRover& rover : fleet_.rovers) rover.motion = motion_of(rover, now_);
  update_light_and_sight();
  share_power(fleet_, sunlight_.get(), moment());
  for (FleetRover& rover : fleet_.rovers) rover.agent->settle_energy();
  // Rovers that still roll come to rest first, so that the last rows show where they stop.
  is_finished_ = is_finished_ || std::ranges::all_of(fleet_.rovers, [&](const FleetRover& rover) {
                   return rover.sequence.is_finished() &&
                          (rover.agent->is_parked() ||
                           now_ - rover.sequence.records().last_end() > coming_to_rest);
                 });
  if (is_finished_) {
    for (FleetRover& rover : fleet_.rovers) rover.sequence.close(now_);
  }
  log_.write(fleet_, sight_.get(), moment());
  if (setup_.save_every_exchange) save_and_restore();
}

Turn Simulation::turn_of(const FleetRover& rover) const {
  return {now_, machine_.mission, *rover.agent, *host_, fleet_};
}

void Simulation::run_scripts() {
  // Notes wait in their rovers until the exchange ends, but not more of them than this.
  constexpr std::size_t note_bytes_max = std::size_t{16} << 20;
  std::size_t note_bytes = 0;
  const std::size_t ended_before = fleet_.events_ended();
  for (FleetRover& rover : fleet_.rovers) {
    const bool is_due = rover.wake && *rover.wake <= now_;
    if ((rover.sequence.is_finished() || rover.agent->is_parked()) && !is_due) continue;
    rover.sequence.run(turn_of(rover));
    rover.wake = rover.sequence.wake(now_, machine_.mission.start_time);
    take_warnings(rover);
    note_bytes += rover.agent->journal().note_bytes();
    if (note_bytes > note_bytes_max) {
      log_.write_notes(fleet_, now_);
      note_bytes = 0;
    }
  }
  // An event that waits for one that has ended may start at the next exchange.
  if (fleet_.events_ended() == ended_before) return;
  for (FleetRover& rover : fleet_.rovers) {
    if (!rover.sequence.is_finished()) {
      rover.wake = std::min(rover.wake.value_or(now_ + exchange_period), now_ + exchange_period);
    }
  }
}

void Simulation::stop(const std::string& reason, bool is_failure) {
  for (FleetRover& rover : fleet_.rovers) {
    rover.sequence.stop(turn_of(rover), reason, is_failure);
    take_warnings(rover);
  }
  is_finished_ = true;
}

void Simulation::take_warnings(FleetRover& rover) {
  for (const auto& warnings :
       {rover.sequence.take_warnings(), rover.agent->journal().take_warnings()}) {
    for (const std::string& warning : warnings) warnings_.add(warning);
  }
}

std::vector<EventRow> Simulation::events() const {
  std::vector<EventRow> rows;
  for (const FleetRover& rover : fleet_.rovers) {
    for (std::size_t i = 0; i < rover.sequence.records().size(); ++i) {
      rows.push_back(rover.sequence.row(i));
    }
  }
  return rows;
}

std::vector<RoverResult> Simulation::results() const {
  std::vector<RoverResult> results;
  for (const FleetRover& rover : fleet_.rovers) results.push_back(result_of(rover));
  return results;
}

void Simulation::terminate() {
  log_.write(fleet_, sight_.get(), moment());
  warn_of_ends();
  log_.finish(fleet_, sight_.get(), moment());
}

std::optional<SimTime> Simulation::quiet_wake(const FleetRover& rover) const {
  std::optional<SimTime> wake = rover.agent->power().wake();
  const auto at = [&](std::optional<SimTime> time) {
    if (time) wake = std::min(wake.value_or(*time), *time);
  };
  if (sunlight_) at(sunlight_->wake(*rover.agent, fleet_, now_));
  if (sight_) at(sight_->wake());
  at(rover.agent->antennas().next_end(now_));
  if (setup_.is_estimate) at(foreseen_wake(fleet_, rover, now_));
  const SimTime limbs_rest = rover.agent->limbs_move_until();
  if (limbs_rest > now_) at(round_up_to_exchange(limbs_rest));
  if (wake) wake = std::max(*wake, now_ + exchange_period);
  return wake;
}

SkyView Simulation::sky(const Geodetic& place) const {
  return sky_view(*setup_.plan.mission.planet, place, moment().utc);
}

std::optional<PairSight> Simulation::sight(const std::string& id, const std::string& other) const {
  if (!sight_) return {};
  return sight_->between(fleet_, moment(), id, other);
}

void Simulation::dispatch(const PlanEvent& event) {
  FleetRover* rover = fleet_.find(event.rover_id);
  if (rover == nullptr) {
    throw InputError(event.place, "there is no rover '" + event.rover_id + "'");
  }
  rover->sequence.add({event, host_->declarations().events.at(event.type)});
  rover->wake = now_ + exchange_period;
  is_finished_ = false;
  std::vector<PlanEvent>& events = setup_.plan.events;
  const auto at = std::ranges::find_if(events, [&](const PlanEvent& other) {
    return std::tie(other.rover_id, other.sequence) > std::tie(event.rover_id, event.sequence);
  });
  events.insert(at, event);
  // The default MaxDuration counts the events of the plan alone, so it no longer applies.
  MissionInfo& mission = setup_.plan.mission;
  if (!mission.has_max_duration) mission.max_duration = longest_mission;
}

void Simulation::note_interactive(const std::string& rover_id, const std::string& name,
                                  const std::string& fields_json) {
  const FleetRover* rover = fleet_.find(rover_id);
  LSOS_ASSERT(rover != nullptr);
  log_.write(NoteRow{now_, rover_id, 0, name, fields_json, rover->agent->motion().place()});
}

void Simulation::archive(Archive& a) {
  a.tag("simulation");
  LSOS_ARCHIVE(a, now_, is_finished_, warnings_, log_);
  for (StandingAsset& asset : fleet_.assets) {
    const Archive::Part part(a, asset.plan.id);
    LSOS_ARCHIVE(a, asset.sun);
    if (asset.sun && asset.sun->panels.size() != asset.model.panels.size()) {
      a.refuse("saved state is of other panels");
    }
  }
  if (sunlight_) LSOS_ARCHIVE(a, *sunlight_);
  if (sight_) LSOS_ARCHIVE(a, *sight_);
  for (FleetRover& rover : fleet_.rovers) {
    const Archive::Part part(a, rover.agent->id());
    LSOS_ARCHIVE(a, *rover.agent, rover.wake, rover.logged, rover.is_logged_as_parked);
    rover.sequence.archive(a, *host_);
  }
}

std::string Simulation::save() {
  Archive a = Archive::writer();
  archive(a);
  return a.bytes();
}

void Simulation::take_up(const std::string& bytes) {
  Archive a = Archive::reader(bytes);
  archive(a);
  if (!a.is_exhausted()) throw Archive::Mismatch("saved state is longer than the program expects");
}

bool Simulation::has_sound_convoys() const {
  return std::ranges::all_of(fleet_.rovers, [&](const FleetRover& rover) {
    const std::string id = rover.agent->drive().leader_id();
    const FleetRover* leader = fleet_.find(id);
    return id.empty() || (leader != nullptr && leader->agent->track() &&
                          leader->agent->track()->corner_count() > 0);
  });
}

void Simulation::restore(const std::string& bytes) {
  std::string again;
  try {
    take_up(bytes);
    again = save();
  } catch (const Archive::Mismatch&) {
    throw;
  } catch (const std::exception& error) {
    throw Archive::Mismatch(fmt::format("saved state cannot be taken up: {}", error.what()));
  }
  const auto refuse = [](const std::string& what) {
    throw Archive::Mismatch("saved state " + what);
  };
  if (again != bytes) {
    refuse(fmt::format("holds what is not saved so, in {}",
                       first_difference(bytes, again, [&](Archive& a) { archive(a); })));
  }
  if (!has_sound_convoys()) refuse("holds a rover that follows nobody");
  const bool is_time = now_ >= SimTime{} && now_ % exchange_period == SimTime{};
  if (!is_time || (!is_finished_ && next_time() <= now_)) refuse("is of no moment of the mission");
}

void Simulation::save_and_restore() {
  const std::string state = save();
  build();
  take_up(state);
  const std::string again = save();
  if (again == state) return;
  throw InternalError(fmt::format("state differs after it was written out and read back, in {}",
                                  first_difference(state, again, [&](Archive& a) { archive(a); })));
}

}  // namespace lsos
