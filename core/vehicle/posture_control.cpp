#include "vehicle/posture_control.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace lsos {

namespace {

constexpr SimTime update_period{20'000};
constexpr double follow_1ps = 2;  // k without levelling: with which limbs return to their stance
constexpr double still_share = 0.02;  // of a joint's greatest rate, below which it gains nothing
constexpr double still_for_s = 0.5, standing_max_s = 60;

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
  }
  target_B_m_ = nominal_B_m_;
}

void PostureControl::move_to(const std::vector<Vec3>& hubs_B_m, bool is_level, double duration_s) {
  target_B_m_ = hubs_B_m;
  is_level_ = is_level;
  move_left_s_ = duration_s;
  wake();
}

void PostureControl::wake() {
  is_adjusting_ = true;
  still_s_ = standing_s_ = 0;
}

std::vector<double> PostureControl::extension_rates_mps(
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
  std::vector<double> rates;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto excess = [&](const Plane& plane, double value) {
      return value - plane.mean - plane.b * places[i].x() - plane.c * places[i].y();
    };
    rates.push_back(gradient_rate.dot(places[i]) - k * extension.mean +
                    (gains_ ? gains_->load_sharing_mps_pn * excess(load, input.loads_n[i])
                            : -k * excess(extension, extensions_m[i])));
  }
  return rates;
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
  std::vector<Vec3> hubs_B_m;
  std::vector<double> extensions_m;
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    hubs_B_m.push_back(chains_[i].pose(input.angles_rad[i]).hub_B_m);
    extensions_m.push_back(hubs_B_m[i].z() - nominal_B_m_[i].z());
  }
  const std::vector<double> extension_rates = extension_rates_mps(input, extensions_m);
  bool is_still = true;
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    Vec3 move_m = nominal_B_m_[i] - hubs_B_m[i];
    move_m.z() = extension_rates[i] * period_s_;
    const std::vector<double> step =
        chains_[i].step_rad(input.angles_rad[i], move_m, input.is_fixed[i]);
    // The slowest joint sets the pace of its limb, so that the hub keeps its line.
    double share = 1;
    for (std::size_t j = 0; j < step.size(); ++j) {
      share = std::min(share, actuators_[i][j].motor.rate_max_radps * period_s_ /
                                  std::max(std::abs(step[j]), 1e-12));
    }
    for (std::size_t j = 0; j < step.size(); ++j) {
      const LimbActuator& actuator = actuators_[i][j];
      const double from = input.angles_rad[i][j];
      const double to =
          std::clamp(from + share * step[j], actuator.angle_min_rad, actuator.angle_max_rad);
      rates[i][j] = (to - from) / period_s_;
      is_still &= std::abs(rates[i][j]) <= still_share * actuator.motor.rate_max_radps;
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
