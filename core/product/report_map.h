// Map of the ground under a mission for its report: relief, and the shadow at a given time.
#pragma once

#include <optional>

#include "product/report.h"
#include "terrain/ground.h"

namespace lsos {

// The map covers all that was drawn, planned and driven, and `also`; absent where there is nothing
// of these. `shadow_at`: since the start; none: without shadow.
std::optional<ReportMap> report_map(const Ground& ground, const ReportData& data,
                                    std::optional<SimTime> shadow_at, int threads,
                                    const ReportLine& also = {});

}  // namespace lsos
