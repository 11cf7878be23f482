// The plots of a run as a figure for a paper: position, relative elevation, energy and energy rate,
// with the record of events as bars.
#pragma once

#include <string>

#include "product/report_data.h"

namespace lsos {

inline constexpr int figure_dpi = 300;

// A PNG, 18 cm wide.
std::string figure_png(const ReportData& data, int dpi);

}  // namespace lsos
