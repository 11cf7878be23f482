#include "mission/rover/body_shape.h"

#include <algorithm>
#include <limits>

#include "base/rotation_from_z.h"

namespace lsos {

namespace {

constexpr int wheel_sides = 16;
const Vec3 wheel_colour(0.35, 0.35, 0.37), strut_colour(0.55, 0.55, 0.56);
// Drawn thickness of struts, in radii of the smallest wheel.
constexpr double strut_radii = 0.22;

double smallest_wheel_m(const VehicleConfig& vehicle) {
  double radius_m = std::numeric_limits<double>::infinity();
  for (const LinkConfig& link : vehicle.links) {
    if (link.wheel) radius_m = std::min(radius_m, link.wheel->radius_m);
  }
  return radius_m;
}

Mesh mesh_of(const Shape& shape) {
  if (shape.kind == Shape::Kind::box) return box_mesh(shape.size_m);
  return cylinder_mesh(shape.size_m.x() / 2, shape.size_m.z());
}

}  // namespace

BodyShape::BodyShape(const std::vector<Shape>& shapes) {
  for (const Shape& shape : shapes) add(shape, 0);
}

BodyShape::BodyShape(const std::vector<Shape>& shapes, const VehicleConfig& vehicle) {
  for (const Shape& shape : shapes) {
    std::size_t part = 0;
    for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
      if (vehicle.links[i].name == shape.part) part = i + 1;
    }
    add(shape, part);
  }
  if (shapes.empty()) {
    Shape box;
    box.size_m = vehicle.chassis_size_m;
    box.p_B_m = {0, 0, vehicle.chassis_clearance_m + box.size_m.z() / 2};
    add(box, 0);
  }
  const std::vector<Vec3> centres_B_m = centres_at_rest_B_m(vehicle);
  for (std::size_t i = 0; i < vehicle.links.size(); ++i) {
    const LinkConfig& link = vehicle.links[i];
    if (!link.wheel) continue;
    add_piece(i + 1, cylinder_mesh(link.wheel->radius_m, link.wheel->width_m, wheel_sides),
              rotation_from_z(link.axis), centres_B_m[i + 1], wheel_colour);
  }
  add_struts(vehicle);
}

// Adds struts from the joint of each part to the joints of its children; for children of the
// chassis, across the chassis.
void BodyShape::add_struts(const VehicleConfig& vehicle) {
  const double thick_m = strut_radii * smallest_wheel_m(vehicle);
  const std::vector<Vec3> joints_B_m = joints_at_rest_B_m(vehicle);
  for (std::size_t i = 0; i < joints_B_m.size(); ++i) {
    const int parent = vehicle.links[i].parent;
    const Vec3& to_B_m = joints_B_m[i];
    const Vec3 from_B_m =
        parent < 0 ? Vec3(to_B_m.x(), 0, to_B_m.z()) : joints_B_m[static_cast<std::size_t>(parent)];
    const Vec3 strut_m = to_B_m - from_B_m;
    if (strut_m.norm() < thick_m) continue;
    add_piece(static_cast<std::size_t>(parent + 1), box_mesh({thick_m, thick_m, strut_m.norm()}),
              rotation_from_z(strut_m), (from_B_m + to_B_m) / 2, strut_colour);
  }
}

void BodyShape::add(const Shape& shape, std::size_t part) {
  add_piece(part, mesh_of(shape), shape.R_BL, shape.p_B_m, shape.colour);
}

void BodyShape::add_piece(std::size_t part, const Mesh& mesh, const Mat3& R, const Vec3& p_B_m,
                          const Vec3& colour) {
  pieces_.push_back({part, {}, colour});
  append(pieces_.back().mesh, mesh, R, p_B_m);
  for (const auto& vertex : mesh.vertices) {
    const Vec3 at_B_m = p_B_m + R * Vec3(vertex[0], vertex[1], vertex[2]);
    reach_m_ = std::max(reach_m_, at_B_m.norm());
    top_m_ = std::max(top_m_, at_B_m.z());
  }
}

double BodyShape::reach_m(const std::vector<PartPose>& poses) const {
  double reach_m = reach_m_;
  for (const Piece& piece : pieces_) {
    if (piece.part == 0) continue;  // does not move about the reference point
    const PartPose& pose = poses[piece.part];
    for (const auto& vertex : piece.mesh.vertices) {
      const Vec3 at_S_m = pose.point_S_m(Vec3(vertex[0], vertex[1], vertex[2]));
      reach_m = std::max(reach_m, (at_S_m - poses.front().p_S_m).norm());
    }
  }
  return reach_m;
}

void BodyShape::append_to(Mesh& mesh, const std::vector<PartPose>& poses,
                          const Vec3& eye_S_m) const {
  for (const Piece& piece : pieces_) {
    const PartPose& pose = poses[piece.part];
    append(mesh, piece.mesh, pose.R_SB, pose.p_S_m - eye_S_m);
  }
}

std::vector<BodyShape::Solid> BodyShape::solids(const std::vector<PartPose>& poses,
                                                const Vec3& eye_S_m) const {
  std::vector<Solid> solids;
  for (const Piece& piece : pieces_) {
    const PartPose& pose = poses[piece.part];
    solids.push_back({{}, piece.colour});
    append(solids.back().mesh, piece.mesh, pose.R_SB, pose.p_S_m - eye_S_m);
  }
  return solids;
}

}  // namespace lsos
