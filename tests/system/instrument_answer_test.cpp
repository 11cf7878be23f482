// Output of instruments: JSON into a pipe, a table on a terminal, numbers without rounding errors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "system/run_folder.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const Words sun{
    "sun", "--planet", "Moon", "--site", "0.3,-89.1,12.7", "--at", "2026-07-01,2026-07-15T12:00Z"};

Words with(Words words, const std::string& more) {
  words.push_back(more);
  return words;
}

// Output of the program started by a shell on a terminal.
std::string on_a_terminal(const Words& arguments) {
  std::string line;
  for (const std::string& word : program(arguments)) line += "'" + word + "' ";
  return run_command({"script", "-qec", line, "/dev/null"}).out;
}

TEST(InstrumentAnswer, is_json_in_a_pipe_and_a_table_on_a_terminal) {
  const std::string piped = run(sun).out;
  EXPECT_EQ(json::parse(piped).size(), 2u);
  EXPECT_EQ(run(with(sun, "--json")).out, piped);
  const std::string table = run(with(sun, "--text")).out;
  EXPECT_THAT(table, StartsWith("utc "));
  EXPECT_THAT(table, HasSubstr("2026-07-01T00:00:00.000Z  2026-07-15T12:00:00.000Z\n"));
  EXPECT_TRUE(std::regex_search(table, std::regex("\nsub solar lat +-?[0-9.]+\u00b0 ")));
  EXPECT_TRUE(std::regex_search(table, std::regex("\ndistance +1[45][0-9]{7} km")));
  EXPECT_THAT(on_a_terminal(sun), HasSubstr("\nelevation refracted "));
  EXPECT_THAT(on_a_terminal(with(sun, "--json")), StartsWith("[\r\n"));
}

TEST(InstrumentAnswer, has_places_as_they_were_asked_and_no_noise_of_sums) {
  const std::string text = run(sun).out;
  EXPECT_THAT(text, HasSubstr("\"lon_deg\": 0.3,\n"));
  EXPECT_THAT(text, HasSubstr("\"lat_deg\": -89.1,\n"));
  const Words ground{"terrain", "Craters", "--at", "10.1,20.7", "--at=-0.30000000001,-0.1"};
  const std::string points = run(ground).out;
  EXPECT_THAT(points, HasSubstr("\"lon_deg\": 10.1,\n"));
  EXPECT_THAT(points, HasSubstr("\"lat_deg\": 20.7,\n"));
  EXPECT_THAT(points, HasSubstr("\"lon_deg\": -0.30000000001,\n")) << "as it was asked";
  const std::string line =
      run({"sight", "Flat", "--planet", "Moon", "--from", "0,0,2", "--to", "0.01,0.01,2"}).out;
  const std::regex ten_decimals(R"(\.[0-9]{10})");
  EXPECT_FALSE(std::regex_search(text, ten_decimals)) << text;
  EXPECT_FALSE(std::regex_search(line, ten_decimals)) << line;
}

// Warnings are sentences on standard error, and not in the table.
TEST(InstrumentAnswer, is_a_table_without_warnings) {
  const TempFolder folder;
  const std::string raster = folder / "small.tif";
  ASSERT_EQ(run({"terrain", "Craters", "--window", "10,20,10.01,20.01", "--resolution", "5",
                 "--export", raster})
                .exit_code,
            0);
  const Words light{"light", raster, "--at", "2026-07-06", "-o", folder / "light.tif"};
  const Outcome as_json = run(light), table = run(with(light, "--text"));
  ASSERT_TRUE(json::parse(as_json.out)[0].contains("warnings")) << as_json.out;
  EXPECT_THAT(table.out, HasSubstr("\nmean sun fraction "));
  EXPECT_THAT(table.out, HasSubstr("\nground reaches "));
  EXPECT_THAT(table.out, ::testing::Not(HasSubstr("warning")));
  // On a busy machine lines of progress come before it.
  EXPECT_THAT("\n" + table.err, HasSubstr("\nwarning: "));
}

TEST(InstrumentAnswer, has_as_many_columns_as_fit_on_a_screen) {
  const Outcome outcome =
      run({"rig", "--soil", "DrySand", "--radius", "0.125", "--width", "0.16", "--load", "107",
           "--slip", "-0.3,-0.2,-0.1,0,0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8", "--text"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("slip "));
  EXPECT_THAT(outcome.out, HasSubstr("\n\nslip "));
  EXPECT_THAT(outcome.out, HasSubstr("\ndrawbar pull "));
  EXPECT_THAT(outcome.out, HasSubstr(" N m"));
  std::size_t from = 0;
  for (auto end = outcome.out.find('\n'); end != std::string::npos;
       from = end + 1, end = outcome.out.find('\n', from)) {
    EXPECT_LE(end - from, 104u);
  }
}

}  // namespace
}  // namespace lsos::test
