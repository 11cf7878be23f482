#include "vehicle/suspension/rest_inertia.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "vehicle/suspension/link_parts.h"

namespace lsos {

namespace {

constexpr int base_freedoms = 6;

// skew(a) b = a x b
Mat3 skew(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

}  // namespace

RestInertia::RestInertia(const VehicleConfig& vehicle) : vehicle_(&vehicle) {
  const auto size = static_cast<Eigen::Index>(vehicle.links.size()) + base_freedoms;
  Matrix mass = Matrix::Zero(size, size);
  const auto add = [&](int link, const Inertia& inertia, const Vec3& center_B_m) {
    const Matrix v = velocity(link, center_B_m), w = angular_velocity(link);
    mass +=
        inertia.mass_kg * v.transpose() * v + w.transpose() * inertia.moments_kgm2.asDiagonal() * w;
  };
  add(-1, vehicle.chassis, vehicle.p_BC_m);
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    const int link = static_cast<int>(i);
    add(link, vehicle.links[i].inertia, joint_at_rest_B_m(vehicle, link) + vehicle.links[i].p_JC_m);
  }
  mass_.compute(mass);
}

RestInertia::Matrix RestInertia::angular_velocity(int link) const {
  Matrix w = Matrix::Zero(3, static_cast<Eigen::Index>(vehicle_->links.size()) + base_freedoms);
  w.middleCols<3>(3).setIdentity();
  for (; link >= 0; link = vehicle_->links[static_cast<std::size_t>(link)].parent) {
    const LinkConfig& config = vehicle_->links[static_cast<std::size_t>(link)];
    if (config.joint == JointType::revolute) w.col(base_freedoms + link) = config.axis;
  }
  return w;
}

RestInertia::Matrix RestInertia::velocity(int link, const Vec3& p_B_m) const {
  Matrix v = Matrix::Zero(3, static_cast<Eigen::Index>(vehicle_->links.size()) + base_freedoms);
  v.leftCols<3>().setIdentity();
  v.middleCols<3>(3) = -skew(p_B_m);
  for (; link >= 0; link = vehicle_->links[static_cast<std::size_t>(link)].parent) {
    const LinkConfig& config = vehicle_->links[static_cast<std::size_t>(link)];
    v.col(base_freedoms + link) =
        config.joint == JointType::revolute
            ? Vec3(config.axis.cross(p_B_m - joint_at_rest_B_m(*vehicle_, link)))
            : config.axis;
  }
  return v;
}

// A force along d accelerates the vehicle by M^-1 d, whose part along d is d . M^-1 d.
double RestInertia::seen_along(const Vector& direction) const {
  return 1 / direction.dot(mass_.solve(direction));
}

double RestInertia::of_joint(int link) const {
  return seen_along(Vector::Unit(mass_.rows(), base_freedoms + link));
}

double RestInertia::of_coupling(const JointCoupling& coupling) const {
  return seen_along(Vector::Unit(mass_.rows(), base_freedoms + coupling.first) +
                    Vector::Unit(mass_.rows(), base_freedoms + coupling.second));
}

double RestInertia::of_point(int link, const Vec3& p_B_m, const Vec3& direction_B) const {
  return seen_along(velocity(link, p_B_m).transpose() * direction_B);
}

double RestInertia::stiffest_mode_radps() const {
  Matrix stiffness = Matrix::Zero(mass_.rows(), mass_.cols());
  for (std::size_t i = 0; i < vehicle_->links.size(); ++i) {
    const LinkConfig& link = vehicle_->links[i];
    const int index = static_cast<int>(i);
    double& joint = stiffness(base_freedoms + index, base_freedoms + index);
    if (link.limb) joint += link.limb->motor.stiffness_n_m_prad;
    if (link.steering) joint += link.steering->stiffness_n_m_prad;
    if (link.drive) joint += link.drive->brake_stiffness_n_m_prad;
    if (!link.wheel) continue;
    const Vec3 contact_B_m =
        joint_at_rest_B_m(*vehicle_, index) - link.wheel->radius_m * Vec3::UnitZ();
    const Matrix moved = velocity(index, contact_B_m);
    const auto add = [&](int axis, double spring_npm) {
      if (std::isfinite(spring_npm)) {
        stiffness += spring_npm * moved.row(axis).transpose() * moved.row(axis);
      }
    };
    add(0, link.wheel->tangential_stiffness_npm);
    add(1, link.wheel->tangential_stiffness_npm);
    add(2, link.wheel->normal_stiffness_npm);
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> modes(
      stiffness, mass_.reconstructedMatrix(), Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, modes.eigenvalues().maxCoeff()));
}

}  // namespace lsos
