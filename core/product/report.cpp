#include "product/report.h"

#include "product/report_document.h"
#include "product/report_page.h"

namespace lsos {

std::string report_json(const ReportData& data, const Plan& plan, const SiteFrame& site,
                        const std::string& summary, const ReportExtras& extras) {
  return page_json(report_document(data, plan, site, summary, extras));
}

std::string report_html(const ReportData& data, const Plan& plan, const SiteFrame& site,
                        const std::string& summary, const ReportExtras& extras) {
  return report_page(report_document(data, plan, site, summary, extras), PageKind::run);
}

}  // namespace lsos
