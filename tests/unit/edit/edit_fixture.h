// Plans that the tests of this folder edit.
#pragma once

#include <gmock/gmock.h>
#include <libxml/c14n.h>
#include <libxml/parser.h>

#include <memory>
#include <string>

#include "base/replaced.h"
#include "edit/event_choice.h"
#include "edit/plan_document.h"
#include "plan/kml_reader.h"
#include "unit/plan/plan_fixture.h"

namespace lsos::test {

// Declares also Fault, which has a moment, Follow, which names a leader, and the asset Habitat.
inline Declarations declarations_of_edits() {
  Declarations known = declarations();
  EventDeclaration fault;
  fault.name = "Fault";
  fault.fields = {required_field("At", "at", FieldKind::moment)};
  fault.geometries = {GeometryKind::none};
  fault.at = "at";
  EventDeclaration follow;
  follow.name = "Follow";
  follow.fields = {required_field("Leader", "leader", FieldKind::text)};
  follow.fields.front().names = NameOf::leader;
  follow.geometries = {GeometryKind::none};
  follow.drives = true;
  known.rover_types["Habitat"].is_asset = true;
  known.events["Fault"] = fault;
  known.events["Follow"] = follow;
  return known;
}

inline Plan read_text(const std::string& text, const Declarations& known) {
  Faults faults;
  Plan plan = read_plan("plan.kml", parse_kml(text, "plan.kml"), known, faults);
  for (const Fault& fault : faults.sorted()) {
    EXPECT_NE(fault.severity, Severity::error) << to_string(fault) << "\n" << text;
  }
  return plan;
}

// A plan's document with what it was made of.
class TestPlan {
 public:
  explicit TestPlan(const std::string& placemarks, const std::string& head = "")
      : text(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n" +
            head + placemarks + "</Document>\n</kml>\n"),
        known(declarations_of_edits()),
        plan(read_text(text, known)),
        document(text, plan, known) {}

  // What the edited document is read as; it must be without errors.
  Plan edited() const { return read_text(document.text(), known); }
  const PlanEvent& event(const std::string& rover, std::int64_t sequence) const {
    for (const PlanEvent& event : plan.events) {
      if (event.rover_id == rover && event.sequence == sequence) return event;
    }
    throw std::out_of_range(rover);
  }
  // Every event at its StartTime, else at the mission's start.
  std::map<PlanEvent::Reference, SimTime> begins() const {
    std::map<PlanEvent::Reference, SimTime> begins;
    for (const PlanEvent& event : plan.events) {
      begins[{event.rover_id, event.sequence}] =
          event.start_time ? *event.start_time - plan.mission.start_time : SimTime{};
    }
    return begins;
  }
  // Every event on the day of its StartTime, else on the first.
  EventDays days() const {
    EventDays days;
    for (const auto& [event, begin] : begins()) {
      days[event] = 1 + static_cast<int>(begin / SimTime{86'400'000'000});
    }
    return days;
  }

  std::string text;
  Declarations known;
  Plan plan;
  PlanDocument document;
};

// The text in W3C's canonical form, in which equal documents are equal.
inline std::string canonical(const std::string& text) {
  const std::unique_ptr<xmlDoc, void (*)(xmlDoc*)> document(
      xmlReadMemory(text.data(), static_cast<int>(text.size()), nullptr, nullptr, XML_PARSE_NONET),
      xmlFreeDoc);
  xmlChar* bytes = nullptr;
  const int size = xmlC14NDocDumpMemory(document.get(), nullptr, XML_C14N_1_0, nullptr, 1, &bytes);
  std::string form(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  xmlFree(bytes);
  return form;
}

// "A/10 Route 'a'" of each event of a plan.
inline std::vector<std::string> listed_events(const Plan& plan) {
  std::vector<std::string> lines;
  for (const PlanEvent& event : plan.events) {
    lines.push_back(event.rover_id + "/" + std::to_string(event.sequence) + " " + event.type +
                    " '" + event.label + "'");
  }
  return lines;
}

}  // namespace lsos::test
