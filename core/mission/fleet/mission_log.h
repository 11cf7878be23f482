// The log of a mission: which rows are written at an exchange, and in which order.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "mission/fleet/fleet_sight.h"
#include "record/log.h"

namespace lsos {

class MissionLog {
 public:
  explicit MissionLog(const MissionInfo& mission)
      : interval_(mission.log_interval), parked_interval_(mission.parked_log_interval) {}

  // Sets the log that rows are written to, nullptr for none; a new log receives the events that
  // have started or ended by then.
  void set_writer(LogWriter* writer, Fleet& fleet);
  bool is_open() const { return writer_ != nullptr; }
  // Sets the listener that is called with each note.
  void set_listener(std::function<void(const NoteRow&)> listener) {
    listener_ = std::move(listener);
  }

  // Writes the rows of an exchange; `sight` may be nullptr.
  void write(Fleet& fleet, const FleetSight* sight, const Moment& moment);
  void write(const NoteRow& note);
  // Notes since they were last written.
  void write_notes(Fleet& fleet, SimTime now);
  // Notes, events, phases and planned legs since they were last written.
  void write_changes(Fleet& fleet, SimTime now);
  void write(const std::vector<SightIntervalRow>& intervals);
  // Writes the last samples, open intervals of sight, and the events that had no turn.
  void finish(Fleet& fleet, FleetSight* sight, const Moment& moment);
  // When a rover's next sample is due.
  SimTime next_sample(const FleetRover& rover, SimTime now) const;

  void archive(Archive& a) { LSOS_ARCHIVE(a, assets_logged_); }

 private:
  bool is_due(const FleetRover& rover, SimTime now) const;
  SimTime interval(const FleetRover& rover) const;
  void write_notes(RoverAgent& agent, SimTime now);
  void write_changes(FleetRover& rover, SimTime now);
  void write_sample(Fleet& fleet, const FleetSight* sight, const Moment& moment,
                    std::size_t number);
  void write_pairs(const Fleet& fleet, const FleetSight& sight, const Moment& moment,
                   std::size_t from);

  SimTime interval_, parked_interval_;
  LogWriter* writer_ = nullptr;
  std::function<void(const NoteRow&)> listener_;
  std::optional<SimTime> assets_logged_;  // when pairs of assets were last logged
  // The last that were written, by rover and part. Not saved: a log that goes on has them again.
  std::map<std::pair<std::string, std::string>, OrderRow> last_orders_;
};

}  // namespace lsos
