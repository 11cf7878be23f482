// A Slurm of one node on the loopback, for tests. Jobs of its partition "urgent" take the place of
// those in "main", which are told and have a minute to end.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {

class OwnSlurm {
 public:
  // Whether its programs are installed: script/bootstrap long.
  static bool is_installed();

  // Starts munged, slurmctld and slurmd in a folder under /tmp; is_up() says whether the node has
  // come up.
  explicit OwnSlurm(int array_size_max);
  // Ends all jobs, then the daemons.
  ~OwnSlurm();
  OwnSlurm(const OwnSlurm&) = delete;
  OwnSlurm& operator=(const OwnSlurm&) = delete;

  bool is_up() const { return is_up_; }
  // What its programs must find in their environment.
  std::string environment() const { return "SLURM_CONF=" + (folder_ / "slurm.conf").string(); }
  // What a program of Slurm prints.
  std::string ask(const Words& words) const;
  // "RUNNING", "PENDING", ... of a job, or of a task "12_1"; "" once it is gone.
  std::string state_of(const std::string& job) const;
  // The last lines of its logs.
  std::string logs() const;

 private:
  TempFolder folder_;
  std::unique_ptr<Process> munged_, controller_, node_;
  bool is_up_ = false;
};

// Whether the condition holds within some time, looked at often.
bool comes_true(const std::function<bool()>& condition, int within_s);

}  // namespace lsos::test
