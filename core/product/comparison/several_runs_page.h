// The page of several runs over each other: plots, one map, and a table of what differs an event.
#pragma once

#include <string>
#include <vector>

#include "picture/picture_run.h"
#include "product/report_run.h"
#include "record/log.h"

namespace lsos {

struct RunOfPage {
  std::string folder;
  const LogReader* log = nullptr;
  std::string summary;  // text of summary.json; "" for a run that has not finished
  PictureRun opened;    // only the first one's ground is used
};

// Throws InputError where the runs are not of one planet. `left_out`: parts that are missing from
// the page, and why.
std::string several_runs_page(std::vector<RunOfPage> runs, const ReportRequest& request,
                              const std::vector<std::string>& left_out);

}  // namespace lsos
