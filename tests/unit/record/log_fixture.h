// Logs of invented rows for the tests of the record.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "record/log.h"
#include "support/test_folder.h"

namespace lsos {

inline const std::string moon_crs = "IAU_2015:30100";

// 2026-07-01T12:00:00Z.
inline Instant test_start() { return *parse_utc("2026-07-01T12:00:00Z").value; }

inline SampleRow test_sample(int i) {
  SampleRow row;
  row.time = SimTime{2'000'000LL * i};
  row.rover_id = "SEV1";
  row.place = geodetic_from_degrees(-10.5 + 1e-4 * i, -89.25, 12.5);
  row.elevation_m = 12.25 + i;
  row.p_S_m = {1.0 * i, 0.1 * i, -0.01 * i};
  row.heading_rad = 0.1;
  row.speed_mps = 0.3;
  row.distance_m = 0.6 * i;
  row.slip = 0.05;
  row.event = "Route 1";
  row.phase = "drive";
  return row;
}

inline EventRow test_event() {
  EventRow row;
  row.rover_id = "SEV1";
  row.sequence = 10;
  row.type = "Route";
  row.label = "Route 10";
  row.status = EventStatus::running;
  row.ready = SimTime{0};
  row.start = SimTime{100'000};
  return row;
}

}  // namespace lsos
