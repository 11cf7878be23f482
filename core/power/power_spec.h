// What a rover script declares of its power system: battery, panels, loads and resources.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "power/battery.h"
#include "power/panel.h"

namespace lsos {

// When a load is on.
enum class LoadState {
  always,
  dark,  // no sunlight falls on the rover
  parked,
  driving,  // not parked; the wheel motors' power is counted separately
};

struct LoadSpec {
  std::string name;
  double power_w = 0;
  LoadState when = LoadState::always;
};

// A supply that events consume: oxygen, sample tubes.
struct ResourceSpec {
  std::string name;
  std::string unit;
  double amount = 0;  // at the start
};

struct PowerSpec {
  std::optional<BatterySpec> battery;  // absent: the energy balance is not modelled
  std::vector<PanelSpec> panels;
  double generator_w = 0;  // constant power made aboard, which counts as external
  std::vector<LoadSpec> loads;
  std::vector<ResourceSpec> resources;
};

// The conditions of a rover that decide which loads are on.
struct LoadConditions {
  bool is_dark = false;
  bool is_parked = false;
};
double load_w(std::span<const LoadSpec> loads, const LoadConditions& conditions);

}  // namespace lsos
