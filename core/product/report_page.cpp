#include "product/report_page.h"

#include <array>
#include <string_view>
#include <utility>

#include "base/error.h"

namespace lsos {

// Files of report/ and dygraphs, defined in a source that embed.cmake writes.
extern const std::string_view page_frame, page_style, common_scripts, dygraphs;
extern const std::string_view run_scripts, several_runs_scripts, telemetry_scripts, study_scripts;

namespace {

// Removes the last line of dygraphs, which names a source map that the page does not have.
std::string_view without_source_map(std::string_view script) {
  const std::size_t at = script.rfind("//# sourceMappingURL=");
  return at == std::string_view::npos ? script : script.substr(0, at);
}

std::string_view scripts_of(PageKind kind) {
  switch (kind) {
    case PageKind::run:
      return run_scripts;
    case PageKind::several_runs:
      return several_runs_scripts;
    case PageKind::telemetry:
      return telemetry_scripts;
    case PageKind::study:
      return study_scripts;
  }
  return {};
}

}  // namespace

std::string page_json(const nlohmann::ordered_json& document) {
  const std::string json =
      document.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  // "</script>" in a label would end the script.
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string report_page(const nlohmann::ordered_json& document, PageKind kind) {
  const std::string json = page_json(document);
  const std::string scripts = std::string(common_scripts) + std::string(scripts_of(kind));
  const std::array<std::pair<std::string_view, std::string_view>, 4> parts{
      {{"/* STYLE */", page_style},
       {"/* DATA */", json},
       {"/* DYGRAPHS */", without_source_map(dygraphs)},
       {"/* SCRIPT */", scripts}}};
  std::string page;
  std::size_t at = 0;
  for (const auto& [mark, text] : parts) {
    const std::size_t found = page_frame.find(mark, at);
    LSOS_ASSERT(found != std::string_view::npos);
    page += page_frame.substr(at, found - at);
    page += text;
    at = found + mark.size();
  }
  page += page_frame.substr(at);
  return page;
}

}  // namespace lsos
