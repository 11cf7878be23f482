#include <gtest/gtest.h>

#include "lua/check/timeline_text.h"

namespace lsos {
namespace {

TEST(Timeline, has_a_line_a_rover_and_day_with_letters_each_20_minutes) {
  const Instant start = *parse_utc("2026-07-01T06:00:00Z").value;
  MissionEstimate estimate;
  estimate.end_s = 93600;
  estimate.shades = {{"SEV A", {{3600, 7200}}, {}, {{6000, 9600}}},
                     {"B", {}, {{0, 2400}}, {{1200, 3600}}}};
  const auto add = [&](const char* type, double start_s, double end_s) {
    EventEstimate& event = estimate.events.emplace_back();
    event.rover_id = "SEV A";
    event.type = type;
    event.start_s = start_s;
    event.end_s = end_s;
  };
  add("Route", 0, 3600);
  add("DeployCA", 3600, 3600);
  add("EVA", 3600, 5400);
  add("Recharge", 90000, 93600);
  const std::map<std::string, Activity> activities{{"Route", Activity::driving},
                                                   {"DeployCA", Activity::communication},
                                                   {"EVA", Activity::crew},
                                                   {"Recharge", Activity::energy}};
  const std::string text = timeline_text(estimate, activities, start);
  EXPECT_EQ(text,
            "day 1, 2026-07-01\n"
            "  UTC   06:00    09:00    12:00    15:00    18:00    21:00    00:00    03:00\n"
            "  SEV A DDDEE...................................................................\n"
            "           nnbee\n"
            "  B     ........................................................................\n"
            "        sbe\n"
            "day 2, 2026-07-02\n"
            "  UTC   06:00    09:00    12:00    15:00    18:00    21:00    00:00    03:00\n"
            "  SEV A ...CCC\n"
            "  B     ......\n");
}

TEST(Timeline, shows_drives_that_take_little_of_a_letter) {
  MissionEstimate estimate;
  estimate.end_s = 7200;
  estimate.shades = {{"A", {}, {}, {}}};
  for (const auto& [type, start_s, end_s] :
       {std::tuple("Pause", 0.0, 1500.0), std::tuple("Route", 1500.0, 1560.0),
        std::tuple("Pause", 1560.0, 7200.0)}) {
    EventEstimate& event = estimate.events.emplace_back();
    event.rover_id = "A";
    event.type = type;
    event.start_s = start_s;
    event.end_s = end_s;
  }
  const std::string text = timeline_text(
      estimate, {{"Route", Activity::driving}, {"Pause", Activity::waiting}}, Instant{});
  EXPECT_NE(text.find(" A     WDWWWW\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace lsos
