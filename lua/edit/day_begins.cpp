#include "lua/edit/day_begins.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/sim_time.h"
#include "lua/host/mission_reader.h"
#include "mission/mission_estimate.h"
#include "mission/rover/rover_posture.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// What a rover is like beside what a plan says, in words.
std::vector<std::string> state_of(const RoverAgent& agent, SimTime now) {
  std::vector<std::string> state;
  const PanelArray& panels = agent.power().panels();
  for (std::size_t i = 0; i < panels.specs().size(); ++i) {
    const std::string name = quoted(panels.specs()[i].name);
    state.push_back(fmt::format("panel {} is {}", name, panels.is_stowed(i) ? "stowed" : "up"));
    const Steering& steering = panels.steering(i);
    if (steering.mode == SteerMode::track)
      state.push_back(fmt::format("panel {} tracks the Sun", name));
    if (steering.mode == SteerMode::point) {
      state.push_back(fmt::format("panel {} is pointed over the ground", name));
    }
  }
  const AntennaArray& antennas = agent.antennas();
  for (std::size_t i = 0; i < antennas.specs().size(); ++i) {
    state.push_back(fmt::format("antenna {} is {}", quoted(antennas.specs()[i].name),
                                antennas.is_up(i, now) ? "up" : "stowed"));
  }
  for (const auto& [name, amount] : agent.power().resources()) {
    state.push_back(fmt::format("resource {} is at {:.4g}", quoted(name), amount));
  }
  const double clearance_m = posture_clearance_m(agent.motion().vehicle());
  if (!std::isnan(clearance_m)) {
    state.push_back(fmt::format("its chassis is {:.2f} m over the ground", clearance_m));
  }
  return state;
}

// Events by whether they are of earlier days.
class DayWatch {
 public:
  DayWatch(const Simulation& simulation, int day, const EventDays& days)
      : simulation_(simulation), begin_((day - 1) * day_length) {
    for (const FleetRover& rover : simulation.fleet().rovers) {
      Watched& watched = rovers_.emplace_back();
      watched.state_at_start = state_of(*rover.agent, simulation.now());
      for (const EventMachine& event : rover.sequence.events()) {
        const bool takes_part = event.event.is_enabled && !event.event.at;
        const bool is_earlier =
            takes_part && days.at({event.event.rover_id, event.event.sequence}) < day;
        watched.is_earlier.push_back(is_earlier);
        watched.is_of_day.push_back(takes_part && !is_earlier);
      }
    }
  }

  // Just before the day begins: with it, events of the day may begin.
  SimTime eve() const { return begin_ - exchange_period; }

  // After each exchange. Returns whether the begin of every rover is known.
  bool look() {
    bool are_all = true;
    for (std::size_t k = 0; k < rovers_.size(); ++k) {
      if (!rovers_[k].is_known && is_over(k)) take(k);
      are_all &= rovers_[k].is_known;
    }
    return are_all;
  }

  std::map<std::string, DayBegin> begins() const {
    std::map<std::string, DayBegin> begins;
    for (std::size_t k = 0; k < rovers_.size(); ++k) {
      if (rovers_[k].is_known) begins[rover(k).agent->id()] = rovers_[k].begin;
    }
    return begins;
  }

 private:
  struct Watched {
    std::vector<bool> is_earlier, is_of_day;  // by event
    std::vector<std::string> state_at_start;
    std::string under_way;
    bool is_known = false;
    DayBegin begin;
  };

  const FleetRover& rover(std::size_t k) const { return simulation_.fleet().rovers[k]; }

  // Whether the days before are over for a rover: the day is about to begin, and its earlier events
  // have ended; or, before that, an event of the day has begun.
  bool is_over(std::size_t k) {
    const std::vector<EventRecord>& records = rover(k).sequence.records().all();
    bool is_over = simulation_.now() >= eve();
    for (std::size_t i = 0; i < records.size(); ++i) {
      if (rovers_[k].is_earlier[i] && !records[i].has_ended()) {
        is_over = false;
        if (simulation_.now() >= begin_)
          rovers_[k].under_way = rover(k).sequence.events()[i].event.label;
      }
      if (rovers_[k].is_of_day[i] && records[i].start) return true;
    }
    return is_over;
  }

  void take(std::size_t k) {
    Watched& watched = rovers_[k];
    const RoverAgent& agent = *rover(k).agent;
    watched.is_known = true;
    watched.begin.place = agent.motion().place();
    watched.begin.heading_rad = agent.motion().report().heading_rad;
    if (agent.power().has_battery()) watched.begin.charge = agent.power().view().charge;
    if (simulation_.now() > begin_) watched.begin.under_way = watched.under_way;
    for (std::string& what : state_of(agent, simulation_.now())) {
      if (std::ranges::count(watched.state_at_start, what) == 0) {
        watched.begin.not_in_plan.push_back(std::move(what));
      }
    }
  }

  const Simulation& simulation_;
  SimTime begin_;
  std::vector<Watched> rovers_;
};

}  // namespace

std::map<std::string, DayBegin> day_begins(const MissionFiles& files, int day,
                                           const EventDays& days) {
  SimulationSetup setup = simulation_setup(files);
  setup.is_estimate = true;
  setup.threads = 2;
  Simulation simulation(std::move(setup));
  DayWatch watch(simulation, day, days);
  simulation.start();
  for (long long exchanges = 0; !watch.look() && !simulation.is_finished(); ++exchanges) {
    // Nobody waits for what would take a hundred days more.
    const bool is_late = simulation.now() > watch.eve() + 100 * day_length;
    if (is_late || exchanges >= exchanges_max) break;
    if (simulation.now() < watch.eve()) {
      simulation.advance(watch.eve());
    } else {
      simulation.advance();
    }
  }
  return watch.begins();
}

}  // namespace lsos
