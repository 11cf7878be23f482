// report.html of a run, from its log, with what its plan's scripts and terrain add: a map,
// pictures.
#pragma once

#include <string>

#include "picture/picture_run.h"
#include "product/report.h"
#include "product/summary.h"

namespace lsos {

struct ReportWish {
  SimTime shadow_at{};  // since the start: of the map
  bool has_pictures = true;
  int threads = 2;
};

// `run`: its files and its ground; without ground there is neither map nor picture, and
// `left_out` says why. `summary`: the text of summary.json, "" for none. What else has to be left
// out is added.
std::string report_of(PictureRun run, const LogReader& log, const std::string& summary,
                      const ReportWish& wish, std::vector<std::string>& left_out);

// DIR/report.html of a run that has just ended.
void write_report(const std::string& run_dir, const MissionModel& files, const Ground& ground,
                  const RunSummary& summary, const ReportWish& wish);

}  // namespace lsos
