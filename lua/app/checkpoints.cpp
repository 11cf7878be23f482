#include "lua/app/checkpoints.h"

#include <utility>

namespace lsos {

namespace {

// What a kill costs at most.
constexpr std::chrono::minutes wall_period{1};

}  // namespace

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

Checkpoints::Checkpoints(LogWriter& log, SavedMission mission, bool is_on, double wall_before_s)
    : log_(log), mission_(std::move(mission)), is_on_(is_on), wall_before_s_(wall_before_s) {}

void Checkpoints::start(Simulation& simulation) {
  if (!is_on_ || simulation.is_finished()) return;
  const bool is_kept = mission_.every > SimTime{};
  write(simulation, is_kept ? CheckpointKind::kept : CheckpointKind::recent);
}

void Checkpoints::go_on(const Simulation& simulation) { last_ = simulation.now(); }

void Checkpoints::write_if_due(Simulation& simulation) {
  if (!is_on_ || simulation.is_finished()) return;
  const bool is_kept =
      mission_.every > SimTime{} && simulation.now() / mission_.every > last_ / mission_.every;
  if (is_kept) {
    write(simulation, CheckpointKind::kept);
  } else if (Clock::now() - written_ >= wall_period) {
    write(simulation, CheckpointKind::recent);
  }
}

void Checkpoints::stop(Simulation& simulation) {
  if (is_on_) write(simulation, CheckpointKind::stop);
}

double Checkpoints::wall_s() const { return wall_before_s_ + seconds_since(begin_); }

void Checkpoints::write(Simulation& simulation, CheckpointKind kind) {
  mission_.state = simulation.save();
  log_.write(Checkpoint{simulation.now(), kind, wall_s(), to_bytes(mission_)});
  last_ = simulation.now();
  written_ = Clock::now();
}

}  // namespace lsos
