// What was measured of a rover at a moment of a mission, to go on from in place of what was
// simulated.
#pragma once

#include <optional>

#include "base/error.h"
#include "planet/body.h"

namespace lsos {

// What is absent was not measured, and stays as simulated.
struct MeasuredState {
  std::optional<Geodetic> place;  // of the reference point; its height is not used
  std::optional<double> heading_rad;
  std::optional<double> charge;    // 0..1, with some noise beyond
  std::optional<double> energy_j;  // that the battery holds; only without `charge`
  Place row;                       // of the table, for messages
};

// How far from its simulated place and charge a rover was put.
struct Correction {
  double moved_m = 0, turned_rad = 0;  // -pi..pi
  double stopped_mps = 0;              // at which it drove when it was put there, at rest
  std::optional<double> charge_before;
};

}  // namespace lsos
