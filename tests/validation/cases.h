// The sets of measurements, each with the published parameters of its soil, which of them may be
// fitted, and the fit.
#pragma once

#include <string>
#include <vector>

#include "validation/fit.h"

namespace lsos::validation {

// A parameter of a soil or rig that is not fitted.
struct Constant {
  std::string name, value, why;
};

struct Case {
  std::string name;  // short, for tables
  Soil published;
  std::vector<FitParameter> parameters;
  std::vector<Constant> constants;
  WheelTests tests;
  WheelTests grousered;                 // on the same soil, never fitted; empty: none was measured
  std::vector<MeasuredPoint> straight;  // straight rolling, not locked; these are fitted
  Fit fit;
};

// Each reads its measurements (which may throw, see wheel_data.h) and fits its soil.
Case cmu_case(const std::string& folder);
Case ding_case(const std::string& folder);
Case kls_case(const std::string& folder);

// Points of one slip angle, the locked wheel (slip -1) left out.
std::vector<MeasuredPoint> rolling_at(const WheelTests& tests, double slip_angle_deg);
// The same for several slip angles.
std::vector<MeasuredPoint> rolling_at(const WheelTests& tests,
                                      const std::vector<double>& slip_angles_deg);
std::vector<MeasuredPoint> locked(const WheelTests& tests);

// Growth of the computed sinkage with the rig's slip, under the mean load of the straight points.
struct SinkageGrowth {
  double least_at_slip = 0;
  double at_least_m = 0, at_zero_m = 0;
  bool grows_driven = false;  // from slip 0 to 0.9
  bool grows_braked = false;  // from slip 0 to -0.7
};
SinkageGrowth sinkage_growth(const Case& c);

}  // namespace lsos::validation
