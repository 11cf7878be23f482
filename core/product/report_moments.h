// Selects the times of a run that its report has pictures of: the start, stops in the Sun, the end,
// and the first failure.
#pragma once

#include <string>
#include <vector>

#include "product/report_data.h"
#include "record/log.h"

namespace lsos {

struct ReportMoment {
  SimTime time{};
  std::string rover_id;
  std::string title;
  bool is_solar = false;  // its panels were up: the view from the Sun is shown too
};

// Moments in order of time, some dozen at most. A text for what had to be left out is added to
// `left_out`.
std::vector<ReportMoment> report_moments(const LogReader& log, const ReportData& data,
                                         std::vector<std::string>& left_out);

}  // namespace lsos
