// Posture control of a vehicle on limbs: the angles to which its joints turn.
//
// Each limb has a nominal place of its wheel's hub under the chassis, given by the stance. Hubs
// deviate from it along the chassis' z axis by extensions e_i, whose rates are the sum of three
// parts:
//  - Attitude. A pattern that is linear in the hubs' places x, y turns the chassis: with b, c the
//    gradient of e over x and y, b' = k up_x and c' = k up_y, where `up` is the vertical in the
//    chassis' axes and k PostureGains::leveling_1ps. A chassis that is not to be level has b' = -k
//    b instead: it lies parallel to the plane of its wheels.
//  - Height. The mean of e returns to 0 with the same k. Where a limb is at its end and the
//  attitude
//    needs more of it, all hubs move the other way instead: the chassis gives up height, at most
//    half of what its stance has, and turns on.
//  - Load. What is left of the wheels' loads F after subtracting their best linear function of x
//    and y says which limbs carry too much for any attitude: e' = g F, with
//    PostureGains::load_sharing_mps_pn. Four or more limbs then share the load as evenly as the
//    centre of mass allows, on any ground.
// Sideways, hubs are held at their nominal places and steering axes along the chassis' z axis. The
// joints follow by inverse kinematics (limb_chain.h), at most at their rates.
#pragma once

#include <optional>
#include <vector>

#include "base/archive.h"
#include "base/sim_time.h"
#include "vehicle/limb_chain.h"

namespace lsos {

class PostureControl {
 public:
  explicit PostureControl(const VehicleConfig& vehicle);

  // Steps of the vehicle, about 20 ms, for which rates hold.
  int steps() const { return steps_; }

  const std::vector<LimbChain>& chains() const { return chains_; }
  const std::vector<Vec3>& hubs_B_m() const { return nominal_B_m_; }  // nominal, by limb
  // The nominal hubs at the end of the move that is under way.
  const std::vector<Vec3>& target_hubs_B_m() const { return target_B_m_; }
  bool is_level() const { return is_level_; }

  // Begins to move the nominal hubs to `hubs_B_m`, along straight lines, in `duration_s`.
  void move_to(const std::vector<Vec3>& hubs_B_m, bool is_level, double duration_s);

  // Makes these the nominal hubs at once, for a vehicle that is placed anew.
  void stand_on(const std::vector<Vec3>& hubs_B_m, bool is_level);

  struct Input {
    Vec3 up_B = Vec3::UnitZ();                    // local vertical
    std::vector<double> loads_n;                  // on the wheels, by limb
    std::vector<std::vector<double>> angles_rad;  // commanded until now, by limb and joint
    std::vector<std::vector<bool>> is_fixed;      // joints that cannot turn
    bool is_driving = false;
  };
  // Rates for the coming steps(), by limb and joint, rad/s.
  std::vector<std::vector<double>> rates_radps(const Input& input);

  // Whether it moves the limbs although the vehicle stands. It ends when the rates are so low that
  // nothing more is gained, and after this time in any case.
  static constexpr SimTime longest{60'000'000};
  bool is_adjusting() const { return is_adjusting_; }
  // How long it goes on adjusting after a move at this share of the joints' greatest rates: limbs
  // follow with a lag that decays exponentially.
  double settling_s(double rate_share) const;
  // Begins to adjust again.
  void wake();

  void archive(Archive& a);
  bool is_sound() const {
    return nominal_B_m_.size() == chains_.size() && target_B_m_.size() == chains_.size();
  }

 private:
  // Rates of the extensions by limb: all of each, its part that turns the chassis, and the part of
  // all that keeps the height.
  struct ExtensionRates {
    std::vector<double> whole_mps, turning_mps;
    double height_mps = 0;
  };
  ExtensionRates extension_rates(const Input& input, const std::vector<double>& extensions_m) const;
  // Angles after the next period, by joint, and the share of the way along the chassis' z axis that
  // the hub does not make, because the limb is at its end.
  struct LimbStep {
    std::vector<double> angles_rad;
    double missed_share = 0;
  };
  LimbStep limb_step(std::size_t limb, const Input& input, const Vec3& move_m) const;
  // What is added to all extension rates where a limb is at its end.
  double yield_mps(const Input& input, const ExtensionRates& rates,
                   const std::vector<LimbStep>& steps, double mean_extension_m) const;

  int steps_ = 1;
  double period_s_ = 0;
  std::vector<LimbChain> chains_;
  std::optional<PostureGains> gains_;
  std::vector<std::vector<LimbActuator>> actuators_;  // by limb and joint
  double grounded_z_m_ = 0;  // mean z of the hubs with the chassis' underside on the ground
  std::vector<Vec3> nominal_B_m_, target_B_m_;
  double move_left_s_ = 0;
  bool is_level_ = true;
  bool is_adjusting_ = true;
  double standing_s_ = 0;  // time since it began to adjust while the vehicle stands
  double still_s_ = 0;     // time for which all rates have been low
};

}  // namespace lsos
