#include "picture/picture_view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/units.h"
#include "view/picture/ground_view.h"

namespace lsos {

namespace {

constexpr std::array names{"sun", "chase", "east", "above"};

constexpr double width_rad = radians(52);  // width of the picture
// View from a rover: the other rover fills this share of the picture's width, and the width is
// limited to this range.
constexpr double other_share = 0.2, narrowest_rad = radians(4), widest_rad = radians(60);
constexpr double over_top_m = 0.25;  // height of the camera over its rover
constexpr double ahead_m = 12;       // distance that a rover's camera faces ahead

const DrawnBody& body_of(const std::vector<DrawnBody>& bodies, const std::string& id) {
  const auto found = std::ranges::find(bodies, id, &DrawnBody::id);
  LSOS_ASSERT(found != bodies.end());
  return *found;
}

}  // namespace

PictureView view_of(const std::string& from, const std::vector<std::string>& rovers) {
  const auto named = std::ranges::find(names, from);
  if (named != names.end()) return {static_cast<PictureView::Kind>(named - names.begin()), {}};
  if (std::ranges::count(rovers, from) > 0) return {PictureView::Kind::rover, from};
  std::vector<std::string> known(names.begin(), names.end());
  known.insert(known.end(), rovers.begin(), rovers.end());
  throw InputError(
      {}, fmt::format("--from {}: no such view; there are {}, and from the rovers {}{}", from,
                      fmt::join(names, ", "), fmt::join(rovers, ", "), did_you_mean(from, known)));
}

Camera camera_of(const PictureView& view, const Ground& ground, const LoggedRover& subject,
                 const std::vector<DrawnBody>& bodies, int width_px, int height_px) {
  const SiteFrame& site = ground.site();
  const SampleRow& sample = subject.sample;
  const DrawnBody& body = body_of(bodies, sample.rover_id);
  const Vec3& p_S_m = body.p_S_m;
  const Vec3 up_S = site.up_S(p_S_m), north_S = site.north_S(p_S_m), east_S = site.east_S(p_S_m);
  const Vec3 heading_S =
      std::cos(sample.heading_rad) * north_S + std::sin(sample.heading_rad) * east_S;
  const double reach_m = body.reach_m;
  Camera camera;
  double wide_rad = width_rad;
  const auto look_clear = [&](const Vec3& eye_S_m, const Vec3& target_S_m) {
    const Vec3 clear_S_m = clear_eye_S_m(ground, eye_S_m, target_S_m, 0.25 * reach_m);
    camera = camera_towards(clear_S_m, target_S_m, up_S);
  };
  switch (view.kind) {
    case PictureView::Kind::sun:
    case PictureView::Kind::chase: {
      const Vec3 right_S = heading_S.cross(up_S);
      look_clear(
          p_S_m - 3.2 * reach_m * heading_S + 1.3 * reach_m * right_S + 1.35 * reach_m * up_S,
          p_S_m + 0.8 * reach_m * heading_S + 0.48 * reach_m * up_S);
      break;
    }
    case PictureView::Kind::east:
      look_clear(p_S_m + 3.2 * reach_m * east_S + 0.5 * reach_m * up_S,
                 p_S_m + 0.45 * reach_m * up_S);
      break;
    case PictureView::Kind::above:
      camera = camera_towards(p_S_m + 11 * reach_m * up_S, p_S_m, north_S);
      break;
    case PictureView::Kind::rover: {
      const DrawnBody& from = body_of(bodies, view.rover);
      const Vec3 eye_S_m = from.p_S_m + (from.top_m + over_top_m) * site.up_S(from.p_S_m);
      if (view.rover == sample.rover_id) {
        camera = camera_towards(eye_S_m, p_S_m + std::max(ahead_m, 3 * reach_m) * heading_S, up_S);
        break;
      }
      const Vec3 target_S_m = p_S_m + 0.3 * reach_m * up_S;
      camera = camera_towards(eye_S_m, target_S_m, site.up_S(eye_S_m));
      const double distance_m = (target_S_m - eye_S_m).norm();
      wide_rad = std::clamp(2 * reach_m / distance_m / other_share, narrowest_rad, widest_rad);
      break;
    }
  }
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.focal_px = focal_of(width_px, wide_rad);
  return camera;
}

}  // namespace lsos
