#include "mission/model/antenna.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/error.h"
#include "base/rotation_from_z.h"
#include "mission/port/equipment_fault.h"

namespace lsos {

namespace {

// Assumed thickness of masts, which no script gives. The head lies within the margin of viewers at
// it (`ViewMargins`).
constexpr double mast_m = 0.08, head_m = 0.25;
const Vec3 mast_colour(0.6, 0.6, 0.6), head_colour(0.9, 0.9, 0.9);

}  // namespace

std::string mast_joint(const AntennaSpec& antenna) { return "antenna " + antenna.name; }

std::vector<Shape> mast_shapes(const AntennaSpec& antenna, double extension_m) {
  const Vec3 from_B_m = *antenna.stowed_p_B_m;
  const Vec3 direction_B = (antenna.p_B_m - from_B_m).normalized();
  Shape head;
  head.size_m = Vec3::Constant(head_m);
  head.p_B_m = from_B_m + direction_B * extension_m;
  head.colour = head_colour;
  if (extension_m <= 0) return {head};
  Shape mast;
  mast.kind = Shape::Kind::cylinder;
  mast.size_m = {mast_m, mast_m, extension_m};
  mast.p_B_m = from_B_m + direction_B * (extension_m / 2);
  mast.R_BL = rotation_from_z(direction_B);
  mast.colour = mast_colour;
  return {mast, head};
}

std::vector<Shape> AntennaArray::masts(SimTime now) const {
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    if (!specs_[i].is_stowable()) continue;
    const std::vector<Shape> more = mast_shapes(specs_[i], extension_m(i, now));
    shapes.insert(shapes.end(), more.begin(), more.end());
  }
  return shapes;
}

double AntennaArray::mast_reach_m() const {
  double reach_m = 0;
  for (const AntennaSpec& spec : specs_) {
    if (!spec.is_stowable()) continue;
    reach_m = std::max({reach_m, spec.p_B_m.norm() + head_m, spec.stowed_p_B_m->norm() + head_m});
  }
  return reach_m;
}

void AntennaArray::begin(std::size_t i, bool is_up) {
  State& state = states_[i];
  state.goes_up = is_up;
  state.from = is_up ? 1 : 0;
  state.start = state.end = SimTime{};
}

void AntennaArray::set_dead(std::size_t i, bool is_dead, SimTime from) {
  states_[i].is_dead = is_dead;
  failed_ = from;
}

bool AntennaArray::is_up(std::size_t i, SimTime now) const {
  if (!specs_[i].is_stowable()) return true;
  const State& state = states_[i];
  return state.goes_up && state.end && now >= *state.end;
}

std::size_t AntennaArray::in_use(SimTime now) const {
  for (const bool must_work : {true, false}) {
    for (std::size_t i = 0; i < specs_.size(); ++i) {
      if (must_work ? has_link(i, now) : is_up(i, now)) return i;
    }
  }
  return 0;
}

Vec3 AntennaArray::p_B_m(SimTime now) const {
  const std::size_t i = in_use(now);
  return is_up(i, now) || !specs_[i].is_stowable() ? specs_[i].p_B_m : *specs_[i].stowed_p_B_m;
}

double AntennaArray::State::share_up(SimTime now) const {
  const double to = goes_up ? 1 : 0;
  if (!end || now >= *end) return to;
  return from + (to - from) * (seconds(now - *start) / seconds(*end - *start));
}

double AntennaArray::extension_m(std::size_t i, SimTime now) const {
  if (!specs_[i].is_stowable()) return 0;
  return states_[i].share_up(now) * (specs_[i].p_B_m - *specs_[i].stowed_p_B_m).norm();
}

double AntennaArray::power_w(SimTime now) const {
  double sum_w = 0;
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    if (has_link(i, now)) sum_w += specs_[i].power_w;
    if (states_[i].end && now < *states_[i].end) sum_w += specs_[i].deploy_w;
  }
  return sum_w;
}

Deployment AntennaArray::deploy(const std::string& name, bool up, std::optional<double> duration_s,
                                SimTime now) {
  std::vector<std::string> names;
  bool is_any = false;
  Deployment deployment;
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    if (specs_[i].is_stowable()) names.push_back(specs_[i].name);
    if (!name.empty() && specs_[i].name != name) continue;
    if (!specs_[i].is_stowable()) {
      if (name.empty()) continue;
      throw EquipmentFault(fmt::format("the antenna '{}' cannot be stowed", name));
    }
    is_any = true;
    State& state = states_[i];
    if (state.goes_up != up) {
      deployment.moves = true;
      const double takes_s = duration_s.value_or(specs_[i].deploy_s);
      state = {up, state.share_up(now), now, round_up_to_exchange(now + from_seconds(takes_s)),
               state.is_dead};
    }
    // An antenna that is on its way takes the time that is left.
    if (state.end && *state.end > now) {
      deployment.moves = true;
      deployment.takes_s = std::max(deployment.takes_s, seconds(*state.end - now));
    }
  }
  if (is_any) return deployment;
  if (name.empty() || names.empty()) {
    throw EquipmentFault("none of the rover's antennas can be stowed");
  }
  throw std::runtime_error(
      fmt::format("the rover has no antenna '{}'{}", name, did_you_mean(name, names)));
}

std::optional<SimTime> AntennaArray::next_end(SimTime now) const {
  std::optional<SimTime> next;
  if (failed_ && *failed_ > now) next = failed_;
  for (const State& state : states_) {
    if (state.end && *state.end > now) next = std::min(next.value_or(*state.end), *state.end);
  }
  return next;
}

bool AntennaArray::has_changed(SimTime now) const {
  if (failed_ == std::optional(now)) return true;
  return std::ranges::any_of(states_, [&](const State& state) {
    return state.start == std::optional(now) || state.end == std::optional(now);
  });
}

void AntennaArray::archive(Archive& a) {
  a.tag("antennas");
  LSOS_ARCHIVE(a, states_, failed_);
}

}  // namespace lsos
