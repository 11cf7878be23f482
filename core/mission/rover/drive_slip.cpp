#include "mission/rover/drive_slip.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/sim_time.h"

namespace lsos {

namespace {

// Below this speed, or this share of the cruise speed, slip cannot be distinguished from creeping.
constexpr double creeping_mps = 0.05, creeping_share = 0.1;
// Below this share of the requested speed the rover sets off or stops.
constexpr double requested_share = 0.5;

}  // namespace

void SecondMean::add(double value) {
  if (std::isnan(value)) {
    count_ = 0;
  } else {
    last_[count_++ % exchanges] = value;
  }
}

double SecondMean::value() const {
  if (count_ < exchanges) return not_modelled;
  return std::accumulate(last_.begin(), last_.end(), 0.0) / exchanges;
}

void SecondMean::archive(Archive& a) {
  for (double& value : last_) LSOS_ARCHIVE(a, value);
  LSOS_ARCHIVE(a, count_);
}

void SlipHistogram::add(double slip) {
  ++exchanges_[static_cast<std::int32_t>(std::lround(std::clamp(slip, -1.0, 1.0) * bins))];
}

bool SlipHistogram::is_sound() const {
  return std::ranges::all_of(exchanges_, [](const auto& bin) {
    return std::abs(bin.first) <= bins && bin.second > 0 && bin.second < (std::int64_t{1} << 40);
  });
}

double SlipHistogram::quantile(double share) const {
  std::int64_t all = 0, below = 0;
  for (const auto& [number, count] : exchanges_) all += count;
  for (const auto& [number, count] : exchanges_) {
    below += count;
    if (static_cast<double>(below) >= share * static_cast<double>(all)) return number / bins;
  }
  return not_modelled;
}

void DriveSlip::add(const Motion& motion) {
  const double fast_mps = requested_share * motion.requested_mps;
  const bool is_rolling = motion.is_commanded && motion.command_mps >= fast_mps;
  now_.add(is_rolling ? motion.slip : not_modelled);
  now_max_.add(is_rolling ? motion.slip_max : not_modelled);
  if (is_rolling) {
    ++rolling_exchanges_;
    rolling_m_ += motion.speed_mps * seconds(exchange_period);
    requested_m_ += motion.requested_mps * seconds(exchange_period);
  }
  if (!(greatest_rolling_ >= now()) && !std::isnan(now())) greatest_rolling_ = now();
  const double moving_mps = std::min(creeping_mps, creeping_share * motion.cruise_mps);
  const bool is_driving =
      motion.is_commanded && motion.speed_mps > moving_mps && motion.speed_mps > fast_mps;
  const double slip = is_driving ? motion.slip : not_modelled;
  driving_.add(slip);
  if (!std::isnan(slip)) histogram_.add(slip);
  const double mean = driving_.value();
  if (!(greatest_ >= mean) && !std::isnan(mean)) greatest_ = mean;
}

double DriveSlip::driven_s() const {
  return static_cast<double>(rolling_exchanges_) * seconds(exchange_period);
}

}  // namespace lsos
