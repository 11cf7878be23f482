// Checkpoints of a run: moments from which it can go on. They lie in an internal table of its log,
// each written in one transaction with the rows up to its moment, and are no part of the digest.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/sim_time.h"

namespace lsos {

enum class CheckpointKind {
  recent,  // the last few are kept until the run ends
  kept,    // stays in the log of a finished run
  stop,    // where a signal stopped the run
};
constexpr CheckpointKind last_value(CheckpointKind) { return CheckpointKind::stop; }

struct Checkpoint {
  SimTime time{};
  CheckpointKind kind = CheckpointKind::recent;
  double wall_s = 0;  // wall time that the run had taken
  std::string state;  // of the simulation, opaque here
};

// Where a run left another one.
struct BranchOrigin {
  std::string folder;      // of the other run
  std::string log_sha256;  // of its log; "": it was unfinished
  SimTime time{};
  std::string changes;  // what was changed there ("with dust.lua, measured t.csv"); "": nothing
};

// A checkpoint without its state.
struct CheckpointEntry {
  std::int64_t id = 0;  // counts up in the order of writing
  SimTime time{};
  CheckpointKind kind = CheckpointKind::recent;
};

// A checkpoint as the log holds it: also the last fid of each layer at that moment, in the order of
// contract_layers(), and that of the orders.
struct StoredCheckpoint : Checkpoint {
  std::vector<std::int64_t> last_fids;
};

}  // namespace lsos
