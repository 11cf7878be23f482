#include "vehicle/posture_control.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

constexpr SimTime update_period{20'000};
constexpr double follow_1ps = 2;  // k without levelling: with which limbs return to their stance
constexpr double still_share = 0.02;  // of a joint's greatest rate, below which it gains nothing
constexpr double still_for_s = 0.5;
const double standing_max_s = seconds(PostureControl::longest);
constexpr double end_share = 0.1;  // of a hub's way, which a limb misses at its end and not before
constexpr double yield_share = 0.5;   // of the stance's height, which levelling may take
constexpr double loaded_share = 0.3;  // of an equal load, with which a wheel stands on its ground

// Best linear function of x and y through values at places: its mean and its gradients.
struct Plane {
  double mean = 0, b = 0, c = 0;
};

Plane fit(const std::vector<Vec2>& places, const std::vector<double>& values) {
  Eigen::Matrix2d sums = Eigen::Matrix2d::Zero();
  Vec2 moments = Vec2::Zero();
  Plane plane;
  for (const double value : values) plane.mean += value / static_cast<double>(values.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    sums += places[i] * places[i].transpose();
    moments += places[i] * (values[i] - plane.mean);
  }
  const Vec2 gradient = sums.inverse() * moments;
  plane.b = gradient.x();
  plane.c = gradient.y();
  return plane;
}

}  // namespace

PostureControl::PostureControl(const VehicleConfig& vehicle)
    : steps_(std::max(1, static_cast<int>(update_period / vehicle.step))),
      period_s_(steps_ * seconds(vehicle.step)),
      chains_(limb_chains(vehicle)),
      gains_(vehicle.posture),
      is_level_(vehicle.starts_level) {
  for (std::size_t i = 0; i < vehicle.limbs.size(); ++i) {
    std::vector<double> initial_rad;
    std::vector<LimbActuator>& actuators = actuators_.emplace_back();
    for (const int joint : vehicle.limbs[i].joints) {
      const LinkConfig& link = vehicle.links[static_cast<std::size_t>(joint)];
      actuators.push_back(*link.limb);
      initial_rad.push_back(link.initial);
    }
    nominal_B_m_.push_back(chains_[i].pose(initial_rad).hub_B_m);
    const LinkConfig& wheel = vehicle.links[static_cast<std::size_t>(vehicle.limbs[i].wheel)];
    grounded_z_m_ += (vehicle.chassis_clearance_m + wheel.wheel->radius_m) /
                     static_cast<double>(vehicle.limbs.size());
  }
  target_B_m_ = nominal_B_m_;
}

void PostureControl::move_to(const std::vector<Vec3>& hubs_B_m, bool is_level, double duration_s) {
  target_B_m_ = hubs_B_m;
  is_level_ = is_level;
  move_left_s_ = duration_s;
  wake();
}

double PostureControl::settling_s(double rate_share) const {
  const double k = gains_ ? gains_->leveling_1ps : follow_1ps;
  const double lag_s = std::log(std::max(1.0, rate_share / still_share)) / k;
  return std::min(standing_max_s, lag_s + still_for_s);
}

void PostureControl::stand_on(const std::vector<Vec3>& hubs_B_m, bool is_level) {
  nominal_B_m_ = hubs_B_m;
  move_to(hubs_B_m, is_level, 0);
}

void PostureControl::wake() {
  is_adjusting_ = true;
  still_s_ = standing_s_ = 0;
}

PostureControl::ExtensionRates PostureControl::extension_rates(
    const Input& input, const std::vector<double>& extensions_m) const {
  std::vector<Vec2> places;
  Vec2 middle = Vec2::Zero();
  const auto count = static_cast<double>(nominal_B_m_.size());
  for (const Vec3& hub : nominal_B_m_) middle += hub.head<2>() / count;
  for (const Vec3& hub : nominal_B_m_) places.push_back(hub.head<2>() - middle);

  const double k = gains_ ? gains_->leveling_1ps : follow_1ps;
  const Plane extension = fit(places, extensions_m), load = fit(places, input.loads_n);
  Vec2 gradient_rate = -k * Vec2(extension.b, extension.c);
  if (gains_ && is_level_) gradient_rate = k * input.up_B.head<2>();
  ExtensionRates rates;
  rates.height_mps = -k * extension.mean;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto excess = [&](const Plane& plane, double value) {
      return value - plane.mean - plane.b * places[i].x() - plane.c * places[i].y();
    };
    rates.turning_mps.push_back(gradient_rate.dot(places[i]));
    rates.whole_mps.push_back(rates.turning_mps[i] + rates.height_mps +
                              (gains_ ? gains_->load_sharing_mps_pn * excess(load, input.loads_n[i])
                                      : -k * excess(extension, extensions_m[i])));
  }
  return rates;
}

PostureControl::LimbStep PostureControl::limb_step(std::size_t limb, const Input& input,
                                                   const Vec3& move_m) const {
  const std::vector<double>& from_rad = input.angles_rad[limb];
  const std::vector<double> step = chains_[limb].step_rad(from_rad, move_m, input.is_fixed[limb]);
  // The slowest joint sets the pace of its limb, so that the hub keeps its line.
  double share = 1;
  for (std::size_t j = 0; j < step.size(); ++j) {
    share = std::min(share, actuators_[limb][j].motor.rate_max_radps * period_s_ /
                                std::max(std::abs(step[j]), 1e-12));
  }
  LimbStep result;
  for (std::size_t j = 0; j < step.size(); ++j) {
    const LimbActuator& actuator = actuators_[limb][j];
    // What was forced out of its range comes back at the motor's rate.
    const double most_rad = actuator.motor.rate_max_radps * period_s_;
    const double wanted_rad =
        std::clamp(from_rad[j] + share * step[j], actuator.angle_min_rad, actuator.angle_max_rad);
    result.angles_rad.push_back(
        input.is_fixed[limb][j]
            ? from_rad[j]
            : std::clamp(wanted_rad, from_rad[j] - most_rad, from_rad[j] + most_rad));
  }
  const LimbChain& chain = chains_[limb];
  const double wanted_m = share * move_m.z();
  const double done_m =
      chain.pose(result.angles_rad).hub_B_m.z() - chain.pose(from_rad).hub_B_m.z();
  if (wanted_m != 0) result.missed_share = std::clamp(1 - done_m / wanted_m, 0.0, 1.0);
  return result;
}

double PostureControl::yield_mps(const Input& input, const ExtensionRates& rates,
                                 const std::vector<LimbStep>& steps,
                                 double mean_extension_m) const {
  double down_mps = 0, up_mps = 0;  // what limbs at their ends lack, as rates of their hubs
  double share_n = 0;
  for (const double load_n : input.loads_n) {
    share_n += load_n / static_cast<double>(input.loads_n.size());
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool is_fixed = std::ranges::find(input.is_fixed[i], true) != input.is_fixed[i].end();
    if (is_fixed || steps[i].missed_share < end_share) continue;
    // A wheel that hangs over a hole is no reason to lower a chassis that is level.
    const double stands = std::clamp(input.loads_n[i] / (loaded_share * share_n), 0.0, 1.0);
    const double lacks_mps =
        steps[i].missed_share * (rates.turning_mps[i] + stands * rates.height_mps);
    (rates.whole_mps[i] < 0 ? down_mps : up_mps) =
        rates.whole_mps[i] < 0 ? std::min(down_mps, lacks_mps) : std::max(up_mps, lacks_mps);
  }
  // With limbs at both ends the ground is too steep for them.
  if (down_mps < 0 && up_mps > 0) return 0;
  double height_m = grounded_z_m_;
  for (const Vec3& hub : nominal_B_m_) {
    height_m -= hub.z() / static_cast<double>(nominal_B_m_.size());
  }
  const double most_m = yield_share * std::max(0.0, height_m);
  return std::clamp(-down_mps - up_mps, std::min(0.0, (-most_m - mean_extension_m) / period_s_),
                    std::max(0.0, (most_m - mean_extension_m) / period_s_));
}

std::vector<std::vector<double>> PostureControl::rates_radps(const Input& input) {
  std::vector<std::vector<double>> rates;
  for (const LimbChain& chain : chains_) rates.emplace_back(chain.size(), 0.0);
  if (input.is_driving) wake();
  if (!is_adjusting_) return rates;

  if (move_left_s_ > 0) {
    const double share = std::min(1.0, period_s_ / move_left_s_);
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      nominal_B_m_[i] += share * (target_B_m_[i] - nominal_B_m_[i]);
    }
    move_left_s_ = std::max(0.0, move_left_s_ - period_s_);
    still_s_ = standing_s_ = 0;
  }
  std::vector<Vec3> moves_m;
  std::vector<double> extensions_m;
  double mean_extension_m = 0;
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    const Vec3 hub_B_m = chains_[i].pose(input.angles_rad[i]).hub_B_m;
    extensions_m.push_back(hub_B_m.z() - nominal_B_m_[i].z());
    mean_extension_m += extensions_m[i] / static_cast<double>(chains_.size());
    moves_m.push_back(nominal_B_m_[i] - hub_B_m);
  }
  const ExtensionRates extension_rates = this->extension_rates(input, extensions_m);
  std::vector<LimbStep> steps;
  const auto make_steps = [&](double more_mps) {
    steps.clear();
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      moves_m[i].z() = (extension_rates.whole_mps[i] + more_mps) * period_s_;
      steps.push_back(limb_step(i, input, moves_m[i]));
    }
  };
  make_steps(0);
  const double more_mps = yield_mps(input, extension_rates, steps, mean_extension_m);
  if (more_mps != 0) make_steps(more_mps);

  bool is_still = true;
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    for (std::size_t j = 0; j < rates[i].size(); ++j) {
      rates[i][j] = (steps[i].angles_rad[j] - input.angles_rad[i][j]) / period_s_;
      is_still &= std::abs(rates[i][j]) <= still_share * actuators_[i][j].motor.rate_max_radps;
    }
  }
  if (!input.is_driving) {
    standing_s_ += period_s_;
    still_s_ = is_still ? still_s_ + period_s_ : 0;
    is_adjusting_ = move_left_s_ > 0 || (still_s_ < still_for_s && standing_s_ < standing_max_s);
    if (!is_adjusting_) {
      for (std::vector<double>& limb : rates) std::ranges::fill(limb, 0.0);
    }
  }
  return rates;
}

void PostureControl::archive(Archive& a) {
  LSOS_ARCHIVE(a, nominal_B_m_, target_B_m_, move_left_s_, is_level_, is_adjusting_, standing_s_,
               still_s_);
}

}  // namespace lsos
