// How the cases of a study are given to the engine of a cluster, as `lsos-host sweep` is told.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lsos {

struct ClusterOptions {
  std::string print;      // the engine whose script is printed; "": none
  bool is_slurm = false;  // the tasks are sent to Slurm
  int chunk = 0;          // cases of a task; 0: default_chunk
  int limit = 0;          // tasks at a time; 0: as many as the engine allows
  std::string time;       // that a task may take, as Slurm writes it; "": the engine's own limit
  std::string partition;  // or queue
  std::vector<std::string> directives;  // further lines of the script's head

  bool is_wanted() const { return is_slurm || !print.empty(); }
};

inline constexpr int default_chunk = 20;

// Throws InputError where an option is wrong, or has no use as no script is wanted.
void check_cluster_options(const ClusterOptions& options);

// Less time would hardly do more than write checkpoints: a task is told to stop two minutes before
// its end, by Slurm up to a minute earlier (`man sbatch`, --signal).
inline constexpr std::int64_t time_min_s = 300;
// Seconds of "90" (minutes), "90:30", "1:30:00", "2-12", "2-12:30" or "2-12:30:00"; absent where it
// is neither, or less than time_min_s.
std::optional<std::int64_t> time_limit_s(const std::string& text);

}  // namespace lsos
