// What cases leave for their study, and the quantiles of it.
#include <gmock/gmock.h>

#include <cmath>

#include "base/error.h"
#include "base/files.h"
#include "planet/body.h"
#include "product/study/case_record.h"
#include "product/study/case_series.h"
#include "product/study/quantiles.h"

namespace lsos::test {
namespace {

using ::testing::ElementsAre;

// numpy.quantile([3, 1, 2, 10], [0.05, 0.5, 0.95]) = 1.15, 2.5, 8.95
TEST(Quantiles, are_those_of_numpy) {
  std::vector<double> values{3, 1, std::nan(""), 2, 10};
  const Quantiles found = quantiles_of(values);
  EXPECT_DOUBLE_EQ(found.p5, 1.15);
  EXPECT_DOUBLE_EQ(found.p50, 2.5);
  EXPECT_DOUBLE_EQ(found.p95, 8.95);
  EXPECT_EQ(found.count, 4u);
}

TEST(Quantiles, of_one_value_are_that_value) {
  std::vector<double> one{7}, none{std::nan("")};
  EXPECT_EQ(quantiles_of(one).p5, 7);
  EXPECT_EQ(quantiles_of(none).count, 0u);
}

SampleRow sample(const std::string& rover, double time_s, double charge, double distance_m) {
  SampleRow row;
  row.time = from_seconds(time_s);
  row.rover_id = rover;
  row.charge = charge;
  row.distance_m = distance_m;
  row.place = geodetic_from_degrees(31, 20);
  return row;
}

TEST(CaseSeries, lies_between_the_samples_in_their_proportion) {
  SeriesRecorder recorder(10, {"A", "B"});
  recorder.add(sample("A", 0, 1, 0));
  recorder.add(sample("B", 0, std::nan(""), 5));
  recorder.add(sample("A", 25, 0.5, 50));
  recorder.add(sample("A", 30, 0.4, 50));
  recorder.add(sample("C", 30, 0, 0));
  const std::string file = ::testing::TempDir() + "lsos_case_series.bin";
  write_file(file, recorder.bytes());
  const SeriesFile series(file);
  EXPECT_EQ(series.interval_s(), 10);
  EXPECT_EQ(series.count("A"), 4u);
  EXPECT_EQ(series.count("B"), 1u);
  EXPECT_EQ(series.count("C"), 0u);
  EXPECT_THAT(series.values("A", 0, 0, 9), ElementsAre(1, 0.8, 0.6, 0.4));
  EXPECT_THAT(series.values("A", 1, 1, 2), ElementsAre(20, 40));
  EXPECT_TRUE(std::isnan(series.values("B", 0, 0, 1).front()));
  EXPECT_THAT(series.values("B", 1, 0, 1), ElementsAre(5));
  write_file(file, recorder.bytes().substr(0, 100));
  EXPECT_THROW(SeriesFile(file).values("B", 3, 0, 1), InputError) << "a file that was cut short";
  write_file(file, "no series");
  EXPECT_THROW(SeriesFile{file}, InputError);
}

TEST(CaseRecord, comes_back_as_it_was) {
  CaseRecord record;
  record.number = 12;
  record.seed = 18446744073709551615u;
  record.values = {{"A/10.Speed", 0.1},
                   {"A/10.Enabled", true},
                   {"MissionInfo.Soil", "Sand"},
                   {"MissionInfo.Seed", std::int64_t{3}}};
  record.gathered = {{"end \"charge\"", 0.25}};
  record.events = {{"A", 10, "failed", "stuck", 12.5, std::nullopt, geodetic_from_degrees(31, 20)}};
  record.status = "failed";
  record.reason = "A/10 'out' failed: stuck";
  const auto back = read_case_record(to_json(record));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->number, 12);
  EXPECT_EQ(back->seed, record.seed);
  EXPECT_EQ(back->values, record.values);
  EXPECT_EQ(back->gathered, record.gathered);
  EXPECT_EQ(back->events.front().end_s, 12.5);
  EXPECT_FALSE(back->events.front().charge);
  EXPECT_NEAR(back->events.front().place->lat_rad, record.events.front().place->lat_rad, 1e-15);
  EXPECT_EQ(back->reason, record.reason);
  EXPECT_FALSE(read_case_record("{}"));
  EXPECT_FALSE(read_case_record("{"));
}

TEST(ReasonOf, is_that_of_the_first_event_that_failed) {
  EXPECT_EQ(reason_of(R"({"status": "failed", "events": [
      {"rover_id": "A", "sequence": 10, "label": "out", "status": "failed", "reason": "late",
       "end_s": 90},
      {"rover_id": "B", "sequence": 20, "label": "in", "status": "failed", "reason": "stuck",
       "end_s": 30},
      {"rover_id": "B", "sequence": 30, "label": "x", "status": "not_started", "reason": null,
       "end_s": null}]})"),
            "B/20 'in' failed: stuck");
  EXPECT_EQ(reason_of(R"({"status": "completed", "events": []})"), "");
  EXPECT_EQ(reason_of(R"({"status": "incomplete", "events": [
      {"rover_id": "A", "sequence": 10, "label": "out", "status": "incomplete", "reason": null,
       "end_s": null}]})"),
            "A/10 'out' did not end");
}

}  // namespace
}  // namespace lsos::test
