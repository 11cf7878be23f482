#include "vehicle/limb_stance.h"

#include <cmath>

#include "vehicle/part_pose.h"
#include "vehicle/posture_move.h"

namespace lsos {

namespace {

double radius_m(const VehicleConfig& vehicle, const LimbConfig& limb) {
  return vehicle.links[static_cast<std::size_t>(limb.wheel)].wheel->radius_m;
}

std::vector<double> initial_rad(const VehicleConfig& vehicle, const LimbConfig& limb) {
  std::vector<double> angles_rad;
  for (const int joint : limb.joints) {
    angles_rad.push_back(vehicle.links[static_cast<std::size_t>(joint)].initial);
  }
  return angles_rad;
}

}  // namespace

VehicleConfig as_it_stands(const VehicleConfig& vehicle) {
  if (vehicle.limbs.empty()) return vehicle;
  std::vector<double> positions(vehicle.links.size(), 0.0);
  for (const LimbConfig& limb : vehicle.limbs) {
    for (const int joint : limb.joints) {
      const auto link = static_cast<std::size_t>(joint);
      positions[link] = vehicle.links[link].initial;
    }
  }
  const std::vector<PartPose> poses = part_poses(vehicle, {}, positions);
  const Vec3 origin_B_m = reference_B_m(vehicle, positions);
  VehicleConfig standing = vehicle;
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    LinkConfig& link = standing.links[i];
    const Mat3& R_parent = poses[static_cast<std::size_t>(link.parent + 1)].R_SB;
    const Mat3& R = poses[i + 1].R_SB;
    link.axis = R_parent * link.axis;
    link.p_PJ_m = R_parent * link.p_PJ_m;
    link.p_JC_m = R * link.p_JC_m;
    link.inertia.moments_kgm2 =
        (R * link.inertia.moments_kgm2.asDiagonal() * R.transpose()).diagonal();
    if (link.parent < 0) link.p_PJ_m -= origin_B_m;
    if (!link.limb) continue;
    link.limb->angle_min_rad -= link.initial;
    link.limb->angle_max_rad -= link.initial;
    link.initial = 0;
  }
  standing.p_BC_m -= origin_B_m;
  standing.chassis_clearance_m -= origin_B_m.z();
  return standing;
}

std::vector<Vec3> hubs_B_m(const VehicleConfig& vehicle) {
  std::vector<Vec3> hubs;
  for (const LimbConfig& limb : vehicle.limbs) {
    hubs.push_back(LimbChain(vehicle, limb).pose(initial_rad(vehicle, limb)).hub_B_m);
  }
  return hubs;
}

std::vector<Vec3> at_height(const VehicleConfig& vehicle, std::vector<Vec3> hubs_B_m,
                            double height_m) {
  for (std::size_t i = 0; i < hubs_B_m.size(); ++i) {
    hubs_B_m[i].z() = radius_m(vehicle, vehicle.limbs[i]) + vehicle.chassis_clearance_m - height_m;
  }
  return hubs_B_m;
}

double height_m(const VehicleConfig& vehicle, const std::vector<Vec3>& hubs_B_m) {
  double sum_m = 0;
  for (std::size_t i = 0; i < hubs_B_m.size(); ++i) {
    sum_m += vehicle.chassis_clearance_m + radius_m(vehicle, vehicle.limbs[i]) - hubs_B_m[i].z();
  }
  return sum_m / static_cast<double>(hubs_B_m.size());
}

HeightRange height_range(const VehicleConfig& vehicle) {
  // A limb that cannot stand somewhere between may stand further on, but does not get there.
  constexpr double stride_m = 0.05, precision_m = 1e-3, far_m = 20;
  const std::vector<Vec3> at_rest = hubs_B_m(vehicle);
  const std::vector<LimbChain> chains = limb_chains(vehicle);
  std::vector<std::vector<double>> rest_rad;
  for (const LimbConfig& limb : vehicle.limbs) rest_rad.push_back(initial_rad(vehicle, limb));
  // Whether limbs reach a height; `angles_rad` then have its joints.
  const auto reaches = [&](double height_m, std::vector<std::vector<double>>& angles_rad) {
    const std::vector<Vec3> hubs = at_height(vehicle, at_rest, height_m);
    std::vector<std::vector<double>> there_rad;
    for (std::size_t i = 0; i < hubs.size(); ++i) {
      const LimbChain::Reach reach = chains[i].reach(hubs[i], angles_rad[i]);
      if (!reach.is_there) return false;
      there_rad.push_back(reach.angles_rad);
    }
    angles_rad = there_rad;
    return true;
  };
  const auto limit_m = [&](double good_m, double end_m) {
    std::vector<std::vector<double>> angles_rad = rest_rad;
    double step_m = std::copysign(stride_m, end_m - good_m);
    while (std::abs(step_m) > precision_m / 2) {
      const bool is_beyond = (good_m + step_m - end_m) * step_m > 0;
      if (!is_beyond && reaches(good_m + step_m, angles_rad)) {
        good_m += step_m;
      } else {
        step_m /= 2;
      }
    }
    return good_m;
  };
  const double now_m = height_m(vehicle, at_rest);
  return {limit_m(now_m, 0), limit_m(now_m, now_m + far_m)};
}

std::string stand(VehicleConfig& vehicle, const std::vector<Vec3>& hubs_B_m) {
  std::string hindrance;
  for (std::size_t i = 0; i < vehicle.limbs.size(); ++i) {
    const LimbConfig& limb = vehicle.limbs[i];
    const LimbChain chain(vehicle, limb);
    const LimbChain::Reach reach = chain.reach(hubs_B_m[i], initial_rad(vehicle, limb));
    for (std::size_t j = 0; j < limb.joints.size(); ++j) {
      vehicle.links[static_cast<std::size_t>(limb.joints[j])].initial = reach.angles_rad[j];
    }
    if (reach.is_there || !hindrance.empty()) continue;
    hindrance = reach_text(vehicle, limb, reach);
  }
  return hindrance;
}

}  // namespace lsos
