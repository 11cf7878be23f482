// Runs a plan with the program and reads its results.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "record/log.h"
#include "system/run_folder.h"

namespace lsos::test {

// A run of a plan; owns the folder of its results.
struct PlanRun {
  explicit PlanRun(const std::vector<Mark>& plan, const Words& options = {}) {
    Words words{"run",        folder.write("plan.kml", kml(plan)), "-o", folder / "run", "--quiet",
                "--no-report"};
    words.insert(words.end(), options.begin(), options.end());
    outcome = test::run(words);
  }
  std::vector<SampleRow> samples() const { return log().samples(); }
  LogReader log() const { return LogReader(folder / "run" / "log.gpkg"); }
  nlohmann::json summary() const { return test::summary(folder / "run"); }

  TempFolder folder;
  Outcome outcome;
};

}  // namespace lsos::test
