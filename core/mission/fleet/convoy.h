// Rovers that follow others: tracks are recorded, and followers are told where their leaders are.
#pragma once

#include "mission/fleet/fleet.h"

namespace lsos {

// Has the rovers that events of the plan follow record their tracks from now on.
void keep_tracks(Fleet& fleet, const MissionMachine& machine);

// At an exchange, after all rovers were read: records tracks, and has each follower keep its
// distance to its leader. What counts of the leader's events is whether they had ended at the
// exchange before.
// Wakes the scripts of a follower whose drive ends by that: a parked one would hear of it from
// nothing else.
void lead_followers(Fleet& fleet, SimTime now);

// In an estimate: when a rover must take part because of its foreseen drive; absent: it has none.
std::optional<SimTime> foreseen_wake(const Fleet& fleet, const FleetRover& rover, SimTime now);

}  // namespace lsos
