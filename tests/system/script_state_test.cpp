// Whatever scripts try to remember beside ev.state, a run is the same when all is written out,
// thrown away and read back at each exchange.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <map>

#include "support/hidden_state.h"
#include "system/run_folder.h"

namespace lsos::test {
namespace {

using nlohmann::json;

// Ways that fail an event when it runs, or let it be; others break their script as it loads.
std::vector<HiddenState> ways_that_load() {
  std::vector<HiddenState> ways = hidden_states();
  std::erase_if(ways, [](const HiddenState& way) {
    return way.name == "LengthWithHoles" || way.name == "WeakTable";
  });
  return ways;
}

// A rover has each event twice, since events of a type share what their file has.
json summary_of_run(const TempFolder& folder, const std::string& name, const Words& options) {
  std::vector<Mark> plan{mission({{"MaxDuration", "9 min"}}), sev("A", "31,12")};
  int sequence = 0;
  for (const HiddenState& way : ways_that_load()) {
    folder.write("events/" + way.name + ".lua", event_of(way));
    if (!way.shared.empty()) folder.write("lib/" + way.name + ".lua", way.shared);
    for (int k = 0; k < 2; ++k)
      plan.push_back(event(way.name, "A", sequence += 10, {{"OnFailure", "skip"}}));
  }
  Words words{"run",        folder.write("plan.kml", kml(plan)), "-o", folder / name, "--quiet",
              "--no-report"};
  words.insert(words.end(), options.begin(), options.end());
  const Outcome outcome = run(words);
  EXPECT_FALSE(summary(folder / name).is_null()) << outcome.out << outcome.err;
  return summary(folder / name);
}

TEST(ScriptState, that_hides_is_refused_with_one_digest) {
  const TempFolder folder;
  const json plain = summary_of_run(folder, "plain", {});
  const json saved = summary_of_run(folder, "saved", {"--save-every-exchange"});
  ASSERT_TRUE(plain.contains("log_sha256") && saved.contains("log_sha256"));
  EXPECT_EQ(saved["log_sha256"], plain["log_sha256"]);
  std::map<std::string, std::string> reasons;
  for (const json& event : plain["events"]) {
    const std::string reason = event["reason"].is_string() ? event["reason"] : "";
    const auto [first, is_new] = reasons.try_emplace(event["type"].get<std::string>(), reason);
    EXPECT_TRUE(is_new || reason.empty() == first->second.empty()) << reason;
  }
  for (const HiddenState& way : ways_that_load()) {
    ASSERT_TRUE(reasons.contains(way.name)) << way.name;
    if (way.refusal.empty()) {
      EXPECT_EQ(reasons.at(way.name), "") << way.name;
    } else {
      EXPECT_THAT(reasons.at(way.name), ::testing::HasSubstr(way.refusal)) << way.name;
    }
  }
}

}  // namespace
}  // namespace lsos::test
