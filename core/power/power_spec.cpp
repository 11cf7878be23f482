#include "power/power_spec.h"

namespace lsos {

namespace {

bool is_on(LoadState when, const LoadConditions& conditions) {
  switch (when) {
    case LoadState::always:
      return true;
    case LoadState::dark:
      return conditions.is_dark;
    case LoadState::parked:
      return conditions.is_parked;
    case LoadState::driving:
      return !conditions.is_parked;
  }
  return false;
}

}  // namespace

double load_w(std::span<const LoadSpec> loads, const LoadConditions& conditions) {
  double sum_w = 0;
  for (const LoadSpec& load : loads) {
    if (is_on(load.when, conditions)) sum_w += load.power_w;
  }
  return sum_w;
}

}  // namespace lsos
