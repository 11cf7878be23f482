#include "mission/model/breakable.h"

#include <gmock/gmock.h>

#include <set>

#include "test_mission.h"

namespace lsos {
namespace {

using testing::HasSubstr;

BreakableParts parts() {
  const VehicleConfig config = test::rover(1.6);
  PowerSpec power;
  power.battery.emplace().capacity_j = 1e6;
  PanelSpec left, right;
  left.name = "left";
  right.name = "right";
  power.panels = {left, right};
  AntennaSpec mast;
  mast.name = "mast";
  return breakable_parts(config, power, std::vector<AntennaSpec>{mast});
}

BreakageOfParts resolved(const Breakage& breakage) {
  const auto result = resolve(breakage, parts(), "it");
  EXPECT_TRUE(result) << result.why;
  return result.value.value_or(BreakageOfParts{});
}

std::string why(const Breakage& breakage) { return resolve(breakage, parts(), "it").why; }

TEST(Breakable, has_all_parts_of_a_rover) {
  EXPECT_EQ(resolved({.what = "wheel", .share = {}}).parts.size(), 12u);
  EXPECT_EQ(resolved({.what = "steering", .share = {}}).parts.size(), 6u);
  const BreakageOfParts right =
      resolved({.what = "panel", .part = "right", .mode = "dead", .share = 0.25});
  ASSERT_EQ(right.parts.size(), 1u);
  EXPECT_EQ(right.parts[0].index, 1);
  EXPECT_EQ(right.share, 0.25);
  EXPECT_THAT(right.modes, testing::ElementsAre(BreakageMode::dead));
}

TEST(Breakable, means_the_first_mode_when_none_is_said_and_all_in_a_repair) {
  EXPECT_EQ(resolved({.what = "wheel", .share = {}}).modes.front(), BreakageMode::locked);
  EXPECT_EQ(resolved({.what = "panel", .share = {}}).modes.front(), BreakageMode::stuck);
  EXPECT_EQ(resolved({.what = "panel", .share = 0.5}).modes.front(), BreakageMode::dead);
  EXPECT_EQ(resolved({.what = "panel", .share = {}, .is_repair = true}).modes.size(), 2u);
  EXPECT_EQ(
      resolved({.what = "panel", .mode = "dead", .share = {}, .is_repair = true}).modes.size(), 1u);
}

TEST(Breakable, refuses_what_does_not_fit) {
  EXPECT_THAT(why({.what = "whel", .share = {}}), HasSubstr("did you mean 'wheel'?"));
  EXPECT_EQ(why({.what = "limb", .share = {}}), "it has no limb");
  EXPECT_THAT(why({.what = "panel", .part = "rigt", .share = {}}),
              HasSubstr("it has no panel 'rigt'; did you mean 'right'?"));
  EXPECT_THAT(why({.what = "antenna", .mode = "free", .share = {}}),
              HasSubstr("does not fit an antenna, which is dead"));
  EXPECT_THAT(why({.what = "battery", .share = 1.5}), HasSubstr("a share is 0 to 1"));
}

// Plans name what the table has, and nothing else.
TEST(Breakable, has_each_equipment_once) {
  std::set<Equipment> seen;
  for (const Breakable& each : breakables()) seen.insert(each.what);
  EXPECT_EQ(seen.size(), 6u);
  EXPECT_EQ(breakables().size(), 6u);
}

}  // namespace
}  // namespace lsos
