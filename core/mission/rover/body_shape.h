// Triangle meshes of rovers and assets in their present poses.
#pragma once

#include <string>
#include <vector>

#include "base/shape.h"
#include "vehicle/part_pose.h"
#include "view/gl/mesh.h"

namespace lsos {

// Shape of one rover or asset. Built once, posed as often as it moves.
class BodyShape {
 public:
  BodyShape() = default;
  // Shapes of a script, the wheels, and their struts as plain bars; without shapes the box of the
  // chassis.
  BodyShape(const std::vector<Shape>& shapes, const VehicleConfig& vehicle);
  // Shape of something without moving parts.
  explicit BodyShape(const std::vector<Shape>& shapes);

  // Appends the triangles relative to `eye_S_m`, in site axes. `poses`: the chassis, then each
  // link.
  void append_to(Mesh& mesh, const std::vector<PartPose>& poses, const Vec3& eye_S_m) const;
  // The same, each shape with its colour.
  struct Solid {
    Mesh mesh;
    Vec3 colour;
  };
  std::vector<Solid> solids(const std::vector<PartPose>& poses, const Vec3& eye_S_m) const;
  // Radius about the reference point that holds all shapes, at rest.
  double reach_m() const { return reach_m_; }
  // The same in poses as append_to() takes them.
  double reach_m(const std::vector<PartPose>& poses) const;
  double top_m() const { return top_m_; }  // above the reference point, at rest

 private:
  struct Piece {
    std::size_t part;  // index into the poses
    Mesh mesh;         // frame B at rest
    Vec3 colour;
  };
  void add(const Shape& shape, std::size_t part);
  void add_struts(const VehicleConfig& vehicle);
  void add_piece(std::size_t part, const Mesh& mesh, const Mat3& R, const Vec3& p_B_m,
                 const Vec3& colour);

  std::vector<Piece> pieces_;
  double reach_m_ = 0, top_m_ = 0;
};

}  // namespace lsos
