#include "mission/antenna.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/error.h"

namespace lsos {

bool AntennaArray::is_up(std::size_t i, SimTime now) const {
  if (!specs_[i].is_stowable()) return true;
  const State& state = states_[i];
  return state.goes_up && state.end && now >= *state.end;
}

std::size_t AntennaArray::in_use(SimTime now) const {
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    if (is_up(i, now)) return i;
  }
  return 0;
}

Vec3 AntennaArray::p_B_m(SimTime now) const {
  const std::size_t i = in_use(now);
  return is_up(i, now) ? specs_[i].p_B_m : *specs_[i].stowed_p_B_m;
}

double AntennaArray::power_w(SimTime now) const {
  double sum_w = 0;
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    if (is_up(i, now)) sum_w += specs_[i].power_w;
    if (states_[i].end && now < *states_[i].end) sum_w += specs_[i].deploy_w;
  }
  return sum_w;
}

double AntennaArray::deploy(const std::string& name, bool up, std::optional<double> duration_s,
                            SimTime now) {
  std::vector<std::string> names;
  bool is_any = false;
  double longest_s = 0;
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    if (specs_[i].is_stowable()) names.push_back(specs_[i].name);
    if (!name.empty() && specs_[i].name != name) continue;
    if (!specs_[i].is_stowable()) {
      if (name.empty()) continue;
      throw std::runtime_error(fmt::format("the antenna '{}' cannot be stowed", name));
    }
    is_any = true;
    State& state = states_[i];
    if (state.goes_up != up) {
      const double takes_s = duration_s.value_or(specs_[i].deploy_s);
      state = {up, now, round_up_to_exchange(now + from_seconds(takes_s))};
    }
    // One that is there, or on its way, takes what is left.
    if (state.end) longest_s = std::max(longest_s, seconds(*state.end - now));
  }
  if (is_any) return longest_s;
  throw std::runtime_error(
      name.empty() || names.empty()
          ? "none of the rover's antennas can be stowed"
          : fmt::format("the rover has no antenna '{}'{}", name, did_you_mean(name, names)));
}

std::optional<SimTime> AntennaArray::next_end(SimTime now) const {
  std::optional<SimTime> next;
  for (const State& state : states_) {
    if (state.end && *state.end > now) next = std::min(next.value_or(*state.end), *state.end);
  }
  return next;
}

bool AntennaArray::has_changed(SimTime now) const {
  return std::ranges::any_of(states_, [&](const State& state) {
    return state.told == std::optional(now) || state.end == std::optional(now);
  });
}

void AntennaArray::archive(Archive& a) { a.tag("antennas")(states_); }

}  // namespace lsos
