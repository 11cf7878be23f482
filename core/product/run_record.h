// The files of a run: its folder with the log, the overlay and the summary.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mission/model/mission_model.h"
#include "mission/simulation.h"
#include "product/run_folder.h"
#include "product/summary.h"
#include "record/log.h"

namespace lsos {

// A file that is made from a finished run's log, and can be made again.
struct Product {
  std::string file;     // "report.html"
  std::string command;  // "report": the command that makes it again
  std::function<void(const RunSummary&)> write;
};

class RunRecord {
 public:
  // To be constructed once the plan has passed its checks: what an earlier run left in the folder
  // is removed. `plan_bytes`: contents of the new plan.kml. Throws LogError, InputError.
  RunRecord(RunFolder& folder, const std::string& plan_bytes, const MissionModel& files,
            const std::map<std::string, std::string>& run_values, Simulation& simulation);

  // Goes on with the record of a run in `folder` from a checkpoint of its log; the simulation has
  // been restored from it. What was made of the log so far is removed. Throws LogError, InputError.
  RunRecord(RunFolder& folder, const MissionModel& files, std::int64_t checkpoint_id,
            Simulation& simulation);

  LogWriter& log() { return log_; }
  // Ends the log after the simulation has been terminated and writes the summary, which marks the
  // run as finished; then writes overlay.kml and `more`. For a product that cannot be made, `warn`
  // is called with what is missing and the command that makes it again; the summary's warnings
  // include this too; a signal that comes meanwhile has the same effect on those that are left.
  // `can_resume`: the run was stopped, and its checkpoints stay.
  RunSummary finish(const MissionModel& files, const Simulation& simulation, double wall_s,
                    const std::function<void(const std::string&)>& warn,
                    const std::vector<Product>& more = {}, bool can_resume = false);

 private:
  RunFolder& folder_;
  LogWriter log_;
};

}  // namespace lsos
