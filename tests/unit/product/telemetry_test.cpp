// Telemetry: headings, rows, and what is told of those that cannot be used.
#include "product/comparison/telemetry.h"

#include <gmock/gmock.h>

#include <numbers>

#include "product/comparison/telemetry_columns.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

RunExtent extent() { return {test_start(), SimTime{3'600'000'000}, {"SEV1", "SEV2"}}; }

Telemetry read(const std::string& text) { return read_telemetry("t.csv", text, extent()); }

// All messages about a table, as errors or warnings.
std::string told(const std::string& text) {
  std::string all;
  try {
    for (const Fault& fault : faults_of(read(text), Severity::warning))
      all += to_string(fault) + "\n";
  } catch (const InputError& error) {
    for (const Fault& fault : error.faults()) all += to_string(fault) + "\n";
  }
  return all;
}

TEST(Telemetry, leaves_out_values_that_cannot_be) {
  const std::string text = told("time_s,rover_id,charge\n1,SEV1,99.98\n2,SEV1,0.5\n");
  EXPECT_THAT(text, HasSubstr("t.csv:2: warning: charge: 99.98 is out of range: charge is 0 to 1; "
                              "per cent want the heading 'charge (%)'"));
  EXPECT_EQ(read("time_s,rover_id,charge\n1,SEV1,1.02\n").rows_used, 1u) << "noise";
}

struct HeadingCase {
  const char* heading;
  const char* quantity;
  const char* cell;
  double value_si;
};

TEST(TelemetryColumns, are_logged_quantities_in_any_unit_of_their_kind) {
  const HeadingCase cases[] = {
      {"speed_mps", "speed_mps", "2", 2},
      {"Speed, m/s", "speed_mps", "2", 2},
      {"Speed (km/h)", "speed_mps", "7.2", 2},
      {"speed [km/h]", "speed_mps", "7.2", 2},
      {"speed_kmph", "speed_mps", "7.2", 2},
      {"speed_km_h", "speed_mps", "7.2", 2},
      {"Speed (mph)", "speed_mps", "10", 10 * 1609.344 / 3600},
      {"Speed (mph)", "speed_mps", "3.6 km/h", 1},
      {"energy_kWh", "energy_j", "2", 7.2e6},
      {"energy_j", "energy_j", "2 Wh", 7200},
      {"Energy rate (kW)", "energy_rate_w", "-1.5", -1500},
      {"solar_kWh", "solar_j", "1", 3.6e6},
      {"solar_kW", "solar_w", "1", 1000},
      {"heading_deg", "heading_rad", "180", std::numbers::pi},
      {"charge", "charge", "0.5", 0.5},
      {"Charge, 0 to 1", "charge", "50 %", 0.5},
      {"charge (%)", "charge", "50", 0.5},
      {"slip_percent", "slip", "5", 0.05},
      {"Elevation (km)", "elevation_m", "-1.2", -1200},
      {"x_m", "x_m", "3", 3},
  };
  for (const HeadingCase& each : cases) {
    const TelemetryColumn column = telemetry_column(each.heading);
    ASSERT_EQ(column.kind, TelemetryKind::quantity) << each.heading << ": " << column.fault;
    EXPECT_EQ(column.quantity->name, each.quantity) << each.heading;
    EXPECT_NEAR(*column.value(each.cell).value, each.value_si, 1e-12 * std::abs(each.value_si))
        << each.heading;
  }
}

TEST(TelemetryColumns, say_when_who_and_where) {
  const std::pair<const char*, TelemetryKind> cases[] = {
      {"time_s", TelemetryKind::time},           {"Time (min)", TelemetryKind::time},
      {"Time, s", TelemetryKind::time},          {"utc", TelemetryKind::utc},
      {"Time, UTC", TelemetryKind::utc},         {"Time (UTC)", TelemetryKind::utc},
      {"rover_id", TelemetryKind::rover},        {"Rover", TelemetryKind::rover},
      {"lon_deg", TelemetryKind::lon},           {"Longitude", TelemetryKind::lon},
      {"Latitude, degrees", TelemetryKind::lat}, {"lat_rad", TelemetryKind::lat},
      {"event", TelemetryKind::ignored},         {"", TelemetryKind::ignored}};
  for (const auto& [heading, kind] : cases) {
    EXPECT_EQ(telemetry_column(heading).kind, kind) << heading;
  }
}

TEST(TelemetryColumns, that_are_not_known_are_told_with_the_nearest_name) {
  const std::pair<const char*, const char*> cases[] = {
      {"Sped (km/h)", "a run logs no such quantity; did you mean 'speed_mps'?"},
      {"chrage", "did you mean 'charge'?"},
      {"temperature_k", "a run logs no such quantity"},
      {"speed", "has no unit; 'speed_mps' or 'Speed (km/h)' is allowed"},
      {"Speed (kg)", "'kg' is a unit of mass, a speed is wanted"},
      {"Speed (warp)", "there is no unit 'warp' of speed"},
      {"time", "has no unit; 'time_s' or 'Time (ms)' is allowed"},
  };
  for (const auto& [heading, what] : cases) {
    const TelemetryColumn column = telemetry_column(heading);
    EXPECT_EQ(column.kind, TelemetryKind::unusable) << heading;
    EXPECT_THAT(column.fault, HasSubstr(what)) << heading;
  }
}

TEST(Telemetry, is_read_by_rover_in_order_of_time) {
  const Telemetry found = read(
      "time_s;rover_id;charge;lon_deg;lat_deg\n20;SEV2;0.5;;\n10;SEV2;0.6;1;2\n1 min;SEV1;;3;4\n");
  EXPECT_EQ(found.rows, 3u);
  EXPECT_EQ(found.rows_used, 3u);
  EXPECT_THAT(found.unusable, IsEmpty());
  ASSERT_THAT(found.by_rover, SizeIs(2));
  const std::vector<MeasuredRow>& rows = found.by_rover.at("SEV2");
  EXPECT_EQ(rows[0].time, SimTime{10'000'000});
  EXPECT_THAT(rows[0].values, ElementsAre(0.6));
  EXPECT_EQ(rows[0].lat_deg, 2);
  EXPECT_TRUE(std::isnan(rows[1].lat_deg));
  EXPECT_TRUE(std::isnan(found.by_rover.at("SEV1")[0].values[0]));
  EXPECT_EQ(found.by_rover.at("SEV1")[0].time, SimTime{60'000'000});
}

TEST(Telemetry, may_have_times_in_utc) {
  const Telemetry found = read("utc,rover_id,charge\n2026-07-01T12:01:00Z,SEV1,0.5\n");
  EXPECT_EQ(found.by_rover.at("SEV1")[0].time, SimTime{60'000'000});
}

TEST(Telemetry, needs_no_column_of_rovers_where_the_run_has_one) {
  const RunExtent one{test_start(), SimTime{3'600'000'000}, {"SEV1"}};
  EXPECT_EQ(read_telemetry("t.csv", "time_s,charge\n1,0.5\n", one).by_rover.at("SEV1").size(), 1u);
  EXPECT_THAT(told("time_s,charge\n1,0.5\n"),
              HasSubstr("t.csv:1: there is no column 'rover_id', and the run has SEV1, SEV2"));
}

TEST(Telemetry, tells_all_that_cannot_be_used_and_uses_the_rest) {
  const std::string text =
      "time_s,rover_id,charge,Sped (km/h),lon_deg,lat_deg\n"
      "1,SEV1,0.5,3,,\n"
      ",SEV1,0.5,,,\n"
      "4000,SEV1,0.5,,,\n"
      "2,SEV3,0.5,,,\n"
      "2,,0.5,,,\n"
      "2,SEV1,\"0,5\",,10,\n"
      "2,SEV1,,,,\n"
      "soon,SEV1,0.5,,,\n"
      "3,SEV1,0.5,,1,95\n"
      "3,SEV1,0.5,,1,5,7\n";
  const Telemetry found = read(text);
  EXPECT_EQ(found.rows, 10u);
  EXPECT_EQ(found.rows_used, 2u);  // lines 2 and 10, its charge
  const std::string all = told(text);
  for (const char* what : {
           "t.csv:1: warning: column 'Sped (km/h)': a run logs no such quantity; did you mean "
           "'speed_mps'?",
           "t.csv:3: warning: has no time",
           "t.csv:4: warning: is at 4000 s, outside the run: 0 to 3600 s, "
           "2026-07-01T12:00:00.000Z to 2026-07-01T13:00:00.000Z",
           "t.csv:5: warning: there is no rover 'SEV3' in the run; it has SEV1, SEV2; did you mean",
           "t.csv:6: warning: names no rover; the run has SEV1, SEV2",
           "t.csv:7: warning: charge: '0,5' has a comma; a decimal point is allowed; did you mean "
           "'0.5'?",
           "t.csv:7: warning: has lon_deg alone of a place; both are wanted",
           "t.csv:8: warning: has no measured value",
           "t.csv:9: warning: time_s: 'soon' is no number; a duration is allowed",
           "t.csv:10: warning: longitude 1, latitude 95: no place",
           "t.csv:11: warning: has 7 cells under 6 headings",
       }) {
    EXPECT_THAT(all, HasSubstr(what));
  }
}

TEST(Telemetry, has_faults_that_are_errors_where_no_row_can_be_used) {
  EXPECT_THROW(read("time_s,rover_id,charge\n1,SEV3,0.5\n"), InputError);
  EXPECT_THAT(told("rover_id,charge\nSEV1,0.5\n"),
              HasSubstr("t.csv:1: there is no column of times: 'time_s'"));
  EXPECT_THAT(told("time_s,rover_id\n1,SEV1\n"),
              HasSubstr("t.csv:1: there is no column to compare"));
  EXPECT_THAT(told("time_s,rover_id,lon_deg\n1,SEV1,5\n"),
              HasSubstr("t.csv:1: there is no column 'lat_deg': a place needs"));
  EXPECT_THAT(told("time_s,rover_id,charge,Charge (%)\n"),
              HasSubstr("column 'Charge (%)': gives again what column 'charge' gives"));
  EXPECT_THAT(told("time_s,rover_id,charge\n"), HasSubstr("t.csv: has no rows"));
  EXPECT_THAT(told(""), HasSubstr("t.csv: has no heading"));
  EXPECT_THAT(told("time_s,rover_id,\"charge\n1,SEV1,0.5\n"),
              HasSubstr("t.csv:1: a quotation mark opens here and is not closed"));
}

TEST(Telemetry, has_one_time_a_row) {
  const std::string text =
      "utc,time_s,rover_id,charge\n2026-07-01T12:01:00Z,60,SEV1,0.5\n"
      "2026-07-01T12:01:00Z,70,SEV1,0.5\n2026-07-01T25:00:00Z,70,SEV1,0.5\n";
  EXPECT_EQ(read(text).rows_used, 1u);
  EXPECT_THAT(told(text), HasSubstr("t.csv:3: warning: utc is 60 s after the run's start, time_s "
                                    "says 70 s; leave one out"));
  EXPECT_THAT(told(text), HasSubstr("t.csv:4: warning: utc: "));
}

TEST(Telemetry, tells_the_first_of_many_like_faults_and_how_many_more) {
  std::string text = "time_s,rover_id,charge\n1,SEV1,0.5\n";
  for (int k = 0; k < 100; ++k) text += "5000,SEV1,0.5\n";
  const Telemetry found = read(text);
  EXPECT_THAT(found.unusable, SizeIs(100));
  const std::vector<Fault> faults = faults_of(found, Severity::warning);
  ASSERT_THAT(faults, SizeIs(6));
  EXPECT_EQ(faults.back().place.line, 102);
  EXPECT_THAT(faults.back().what, HasSubstr("the last of 95 more like it"));
}

}  // namespace
}  // namespace lsos
