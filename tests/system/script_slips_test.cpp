// Slips in a user's event scripts that would otherwise have no effect and no message.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "system/run_folder.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

// Runs an event whose only phase has that body.
struct Slip {
  explicit Slip(const std::string& body, const std::vector<Mark>& more = {}) {
    folder.write("events/Slip.lua",
                 "local lsos = require 'lsos'\nlocal function go(ev, rover)\n  " + body +
                     "\nend\nreturn lsos.event { api = 1, doc = 'A slip.', start = 'go', phases = "
                     "{ go = go } }\n");
    std::vector<Mark> plan{mission({{"MaxDuration", "10 min"}}), sev("A", "31,12"),
                           event("Slip", "A", 10)};
    plan.insert(plan.end(), more.begin(), more.end());
    run({folder.write("plan.kml", kml(plan)), "-o", folder / "run", "--quiet", "--no-report"});
    answer = summary(folder / "run");
  }
  std::string reason() const { return answer["events"][0]["reason"].get<std::string>(); }
  std::string warnings() const { return answer["warnings"].dump(); }
  std::string status() const { return answer["events"][0]["status"].get<std::string>(); }

  TempFolder folder;
  json answer;
};

TEST(ScriptSlip, of_a_resource_that_is_not_carried) {
  const Slip slip("rover:use('oxigen', 1) return lsos.done");
  EXPECT_EQ(slip.status(), "failed");
  EXPECT_THAT(slip.reason(), HasSubstr("rover:use: the rover carries no 'oxigen'"));
}

TEST(ScriptSlip, of_a_partner_that_there_is_not) {
  for (const char* question : {"sees", "is_linked_to"}) {
    const Slip slip(std::string("if rover:") + question + "('earht') then end return lsos.done");
    EXPECT_EQ(slip.status(), "failed");
    EXPECT_THAT(slip.reason(), HasSubstr("there is no rover or asset 'earht'"));
  }
  EXPECT_EQ(Slip("if rover:sees('Earth') then end return lsos.done").status(), "completed");
}

TEST(ScriptSlip, of_a_drive_that_nobody_waits_for) {
  const Slip slip("rover:follow { rover.position + lsos.vec3(30, 0) } return lsos.done");
  EXPECT_EQ(slip.status(), "completed");
  EXPECT_THAT(slip.warnings(), HasSubstr("ended while its drive had 30.0 m to go"));
}

TEST(ScriptSlip, of_waiting_for_a_drive_that_was_not_ordered) {
  const Slip slip("return lsos.arrival");
  EXPECT_EQ(slip.status(), "failed");
  EXPECT_THAT(slip.reason(), HasSubstr("nothing drives: rover:follow was not called"));
}

TEST(ScriptSlip, of_panel_angles_in_degrees) {
  const Slip slip(
      "rover.panels:steer('Roof', { mode = 'point', azimuth_rad = 180, elevation_rad = 30 })");
  EXPECT_EQ(slip.status(), "failed");
  EXPECT_THAT(slip.reason(), HasSubstr("azimuth_rad"));
}

TEST(LateStart, is_a_warning_unless_more_is_waited_for) {
  const Slip slip(
      "return lsos.done",
      {event("Pause", "A", 20, {{"Duration", "5 min"}}),
       event("Pause", "A", 30, {{"Duration", "10"}, {"StartTime", "2026-01-01T00:02:00Z"}}),
       event("Pause", "A", 40,
             {{"Duration", "10"},
              {"StartTime", "2026-01-01T00:02:00Z"},
              {"StartWhen", "charge &gt; 0"}})});
  EXPECT_THAT(slip.warnings(), HasSubstr("Pause 30 of A: started 180 s after its StartTime"));
  EXPECT_THAT(slip.warnings(), ::testing::Not(HasSubstr("Pause 40 of A")));
}

}  // namespace
}  // namespace lsos::test
