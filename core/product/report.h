// report.html: one page that works offline and shows the results of a run: warnings, tables, a map,
// plots with a common time cursor, pictures.
#pragma once

#include <string>

#include "product/report_data.h"
#include "product/report_extras.h"

namespace lsos {

// `summary`: the text of summary.json; "" when the run has not finished and there is none.
std::string report_html(const ReportData& data, const Plan& plan, const SiteFrame& site,
                        const std::string& summary, const ReportExtras& extras);
// The page's data as it stands inside <script>, without any '<'.
std::string report_json(const ReportData& data, const Plan& plan, const SiteFrame& site,
                        const std::string& summary, const ReportExtras& extras);

}  // namespace lsos
