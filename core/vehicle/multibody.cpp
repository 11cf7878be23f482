#include "vehicle/multibody.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <cmath>

namespace lsos {

namespace {

btVector3 bt(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 eigen(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
// Inverse of Bullet's rotation, which goes from the parent or the world to the link.
Mat3 inverse_rotation(const btQuaternion& q) {
  return Quat(q.w(), -q.x(), -q.y(), -q.z()).toRotationMatrix();
}
// Written out, because Eigen calls a loop for it.
Mat3 product(const Mat3& a, const Mat3& b) {
  Mat3 c;
  for (int i = 0; i < 3; ++i) {
    c.col(i) = a.col(0) * b(0, i) + a.col(1) * b(1, i) + a.col(2) * b(2, i);
  }
  return c;
}

}  // namespace

struct Multibody::Impl {
  Impl(const VehicleConfig& config)
      : body(static_cast<int>(config.links.size()), config.chassis.mass_kg,
             bt(config.chassis.moments_kgm2), /*fixedBase=*/false, /*canSleep=*/false),
        p_BC_m(config.p_BC_m) {}

  btMultiBody body;
  Vec3 p_BC_m;
  // Work space of the algorithm; its content does not outlive a step.
  btAlignedObjectArray<btScalar> scratch_r;
  btAlignedObjectArray<btVector3> scratch_v;
  btAlignedObjectArray<btMatrix3x3> scratch_m;
};

Multibody::Multibody(const VehicleConfig& config) : impl_(std::make_unique<Impl>(config)) {
  btMultiBody& body = impl_->body;
  const btQuaternion unturned(0, 0, 0, 1);
  for (std::size_t i = 0; i < config.links.size(); ++i) {
    const LinkConfig& link = config.links[i];
    // Bullet measures from the parent's centre of mass, LinkConfig from the parent's frame.
    const Vec3 p_parent_com = link.parent < 0
                                  ? config.p_BC_m
                                  : config.links[static_cast<std::size_t>(link.parent)].p_JC_m;
    const btVector3 com_to_joint = bt(link.p_PJ_m - p_parent_com), joint_to_com = bt(link.p_JC_m);
    const btVector3 moments = bt(link.inertia.moments_kgm2), axis = bt(link.axis);
    const int index = static_cast<int>(i);
    if (link.joint == JointType::revolute) {
      body.setupRevolute(index, link.inertia.mass_kg, moments, link.parent, unturned, axis,
                         com_to_joint, joint_to_com, /*disableParentCollision=*/true);
    } else {
      body.setupPrismatic(index, link.inertia.mass_kg, moments, link.parent, unturned, axis,
                          com_to_joint, joint_to_com, /*disableParentCollision=*/true);
    }
    parents_.push_back(link.parent);
    initial_.push_back(link.initial);
  }
  body.finalizeMultiDof();
  // Bullet's defaults take energy away (4 % a second) and clamp speeds; neither is physics.
  body.setLinearDamping(0);
  body.setAngularDamping(0);
  body.setMaxCoordinateVelocity(1e9);
  body.setUseGyroTerm(true);
  motions_.resize(config.links.size() + 1);
  place(Vec3::Zero(), Mat3::Identity());
}

Multibody::~Multibody() = default;

void Multibody::place(const Vec3& p_SB_m, const Mat3& R_SB, const std::vector<double>& joints) {
  btMultiBody& body = impl_->body;
  const Quat q_BS = Quat(R_SB).normalized().conjugate();
  body.setWorldToBaseRot(btQuaternion(q_BS.x(), q_BS.y(), q_BS.z(), q_BS.w()));
  body.setBasePos(bt(p_SB_m + R_SB * impl_->p_BC_m));
  for (int i = 0; i < body.getNumLinks(); ++i)
    body.setJointPos(i, joints[static_cast<std::size_t>(i)]);
  halt();
}

double Multibody::joint_position(int link) const { return impl_->body.getJointPos(link); }
double Multibody::joint_velocity(int link) const { return impl_->body.getJointVel(link); }

void Multibody::add_force(int link, const Vec3& force_S_n, const Vec3& point_S_m) {
  add_wrench(link, force_S_n, (point_S_m - motion(link).p_C_S_m).cross(force_S_n));
}

void Multibody::add_wrench(int link, const Vec3& force_S_n, const Vec3& torque_S_n_m) {
  btMultiBody& body = impl_->body;
  if (link == chassis) {
    body.addBaseForce(bt(force_S_n));
    body.addBaseTorque(bt(torque_S_n_m));
  } else {
    body.addLinkForce(link, bt(force_S_n));
    body.addLinkTorque(link, bt(torque_S_n_m));
  }
}

void Multibody::add_gravity(const Vec3& g_S_mps2) {
  btMultiBody& body = impl_->body;
  body.addBaseForce(bt(g_S_mps2 * body.getBaseMass()));
  for (int i = 0; i < body.getNumLinks(); ++i) {
    body.addLinkForce(i, bt(g_S_mps2 * body.getLinkMass(i)));
  }
}

void Multibody::add_joint_force(int link, double force) { impl_->body.addJointTorque(link, force); }

void Multibody::step(double step_s) {
  btMultiBody& body = impl_->body;
  // This also integrates the velocities (its last lines add acceleration x step).
  body.computeAccelerationsArticulatedBodyAlgorithmMultiDof(
      step_s, impl_->scratch_r, impl_->scratch_v, impl_->scratch_m, /*isConstraintPass=*/false,
      /*jointFeedbackInWorldSpace=*/false, /*jointFeedbackInJointFrame=*/false);
  body.stepPositionsMultiDof(step_s);
  body.clearForcesAndTorques();
  update_motions();
}

std::optional<int> Multibody::non_finite_link() const {
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const LinkMotion& m = motions_[i];
    // A sum is finite only if each part is.
    if (!std::isfinite(m.p_C_S_m.sum() + m.v_C_S_mps.sum() + m.omega_S_radps.sum())) {
      return static_cast<int>(i) - 1;
    }
  }
  return {};
}

double Multibody::kinetic_j() const {
  const btMultiBody& body = impl_->body;
  double energy_j = 0;
  for (int i = chassis; i < body.getNumLinks(); ++i) {
    const LinkMotion& m = motion(i);
    const double mass_kg = i == chassis ? body.getBaseMass() : body.getLinkMass(i);
    const Vec3 inertia = eigen(i == chassis ? body.getBaseInertia() : body.getLinkInertia(i));
    const Vec3 omega_L = m.R_SL.transpose() * m.omega_S_radps;
    energy_j +=
        mass_kg * m.v_C_S_mps.squaredNorm() / 2 + omega_L.cwiseProduct(inertia).dot(omega_L) / 2;
  }
  return energy_j;
}

double Multibody::potential_j(const Vec3& g_S_mps2) const {
  const btMultiBody& body = impl_->body;
  double energy_j = 0;
  for (int i = chassis; i < body.getNumLinks(); ++i) {
    const double mass_kg = i == chassis ? body.getBaseMass() : body.getLinkMass(i);
    energy_j -= mass_kg * g_S_mps2.dot(motion(i).p_C_S_m);
  }
  return energy_j;
}

void Multibody::halt() {
  btMultiBody& body = impl_->body;
  body.setBaseVel(btVector3(0, 0, 0));
  body.setBaseOmega(btVector3(0, 0, 0));
  for (int i = 0; i < body.getNumLinks(); ++i) body.setJointVel(i, 0);
  update_motions();
}

void Multibody::update_motions() {
  const btMultiBody& body = impl_->body;
  LinkMotion& base = motions_[0];
  base.p_C_S_m = eigen(body.getBasePos());
  base.R_SL = inverse_rotation(body.getWorldToBaseRot());
  base.v_C_S_mps = eigen(body.getBaseVel());
  base.omega_S_radps = eigen(body.getBaseOmega());
  for (int i = 0; i < body.getNumLinks(); ++i) {
    const btMultibodyLink& link = body.getLink(i);
    const LinkMotion& parent = motion(parents_[static_cast<std::size_t>(i)]);
    LinkMotion& motion = motions_[static_cast<std::size_t>(i + 1)];
    motion.R_SL = product(parent.R_SL, inverse_rotation(link.m_cachedRotParentToThis));
    const Vec3 from_parent_S_m = motion.R_SL * eigen(link.m_cachedRVector);
    motion.p_C_S_m = parent.p_C_S_m + from_parent_S_m;
    // Axes of the joint in the link's frame: angular, and linear at its centre of mass (see
    // btMultiBodyLink.h).
    const double rate = body.getJointVel(i);
    motion.omega_S_radps = parent.omega_S_radps + motion.R_SL * (eigen(link.getAxisTop(0)) * rate);
    motion.v_C_S_mps = parent.v_C_S_mps + parent.omega_S_radps.cross(from_parent_S_m) +
                       motion.R_SL * (eigen(link.getAxisBottom(0)) * rate);
  }
}

void Multibody::archive(Archive& a) {
  btMultiBody& body = impl_->body;
  a.tag("multibody");
  Vec3 position = eigen(body.getBasePos());
  Vec3 velocity = eigen(body.getBaseVel()), omega = eigen(body.getBaseOmega());
  const btQuaternion& q = body.getWorldToBaseRot();
  Quat rotation(q.w(), q.x(), q.y(), q.z());
  LSOS_ARCHIVE(a, position, rotation, velocity, omega);
  if (a.is_reading()) {
    body.setBasePos(bt(position));
    body.setWorldToBaseRot(btQuaternion(rotation.x(), rotation.y(), rotation.z(), rotation.w()));
    body.setBaseVel(bt(velocity));
    body.setBaseOmega(bt(omega));
  }
  for (int i = 0; i < body.getNumLinks(); ++i) {
    double joint = body.getJointPos(i), rate = body.getJointVel(i);
    LSOS_ARCHIVE(a, joint, rate);
    if (a.is_reading()) {
      body.setJointPos(i, joint);
      body.setJointVel(i, rate);
    }
  }
  if (a.is_reading()) update_motions();
}

bool Multibody::is_placed() const {
  constexpr double far_m = 1e8, rounding = 1e-6;
  const btMultiBody& body = impl_->body;
  double sum = body.getBaseVel().length() + body.getBaseOmega().length();
  for (int i = 0; i < body.getNumLinks(); ++i) sum += body.getJointPos(i) + body.getJointVel(i);
  return std::isfinite(sum) && body.getBasePos().length() < far_m &&
         std::abs(body.getWorldToBaseRot().length() - 1) < rounding;
}

}  // namespace lsos
