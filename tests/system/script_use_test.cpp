// Scripts beside a plan: check warns of those that the plan uses and that hide others, and ignores
// the rest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "system/run_folder.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* stay =
    "local lsos = require 'lsos'\n"
    "return lsos.event { api = 1, doc = 'Stay.', phases = { go = function() return lsos.done end "
    "} }\n";

std::string check(const TempFolder& folder, const Mark& only) {
  const Outcome outcome =
      run({"check", folder.write("plan.kml", kml({mission(), sev("A", "0,0"), only}))});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.out + outcome.err;
}

TEST(ScriptUse, warns_of_scripts_that_the_plan_uses_alone) {
  const TempFolder folder;
  folder.write("events/Wait.lua", stay);
  folder.write("events/Junk.lua", "return 5 +");
  folder.write("rovers/Junk.lua", "return 5 +");
  folder.write("terrain/Junk.lua", "return 5 +");
  folder.write("terrain/soils/Junk.lua", "return 5 +");
  const std::string unused = check(folder, event("Pause", "A", 1, {{"Duration", "5"}}));
  EXPECT_THAT(unused, Not(HasSubstr("Junk")));
  EXPECT_THAT(unused, Not(HasSubstr("Wait.lua")));
  const std::string used = check(folder, event("Wait", "A", 1));
  EXPECT_THAT(used, HasSubstr("Wait.lua: warning: is used in place of "));
  EXPECT_THAT(used, Not(HasSubstr("Junk")));
}

TEST(ScriptUse, counts_the_events_that_an_event_is_made_of) {
  const TempFolder folder;
  folder.write("events/Wait.lua", stay);
  folder.write("events/Rest.lua",
               "local lsos = require 'lsos'\n"
               "return lsos.event { api = 1, doc = 'Rest.', phases = { go = lsos.sub_event { event "
               "= 'Wait' } } }\n");
  EXPECT_THAT(check(folder, event("Rest", "A", 1)), HasSubstr("Wait.lua: warning: is used in"));
}

// Broken scripts are reported by `list`.
TEST(ScriptUse, leaves_the_others_to_list) {
  const TempFolder folder;
  folder.write("events/Junk.lua", "return 5 +");
  const Outcome outcome = run({"list", "events"}, {.folder = folder.path()});
  EXPECT_THAT(outcome.err, HasSubstr("the event 'Junk' cannot be used"));
}

}  // namespace
}  // namespace lsos::test
