// The page of telemetry over a run: measured points on the run's curves, and their residuals.
#pragma once

#include <string>
#include <vector>

#include "picture/picture_run.h"
#include "product/comparison/residuals.h"
#include "product/report_run.h"

namespace lsos {

// `run`: as for report_of. `left_out`: parts that are missing from the page, and why.
std::string telemetry_page(const PictureRun& run, const LogReader& log, const std::string& summary,
                           const Telemetry& telemetry, const Residuals& found,
                           const ReportRequest& request, const std::vector<std::string>& left_out);

}  // namespace lsos
