#include "lua/check/annotated_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "edit/editable_file.h"
#include "edit/plan_notes.h"
#include "lua/check/estimate_map.h"
#include "plan/kml_reader.h"
#include "product/balloon.h"

namespace lsos {

namespace {

// Warnings by the Placemark in whose lines they are; 0: those of none.
std::map<int, std::vector<std::string>> warnings_by_line(const MissionFiles& files,
                                                         const KmlSource& source) {
  std::vector<int> begins{0};
  for (const SourcePlacemark& placemark : source.placemarks) begins.push_back(placemark.line);
  std::ranges::sort(begins);
  std::map<int, std::vector<std::string>> warnings;
  for (const Fault& fault : files.faults.sorted()) {
    const auto next = std::ranges::upper_bound(begins, fault.place.line);
    const bool has_line = fault.place.line > 0 && next != begins.begin();
    warnings[has_line ? *std::prev(next) : 0].push_back(fault.what);
  }
  return warnings;
}

std::string warnings_html(const std::vector<std::string>& warnings) {
  std::string html;
  for (const std::string& warning : warnings) {
    html += fmt::format("<p><b>Warning:</b> {}</p>", html_text(warning));
  }
  return html;
}

std::string not_begun_html(const EventEstimate& event) {
  const std::string why = event.reason.empty() ? "." : ": " + html_text(event.reason);
  return fmt::format("<p>It is not expected to begin{}</p>", why);
}

std::string utc_if_known(const Plan& plan, const std::optional<double>& time_s) {
  return time_s ? format_utc(plan.mission.start_time + from_seconds(*time_s)) : "";
}

}  // namespace

std::string annotated_plan(const MissionFiles& files, const Simulation& simulation,
                           const MissionEstimate& estimate) {
  const Plan& plan = files.plan;
  const EditableFile file(files.plan_bytes, plan.file);
  const Declarations& declarations = files.catalog->declarations();
  PlanDocument document(file.kml(), plan, declarations);
  auto warnings = warnings_by_line(files, parse_kml(file.kml(), plan.file));

  std::map<PlanEvent::Reference, const EventEstimate*> estimates;
  for (const EventEstimate& event : estimate.events) {
    estimates[{event.rover_id, event.sequence}] = &event;
  }
  std::vector<EventNote> notes;
  for (const PlanEvent& event : plan.events) {
    const auto found = estimates.find({event.rover_id, event.sequence});
    EventNote note{&event, "<h4>Estimate</h4>", "", ""};
    if (found == estimates.end()) {
      note.html += "<p>It is disabled.</p>";
    } else {
      const EventEstimate& expected = *found->second;
      note.html +=
          expected.start_s ? balloon(expected, plan.mission.start_time) : not_begun_html(expected);
      note.begin_utc = utc_if_known(plan, expected.start_s);
      note.end_utc = utc_if_known(plan, expected.end_s);
    }
    note.html += warnings_html(warnings[event.place.line]);
    warnings.erase(event.place.line);
    notes.push_back(std::move(note));
  }
  std::string others = fmt::format(
      "<p>What lsos-host check expects: points where events end, with the time (UTC) and the "
      "charge "
      "then. Green from 60 % on, yellow from 30 %, orange below; red: it is expected to fail or "
      "to be cut off.</p>");
  for (const auto& [line, texts] : warnings) others += warnings_html(texts);
  const KmlDocument map =
      estimate_map(plan, estimate, event_courses(simulation, declarations), others);
  put_notes(document, notes, write_kml(map));

  const std::string bytes = file.with(document.text());
  // Not that of `plan`: options may have given it another Seed, or the end of a run to begin with.
  const auto hash_of = [&](const std::string& of) {
    Faults told;
    return read_plan(plan.file, parse_kml(of, plan.file), declarations, told).hash();
  };
  LSOS_ASSERT(hash_of(bytes) == hash_of(files.plan_bytes));
  return bytes;
}

}  // namespace lsos
