// Studies that end when they know enough.
#include <gmock/gmock.h>

#include "system/study_text.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr const char* speed =
    "    lsos.vary { of = 'A/10.Speed', uniform = { '0.5 m/s', '1.5 m/s' } },";
constexpr const char* fastest =
    " gather = { lsos.gather { rover = 'A', take = 'greatest', quantity = 'speed_mps', name = "
    "'fastest' } },";

class StopWhen : public ::testing::Test {
 protected:
  void write(const std::string& keys) {
    folder_.write("plan.kml", kml(short_plan()));
    folder_.write("study.lua", study_text(keys + fastest, speed));
  }
  Outcome sweep(Words words, const std::string& out = "out") {
    words.insert(words.begin(), "sweep");
    for (const char* more : {"study.lua", "-o"}) words.emplace_back(more);
    words.push_back(out);
    return run(words, {.folder = folder_.path()});
  }

  TempFolder folder_;
};

TEST_F(StopWhen, ends_after_the_same_cases_in_any_order) {
  write(
      "cases = 400, stop_when = lsos.stop_when { of = 'fastest', quantile = 0.5, within = 0.4, "
      "after = 10 },");
  const Outcome one = sweep({"-j", "3", "--quiet"}, "one");
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_THAT(one.out, HasSubstr("10 of 10 cases done"));
  EXPECT_THAT(one.out, HasSubstr("P50 of fastest is known within 0."));
  EXPECT_THAT(one.out, HasSubstr("(95 %) after 10 of 400 cases"));
  const json cases = rows(folder_ / "one", "SELECT fastest FROM cases ORDER BY fastest");
  ASSERT_EQ(cases.size(), 10u);
  // The median's 95 % interval of ten values reaches from the second to the ninth.
  const double half = (double{cases[8]["fastest"]} - double{cases[1]["fastest"]}) / 2;
  EXPECT_LE(half, 0.4);
  EXPECT_THAT(sweep({"status"}, "one").out, HasSubstr("10 of 10 cases done"));
  // Another sweep of it runs nothing.
  EXPECT_THAT(sweep({"--quiet"}, "one").out, HasSubstr("10 of 10 cases done"));
  // More cases than are needed, as the chunks of a cluster have them.
  ASSERT_EQ(sweep({"run", "--cases", "1-12", "-j", "2", "--quiet"}, "two").exit_code, 0);
  const json gathered = json::parse(sweep({"gather", "--json"}, "two").out);
  EXPECT_EQ(gathered["cases"], 10);
  EXPECT_EQ(gathered["missing"], 0);
  EXPECT_THAT(sweep({"--print", "slurm"}, "two").err, HasSubstr("no case is missing"));
  EXPECT_EQ(equal_parts(folder_ / "one"), equal_parts(folder_ / "two"));
  EXPECT_THAT(read_text(folder_ / "two/study.html"), HasSubstr("(95 %) after 10 of 400 cases"));
}

TEST_F(StopWhen, runs_all_cases_where_they_never_say_enough) {
  write("cases = 11, stop_when = lsos.stop_when { of = 'completed', within = 1e-3, after = 10 },");
  const Outcome outcome = sweep({"--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("11 of 11 cases done"));
}

TEST_F(StopWhen, tells_rules_that_cannot_be_followed) {
  write(
      "cases = 20, sampling = 'latin_hypercube', stop_when = lsos.stop_when { of = 'fastets', "
      "quantile = 0.5, within = 0.1 },");
  const Outcome outcome = sweep({"--dry-run"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("stop_when: a part of a sampling 'latin_hypercube' is no "
                                     "sample of the whole; of 'random' and 'sobol' it is"));
  EXPECT_THAT(outcome.err, HasSubstr("stop_when: of = 'fastets': nothing of that name is gathered; "
                                     "did you mean 'fastest'?"));
  write(
      "cases = 20, stop_when = lsos.stop_when { of = 'completed', quantile = 0.5, within = 0.1 },");
  EXPECT_THAT(sweep({"--dry-run"}).err, HasSubstr("quantile: the share of missions has none"));
  write("cases = 20, stop_when = lsos.stop_when { of = 'fastest', within = 0.1 },");
  EXPECT_THAT(sweep({"--dry-run"}).err, HasSubstr("quantile is missing: 0.5 is the median"));
}

}  // namespace
}  // namespace lsos::test
