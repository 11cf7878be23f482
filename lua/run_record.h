// What a run leaves behind: its folder with the log, the overlay and the summary.
#pragma once

#include <functional>
#include <string>

#include "lua/mission_files.h"
#include "product/run_folder.h"
#include "product/summary.h"
#include "record/log.h"

namespace lsos {

class RunRecord {
 public:
  // The plan passed its checks: what an earlier run left in the folder goes. `plan_bytes`: what its
  // plan.kml will hold. Throws LogError, InputError.
  RunRecord(RunFolder& folder, const std::string& plan_bytes, const MissionFiles& files,
            Simulation& simulation);

  LogWriter& log() { return log_; }
  // Ends the log; writes overlay and summary, once the simulation has been terminated.
  // `write_more`: what else is made of the log; the summary comes last of all.
  RunSummary finish(const MissionFiles& files, const Simulation& simulation, double wall_s,
                    const std::function<void(const RunSummary&)>& write_more = {});

 private:
  RunFolder& folder_;
  LogWriter log_;
};

}  // namespace lsos
