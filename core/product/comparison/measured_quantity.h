// The quantities of a rover that telemetry may have measured: the numbers of the log's samples.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/units.h"
#include "record/quantities.h"

namespace lsos {

struct MeasuredQuantity {
  std::string name;            // of the log's column: "speed_mps"
  std::string base;            // without its unit: "speed"
  std::string title;           // "Speed, m/s"
  const Unit* unit = nullptr;  // SI
  const Quantity* logged = nullptr;
  int axis = -1;  // of x_m, y_m, z_m, which are no entries of the register

  double value(const SampleRow& row) const;
  // Values that differ by whole turns are the same.
  bool is_angle() const { return unit->kind == "angle"; }
};

const std::vector<MeasuredQuantity>& measured_quantities();

// Difference a - b; of angles the shorter way round, -pi..pi.
double difference(const MeasuredQuantity& quantity, double a, double b);

}  // namespace lsos
