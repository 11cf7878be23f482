// Writes report.html of a run from its log, with a map and pictures from its plan's scripts and
// terrain.
#pragma once

#include <map>
#include <string>

#include "picture/picture_run.h"
#include "product/report.h"
#include "product/summary.h"

namespace lsos {

struct ReportRequest {
  SimTime shadow_at{};  // time of the map's shadow, since the start
  bool has_pictures = true;
  int threads = 2;
  std::string estimate = {};  // text of estimate.json, "" for none
};

// Batteries of the rovers that have one, by rover id.
std::map<std::string, ReportBattery> report_batteries(const MissionModel& files);

// `run`: the run's files and ground. Without ground there is neither map nor picture, and
// `left_out` states why. `summary`: text of summary.json, "" for none. Texts for all else that is
// left out are added.
std::string report_of(PictureRun run, const LogReader& log, const std::string& summary,
                      const ReportRequest& request, std::vector<std::string>& left_out);

// Writes DIR/report.html of a run that has just ended; beside its results stands the estimate where
// DIR has one.
void write_report(const std::string& run_dir, const MissionModel& files, const Ground& ground,
                  const RunSummary& summary, ReportRequest request);

}  // namespace lsos
