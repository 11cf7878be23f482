// The rovers of a mission with their events, and the assets on its ground.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mission/events/event_sequence.h"
#include "mission/port/motion.h"
#include "mission/rover/rover_agent.h"
#include "mission/rover/standing_asset.h"
#include "planet/utc.h"

namespace lsos {

// An exchange: mission time, and the time of day there.
struct Moment {
  SimTime now{};
  Instant utc{};
};

struct FleetRover {
  std::unique_ptr<RoverAgent> agent;
  EventSequence sequence;
  std::optional<SimTime> wake = SimTime{};  // when its scripts are due although it is parked
  std::optional<SimTime> logged = {};       // time of its last sample
  bool is_logged_as_parked = true;          // whether it was parked at the exchange before
  bool was_parked = true;                   // at the start of this exchange; not saved
  Motion motion = Motion::none;             // motion of the rover or its panels now; not saved
};

struct Fleet : EventLookup {
  std::vector<FleetRover> rovers;  // in byte order of their ids
  std::vector<StandingAsset> assets;

  std::vector<std::string> rover_ids() const;
  // Returns nullptr when there is no such rover.
  FleetRover* find(const std::string& rover_id);
  const FleetRover* find(const std::string& rover_id) const;
  // Position of a rover or an asset; absent: nothing has that id.
  std::optional<Vec3> place_S_m(const std::string& id) const;
  // The ground that a rover covers; absent: there is no such rover.
  std::optional<Obstacle> obstacle(const std::string& rover_id) const;
  const EventRecord& record(const PlanEvent::Reference& event) const override;
  std::size_t events_ended() const;
};

}  // namespace lsos
