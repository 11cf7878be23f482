// What a mission has done and has yet to do by its plan, for an estimate of the time that its
// simulation takes: where rovers drive it takes much, where all stand next to nothing.
#pragma once

#include <optional>

#include "mission/events/event_record.h"
#include "mission/model/machine.h"
#include "mission/model/rover_model.h"

namespace lsos {

// Drives count by the drawn length at the requested speed, summed over rovers.
struct MissionWork {
  double driven_s = 0, to_drive_s = 0;
  double stand_until_s = 0;  // expected end of the mission, since its start, s
};

// Adds the events of one rover. `share`: of the drive under way that is done, 0..1. `is_finished`:
// what has not begun never will.
void add_work(const RoverMachine& machine, const EventRecords& records, const RoverModel& model,
              const MissionInfo& mission, SimTime now, double share, bool is_finished,
              MissionWork& work);

// Time that is left of a simulation, from what its steps have taken so far.
class TimeLeft {
 public:
  // `at_begin`: where it stands when the first step begins.
  explicit TimeLeft(const MissionWork& at_begin) : driven_at_begin_s_(at_begin.driven_s) {}

  // A step took `wall_s` for `mission_s` of the mission. `drives`: a rover moved.
  void add(double wall_s, double mission_s, bool drives);
  // Wall seconds; nullopt until enough has been driven to tell.
  std::optional<double> left_s(const MissionWork& work, double now_s) const;

 private:
  double driven_at_begin_s_;
  double drive_wall_s_ = 0;
  double stand_wall_s_ = 0, stood_s_ = 0;
};

}  // namespace lsos
