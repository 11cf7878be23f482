// The rigid bodies of one vehicle, advanced by Bullet's articulated-body algorithm (btMultiBody) in
// double precision. There are no constraints, contacts or warm starts: the state consists of
// positions and velocities alone and can be restored exactly.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/archive.h"
#include "base/vector.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Pose and motion of a link in the site frame S; C is its centre of mass.
struct LinkMotion {
  Vec3 p_C_S_m = Vec3::Zero();
  Mat3 R_SL = Mat3::Identity();
  Vec3 v_C_S_mps = Vec3::Zero();
  Vec3 omega_S_radps = Vec3::Zero();

  // Velocity of the link's material at a point.
  Vec3 velocity_at(const Vec3& p_S_m) const {
    return v_C_S_mps + omega_S_radps.cross(p_S_m - p_C_S_m);
  }
};

class Multibody {
 public:
  static constexpr int chassis = -1;

  explicit Multibody(const VehicleConfig& config);
  ~Multibody();

  // Places the chassis' reference frame B at a pose, with joints at their initial positions or at
  // `joints` (m or rad, by link), and everything at rest.
  void place(const Vec3& p_SB_m, const Mat3& R_SB) { place(p_SB_m, R_SB, initial_); }
  void place(const Vec3& p_SB_m, const Mat3& R_SB, const std::vector<double>& joints);

  // Motion of the chassis (Multibody::chassis) or link i, as of the last step or place.
  const LinkMotion& motion(int link) const { return motions_[static_cast<std::size_t>(link + 1)]; }
  double joint_position(int link) const;
  double joint_velocity(int link) const;

  // Forces of the next step, which clears them.
  void add_force(int link, const Vec3& force_S_n, const Vec3& point_S_m);
  void add_wrench(int link, const Vec3& force_S_n, const Vec3& torque_S_n_m);  // torque about C
  void add_gravity(const Vec3& g_S_mps2);
  void add_joint_force(int link, double force);  // N or N m, on the link, along its axis

  void step(double step_s);
  // The first link (or `chassis`) whose motion is not a finite number; nullopt: all are.
  std::optional<int> non_finite_link() const;
  // Kinetic energy, and potential energy in gravity `g_S_mps2` above the site's origin, J.
  double kinetic_j() const;
  double potential_j(const Vec3& g_S_mps2) const;

  // Sets all velocities to exactly zero.
  void halt();

  void archive(Archive& a);
  // Whether all numbers are finite, within reach of the ground, and the rotation is one.
  bool is_placed() const;

 private:
  void update_motions();

  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::vector<int> parents_;
  std::vector<double> initial_;      // m or rad, by link
  std::vector<LinkMotion> motions_;  // chassis first
};

}  // namespace lsos
