// Pages that work offline: one file with its style, scripts and data.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace lsos {

// What a page shows decides which script fills it; maps and plots are common to all.
enum class PageKind { run, several_runs, telemetry, study };

// `document`: as of report_document, with what that kind of page has besides.
std::string report_page(const nlohmann::ordered_json& document, PageKind kind);

// The data as it stands inside <script>, without any '<'.
std::string page_json(const nlohmann::ordered_json& document);

}  // namespace lsos
