// Map of the ground under a mission for its report: relief, and the shadow at a given time.
#pragma once

#include <optional>

#include "product/report.h"
#include "terrain/ground.h"

namespace lsos {

// The map covers all that was drawn, planned and driven; absent where there is nothing of these.
// `shadow_at`: since the start.
std::optional<ReportMap> report_map(const Ground& ground, const ReportData& data, SimTime shadow_at,
                                    int threads);

}  // namespace lsos
