// Posture control of a vehicle on limbs: the angles to which its joints turn.
//
// Each limb has a nominal place of its wheel's hub under the chassis, given by the stance. Hubs
// deviate from it along the chassis' z axis by extensions e_i, whose rates are the sum of three
// parts:
//  - Attitude. A pattern that is linear in the hubs' places x, y turns the chassis: with b, c the
//    gradient of e over x and y, b' = k up_x and c' = k up_y, where `up` is the vertical in the
//    chassis' axes and k PostureGains::leveling_1ps. A chassis that is not to be level has b' = -k
//    b instead: it lies parallel to the plane of its wheels.
//  - Height. The mean of e returns to 0 with the same k.
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
  bool is_level() const { return is_level_; }

  // Begins to move the nominal hubs to `hubs_B_m`, along straight lines, in `duration_s`.
  void move_to(const std::vector<Vec3>& hubs_B_m, bool is_level, double duration_s);

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
  // nothing more is gained, and after a minute in any case.
  bool is_adjusting() const { return is_adjusting_; }
  // Begins to adjust again.
  void wake();

  void archive(Archive& a);

 private:
  std::vector<double> extension_rates_mps(const Input& input,
                                          const std::vector<double>& extensions_m) const;

  int steps_ = 1;
  double period_s_ = 0;
  std::vector<LimbChain> chains_;
  std::optional<PostureGains> gains_;
  std::vector<std::vector<LimbActuator>> actuators_;  // by limb and joint
  std::vector<Vec3> nominal_B_m_, target_B_m_;
  double move_left_s_ = 0;
  bool is_level_ = true;
  bool is_adjusting_ = true;
  double standing_s_ = 0;  // time since it began to adjust while the vehicle stands
  double still_s_ = 0;     // time for which all rates have been low
};

}  // namespace lsos
