// What a rover's script says of its power: battery, panels, loads and stores.
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
  driving,  // not parked; the wheel motors themselves count apart
};

struct LoadSpec {
  std::string name;
  double power_w = 0;
  LoadState when = LoadState::always;
};

// Something that events use up: oxygen, sample tubes.
struct ResourceSpec {
  std::string name;
  std::string unit;
  double amount = 0;  // at the start
};

struct PowerSpec {
  std::optional<BatterySpec> battery;  // absent: the energy balance is not modelled
  std::vector<PanelSpec> panels;
  std::vector<LoadSpec> loads;
  std::vector<ResourceSpec> resources;
};

// What of a rover decides which loads are on.
struct LoadConditions {
  bool is_dark = false;
  bool is_parked = false;
};
double load_w(std::span<const LoadSpec> loads, const LoadConditions& conditions);

}  // namespace lsos
