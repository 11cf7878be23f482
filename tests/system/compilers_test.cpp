// The program as another compiler builds it (build/clang) comes to the same results, but not to the
// same bits: mathematical functions and sums of its own differ in the last digit, and wheels that
// slip make more of that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// How far results may lie apart.
constexpr double time_share = 0.005, time_s = 2;  // the larger one, of each event's end
constexpr double distance_share = 0.005, distance_m = 0.5;
constexpr double energy_share = 0.01, energy_j = 3600;

void expect_near(const Json& a, const Json& b, const std::string& key, double share, double least) {
  ASSERT_EQ(a[key].is_number(), b[key].is_number()) << key;
  if (!a[key].is_number()) return;
  const double x = a[key], y = b[key];
  EXPECT_NEAR(x, y, std::max(least, share * std::abs(x))) << key;
}

TEST(Compilers, come_to_the_same_results) {
  const fs::path other = repository() / "build/clang/bin/lsos-host";
  if (!fs::exists(other)) {
    GTEST_SKIP() << "there is no " << other << ": script/test --long builds it";
  }
  int plans = 0;
  for (const fs::path& plan : shipped_plans()) {
    SCOPED_TRACE(plan.filename().string());
    ++plans;
    const TempFolder folder;
    const Words words{"run", plan, "--quiet", "--no-report", "-o"};
    Words one = words, two = words;
    one.push_back(folder / "one");
    two.push_back(folder / "two");
    two.insert(two.begin(), other);
    ASSERT_EQ(run(one).exit_code, run_command(two).exit_code);
    const Json a = summary(folder / "one"), b = summary(folder / "two");
    ASSERT_EQ(a["rovers"].size(), b["rovers"].size());
    for (const auto& [id, rover] : a["rovers"].items()) {
      SCOPED_TRACE(id);
      expect_near(rover, b["rovers"][id], "distance_m", distance_share, distance_m);
      expect_near(rover, b["rovers"][id], "energy_used_j", energy_share, energy_j);
    }
    ASSERT_EQ(a["events"].size(), b["events"].size());
    for (std::size_t i = 0; i < a["events"].size(); ++i) {
      const Json &x = a["events"][i], &y = b["events"][i];
      SCOPED_TRACE(x["label"].get<std::string>());
      EXPECT_EQ(x["status"], y["status"]);
      expect_near(x, y, "end_s", time_share, time_s);
      expect_near(x, y, "distance_m", distance_share, distance_m);
    }
  }
  EXPECT_GE(plans, 5);
}

}  // namespace
}  // namespace lsos::test
