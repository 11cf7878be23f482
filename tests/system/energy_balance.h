// The energy balance of a log's rows.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "record/rows.h"

namespace lsos::test {

// Checks that every row closes the energy balance that the contract promises.
inline void expect_closed(const std::vector<SampleRow>& rows) {
  ASSERT_FALSE(rows.empty());
  const double start_j = rows.front().energy_j;
  for (const SampleRow& row : rows) {
    const double flowed_j = row.solar_j + row.external_j - row.load_j - row.drive_j - row.loss_j;
    const double throughput_j =
        std::abs(row.solar_j) + std::abs(row.external_j) + row.load_j + row.drive_j + row.loss_j;
    EXPECT_NEAR(row.energy_j - start_j, flowed_j, 1e-9 * throughput_j + 1e-9);
    EXPECT_NEAR(row.energy_rate_w,
                row.solar_w + row.external_w - row.load_w - row.drive_w - row.loss_w, 1e-9 * 1e4);
    EXPECT_GE(row.charge, 0);
    EXPECT_LE(row.charge, 1);
  }
}

}  // namespace lsos::test
