#include "mission/ahead/mission_work.h"

#include <algorithm>

#include "mission/ahead/expected_time.h"
#include "mission/model/event_times.h"

namespace lsos {

namespace {

// Less of a drive, planned or simulated, says little of the rest.
constexpr double planned_least_s = 120, wall_least_s = 2;

}  // namespace

void add_work(const RoverMachine& machine, const EventRecords& records, const RoverModel& model,
              const MissionInfo& mission, SimTime now, double share, bool is_finished,
              MissionWork& work) {
  const VehicleConfig& vehicle = model.spec.vehicle;
  const Body& body = *mission.planet;
  Geodetic at = machine.rover.start;
  SimTime end = now;
  for (std::size_t k = 0; k < machine.events.size(); ++k) {
    const auto& [event, declaration] = machine.events[k];
    if (!event.is_enabled) continue;
    const EventRecord& record = records[k];
    double drive_s = 0;
    if (declaration.drives) {
      std::optional<Geodetic> place = at;
      const double length_m = drawn_m(event.geometry, body, place);
      drive_s = length_m / drive_speed_mps(event, declaration, vehicle);
    }
    const bool never_begins = !record.start && (record.end || is_finished);
    const double done = record.end ? 1 : record.start ? share : 0;
    if (!never_begins) {
      work.driven_s += done * drive_s;
      work.to_drive_s += (1 - done) * drive_s;
    }
    if (record.end || never_begins) {
      std::optional<Geodetic> place = at;
      if (declaration.drives) drawn_m(event.geometry, body, place);
      at = *place;
    } else {
      end = expected_end(machine.events[k], vehicle, record.start.value_or(end), mission.start_time,
                         body, at);
      end = std::max(end, now);
    }
  }
  work.stand_until_s = std::max(work.stand_until_s, seconds(end));
}

void TimeLeft::add(double wall_s, double mission_s, bool drives) {
  if (drives) {
    drive_wall_s_ += wall_s;
  } else {
    stand_wall_s_ += wall_s;
    stood_s_ += mission_s;
  }
}

std::optional<double> TimeLeft::left_s(const MissionWork& work, double now_s) const {
  double left_s = 0;
  if (work.to_drive_s > 0) {
    const double driven_s = work.driven_s - driven_at_begin_s_;
    if (driven_s < planned_least_s || drive_wall_s_ < wall_least_s) return std::nullopt;
    left_s += work.to_drive_s * drive_wall_s_ / driven_s;
  }
  if (stood_s_ > 0) {
    // Part of the time to come is driven; what it stands is less, and costs little.
    const double to_stand_s = std::max(0.0, work.stand_until_s - now_s - work.to_drive_s);
    left_s += to_stand_s * stand_wall_s_ / stood_s_;
  }
  return left_s;
}

}  // namespace lsos
