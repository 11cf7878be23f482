// Rovers and assets as triangles, where they are now.
#pragma once

#include <string>
#include <vector>

#include "base/shape.h"
#include "vehicle/part_pose.h"
#include "view/gl/mesh.h"

namespace lsos {

// What one rover or asset is drawn of. Made once; placed as often as it moves.
class BodyShape {
 public:
  BodyShape() = default;
  // Shapes of a script, the wheels, and what they hang on as plain bars; without shapes the
  // chassis' box.
  BodyShape(const std::vector<Shape>& shapes, const VehicleConfig& vehicle);
  // Of what has no parts that move.
  explicit BodyShape(const std::vector<Shape>& shapes);

  // About `eye_S_m`, in site axes. `poses`: the chassis, then each link.
  void append_to(Mesh& mesh, const std::vector<PartPose>& poses, const Vec3& eye_S_m) const;
  // The same, each shape with its colour.
  struct Solid {
    Mesh mesh;
    Vec3 colour;
  };
  std::vector<Solid> solids(const std::vector<PartPose>& poses, const Vec3& eye_S_m) const;
  // Everything lies so near to the reference point, whatever the joints do.
  double reach_m() const { return reach_m_; }
  double top_m() const { return top_m_; }  // above the reference point, at rest

 private:
  struct Piece {
    std::size_t part;  // of PartPose
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
