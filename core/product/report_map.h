// The ground under a mission as a map for its report: relief, and what lies in shadow at a time.
#pragma once

#include <optional>

#include "product/report.h"
#include "terrain/ground.h"

namespace lsos {

// All that was drawn, planned and driven lies on it; absent where there is nothing of that.
// `shadow_at`: since the start.
std::optional<ReportMap> report_map(const Ground& ground, const ReportData& data, SimTime shadow_at,
                                    int threads);

}  // namespace lsos
