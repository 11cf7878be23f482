// The data of a page of plots, as the one JSON block that stands in it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "plan/plan.h"
#include "product/report_data.h"
#include "product/report_extras.h"

namespace lsos {

// `summary`: the text of summary.json; "" when the run has not finished and there is none.
nlohmann::ordered_json report_document(const ReportData& data, const Plan& plan,
                                       const SiteFrame& site, const std::string& summary,
                                       const ReportExtras& extras);

// One column over time, as data.js unpacks it; null where it has no value.
nlohmann::ordered_json packed_series(const ThinnedRows& rows, std::size_t column);

}  // namespace lsos
