// What a run leaves behind: its folder with the log, the overlay and the summary.
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

// A file that is made of a finished run's log, and can be made again.
struct Product {
  std::string file;     // "report.html"
  std::string command;  // "report": the command that makes it again
  std::function<void(const RunSummary&)> write;
};

class RunRecord {
 public:
  // The plan passed its checks: what an earlier run left in the folder goes. `plan_bytes`: what its
  // plan.kml will hold. `run_values`: the layer `run`. Throws LogError, InputError.
  RunRecord(RunFolder& folder, const std::string& plan_bytes, const MissionModel& files,
            const std::map<std::string, std::string>& run_values, Simulation& simulation);

  LogWriter& log() { return log_; }
  // Ends the log once the simulation has been terminated and writes the summary, with which the run
  // is finished; then overlay.kml and `more`. Of a product that cannot be made `warn` is told what
  // is missing and which command makes it again, and the summary's warnings have it.
  RunSummary finish(const MissionModel& files, const Simulation& simulation, double wall_s,
                    const std::function<void(const std::string&)>& warn,
                    const std::vector<Product>& more = {});

 private:
  RunFolder& folder_;
  LogWriter log_;
};

}  // namespace lsos
