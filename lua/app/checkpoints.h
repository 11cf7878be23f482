// When a run writes checkpoints: at its start, each minute of wall time, where --checkpoint-every
// asks for one, and when a signal stops it.
#pragma once

#include <chrono>

#include "lua/host/saved_mission.h"
#include "mission/simulation.h"
#include "record/log.h"

namespace lsos {

// Wall time from then until now.
double seconds_since(std::chrono::steady_clock::time_point begin);

class Checkpoints {
 public:
  // `log` must outlive it. `mission`: what each holds besides the state. `wall_before_s`: wall time
  // that the run has taken so far, also before it was resumed.
  Checkpoints(LogWriter& log, SavedMission mission, bool is_on, double wall_before_s = 0);

  bool is_on() const { return is_on_; }
  // Each to be called between exchanges.
  void start(Simulation& simulation);
  // Writes none now: the simulation has just been restored from one.
  void go_on(const Simulation& simulation);
  void write_if_due(Simulation& simulation);
  void stop(Simulation& simulation);
  // Wall time that the run has taken.
  double wall_s() const;

 private:
  using Clock = std::chrono::steady_clock;

  void write(Simulation& simulation, CheckpointKind kind);

  LogWriter& log_;
  SavedMission mission_;
  bool is_on_;
  double wall_before_s_;
  Clock::time_point begin_ = Clock::now(), written_ = begin_;
  SimTime last_{};  // when the last was written
};

}  // namespace lsos
