// Tests the layers against the text of the contract.
#include "record/columns.h"

#include <gmock/gmock.h>

#include <sstream>

#include "record/layers.h"

namespace lsos {
namespace {

struct ContractLayer {
  const char* name;
  LayerGeometry geometry;
  const char* columns;
};

// The columns that the contract requires at least; those after a bar are additional.
const ContractLayer contract[] = {
    {"samples", LayerGeometry::point,
     "time_s utc rover_id lon_deg lat_deg elevation_m x_m y_m z_m roll_rad pitch_rad heading_rad "
     "speed_mps distance_m slope_rad slip slip_max sinkage_m energy_j charge energy_rate_w "
     "solar_w solar_available_w external_w load_w drive_w loss_w solar_j external_j load_j "
     "drive_j loss_j sun_fraction incidence event phase"},
    {"events", LayerGeometry::point,
     "rover_id sequence type label status reason ready_s start_s end_s distance_m energy_used_j "
     "solar_j | utc end_utc"},
    {"phases", LayerGeometry::none, "rover_id sequence phase start_s end_s"},
    {"pairs", LayerGeometry::none,
     "time_s from_id to_id distance_m visible visible_fraction link relay | utc"},
    {"sight_intervals", LayerGeometry::none,
     "from_id to_id kind start_s end_s light_time_s | by utc end_utc"},
    {"panels", LayerGeometry::none,
     "time_s rover_id panel sun_fraction incidence power_w azimuth_rad elevation_rad"},
    {"joints", LayerGeometry::none, "time_s rover_id joint angle_rad extension_m"},
    {"resources", LayerGeometry::none, "time_s rover_id resource amount"},
    {"planned_paths", LayerGeometry::line,
     "time_s rover_id sequence leg attempt length_m duration_s energy_j slope_max_rad "
     "| steepest_lon_deg steepest_lat_deg"},
    {"notes", LayerGeometry::point, "time_s rover_id sequence name fields"},
    {"run", LayerGeometry::none, "key value"},
};

TEST(Layers, are_those_of_the_contract) {
  const std::vector<LayerSpec>& layers = contract_layers();
  ASSERT_EQ(layers.size(), std::size(contract));
  for (std::size_t i = 0; i < layers.size(); ++i) {
    EXPECT_EQ(layers[i].name, contract[i].name);
    EXPECT_EQ(layers[i].geometry, contract[i].geometry) << contract[i].name;
    std::string names;
    for (const ColumnSpec& column : layers[i].columns) {
      names += (names.empty() ? "" : " ") + std::string(column.name);
    }
    std::string expected = contract[i].columns;
    if (const std::size_t bar = expected.find("| "); bar != std::string::npos)
      expected.erase(bar, 2);
    EXPECT_EQ(names, expected) << contract[i].name;
  }
}

TEST(Columns, write_calendar_time_with_milliseconds) {
  SampleRow row;
  row.time = SimTime{90'500'000};
  const Instant start = *parse_utc("2026-07-01T12:00:00Z").value;
  const Column<SampleRow>& utc = columns<SampleRow>()[1];
  EXPECT_EQ(to_text(utc.value(row, start)), "2026-07-01T12:01:30.500Z");
}

TEST(Columns, have_null_for_what_is_not_modelled) {
  const SampleRow row;
  for (const Column<SampleRow>& column : columns<SampleRow>()) {
    if (column.name == "energy_j" || column.name == "slip" || column.name == "event") {
      EXPECT_EQ(column.value(row, {}).index(), 0u) << column.name;
    }
    if (column.name == "speed_mps") {
      EXPECT_EQ(column.value(row, {}), ColumnValue{0.0});
    }
  }
}

TEST(Columns, have_texts_that_read_back_equal) {
  EXPECT_EQ(to_text(ColumnValue{0.1}), "0.1");
  EXPECT_EQ(to_text(ColumnValue{1.0 / 3}), "0.3333333333333333");
  EXPECT_EQ(to_text(ColumnValue{std::int64_t{-3}}), "-3");
  EXPECT_EQ(to_text(ColumnValue{}), "");
}

TEST(EventStatus, has_a_name_that_is_understood) {
  for (const EventStatus status :
       {EventStatus::not_started, EventStatus::waiting, EventStatus::running,
        EventStatus::completed, EventStatus::failed, EventStatus::skipped, EventStatus::incomplete,
        EventStatus::disabled}) {
    EXPECT_EQ(event_status(to_string(status)), status);
  }
  EXPECT_EQ(event_status("done"), std::nullopt);
}

}  // namespace
}  // namespace lsos
