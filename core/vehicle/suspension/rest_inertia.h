// Effective inertia of a vehicle at rest, as seen by forces in its joints and at its wheels, with
// all its other joints free.
#pragma once

#include <Eigen/Cholesky>

#include "vehicle/vehicle_config.h"

namespace lsos {

class RestInertia {
 public:
  explicit RestInertia(const VehicleConfig& vehicle);

  // Inertia of a joint, kg or kg m2: force for each unit of relative acceleration in it.
  double of_joint(int link) const;
  // Inertia of a coupling, kg m2: torque on both joints for each unit of acceleration of their
  // angles' sum.
  double of_coupling(const JointCoupling& coupling) const;
  // Inertia of a point of a link, kg: force along a unit vector for each unit of acceleration
  // there.
  double of_point(int link, const Vec3& p_B_m, const Vec3& direction_B) const;
  // Angular frequency of the stiffest mode of the vehicle on the springs of its wheels, the servos
  // of its limbs and steering, and its brakes, rad/s.
  double stiffest_mode_radps() const;

 private:
  using Matrix = Eigen::MatrixXd;
  using Vector = Eigen::VectorXd;

  // Velocity of a link's material at a point, and its angular velocity, as linear functions (3 x n)
  // of the chassis' velocity at the origin, its angular velocity, and the joint rates.
  Matrix velocity(int link, const Vec3& p_B_m) const;
  Matrix angular_velocity(int link) const;
  double seen_along(const Vector& direction) const;

  const VehicleConfig* vehicle_;
  Eigen::LDLT<Matrix> mass_;
};

}  // namespace lsos
