// The lunar traverse gives the same log, value for value, however it is run.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

std::string digest(const std::string& plan_text, const Words& options) {
  const TempFolder folder;
  Words words{"run",        folder.write("plan.kml", plan_text), "-o", folder / "run", "--quiet",
              "--no-report"};
  words.insert(words.end(), options.begin(), options.end());
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return summary(folder / "run")["log_sha256"];
}

// A plan with all Placemarks in one Document, in another order.
std::string shuffled(const std::string& text) {
  const std::string begin = "<Placemark>", end = "</Placemark>";
  std::vector<std::string> marks;
  for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    marks.push_back(text.substr(at, text.find(end, at) + end.size() - at));
  }
  EXPECT_GT(marks.size(), 20u);
  std::mt19937 random(1);
  std::ranges::shuffle(marks, random);
  std::string all = "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>";
  for (const std::string& mark : marks) all += mark;
  return all + "</Document></kml>";
}

TEST(EqualTraverse, follows_again_on_any_threads_and_in_any_order) {
  const std::string plan = read_text(repository() / "plans" / "lunar_traverse.kml");
  const std::string first = digest(plan, {"--threads", "1"});
  EXPECT_EQ(first.size(), 64u);
  EXPECT_EQ(digest(plan, {"--threads", "1"}), first) << "again";
  EXPECT_EQ(digest(plan, {"--threads", "3"}), first) << "on three threads";
  EXPECT_EQ(digest(shuffled(plan), {}), first) << "in another order";
}

}  // namespace
}  // namespace lsos::test
