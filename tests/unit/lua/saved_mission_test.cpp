// What a checkpoint says of the mission that it was made in.
#include "lua/host/saved_mission.h"

#include <gmock/gmock.h>

namespace lsos {
namespace {

using ::testing::HasSubstr;

TEST(SavedMission, tells_each_change_of_the_renderer) {
  const std::string one = renderers_text("llvmpipe (LLVM 15)", "softpipe", SimTime{158'000'000});
  EXPECT_EQ(one, "llvmpipe (LLVM 15), from 158 s on softpipe");
  EXPECT_EQ(renderers_text(one, "softpipe", SimTime{200'000'000}), one);
  EXPECT_EQ(renderers_text(one, "llvmpipe (LLVM 15)", SimTime{300'000'000}),
            one + ", from 300 s on llvmpipe (LLVM 15)");
}

TEST(SavedMission, goes_on_with_the_renderer_that_drew_last) {
  SavedMission saved;
  saved.build = "1";
  saved.values = {{"renderer", "llvmpipe, from 158 s on softpipe"}};
  EXPECT_TRUE(differences(saved, "1", {{"renderer", "softpipe"}}, "out/a", false).sorted().empty());
  const auto faults = differences(saved, "1", {{"renderer", "llvmpipe"}}, "out/a", false).sorted();
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_THAT(to_string(faults[0]), HasSubstr("drawn by softpipe, and would be by llvmpipe"));
}

}  // namespace
}  // namespace lsos
