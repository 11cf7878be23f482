#include "picture/picture_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/rounding.h"
#include "base/units.h"
#include "picture/caption.h"
#include "picture/picture_scene.h"
#include "picture/picture_view.h"
#include "view/exposure/sun_column.h"
#include "view/ground/ground_patch.h"
#include "view/picture/ground_view.h"

namespace lsos {

namespace {

const Vec3 green(0, 1, 0), panel_dark(0.15, 0.18, 0.35), ground_grey(0.42, 0.42, 0.42);

constexpr double ribbon_share = 0.025;  // half width of a track, in reaches of its rover

// Extents of what is drawn in the view from the Sun, in reaches of the rover: the picture, the
// ground that may hide the Sun, and the patch of ground about the rover.
constexpr double frame_reaches = 0.9, neighbours_reaches = 12, patch_reaches = 8;

std::string view_text(const PictureView& view, const std::string& rover) {
  switch (view.kind) {
    case PictureView::Kind::sun:
      return "as the Sun sees it";
    case PictureView::Kind::chase:
      return "from behind";
    case PictureView::Kind::east:
      return "from the east";
    case PictureView::Kind::above:
      return "from above, north is up";
    case PictureView::Kind::rover:
      return view.rover == rover ? "what lies ahead" : "from " + view.rover;
  }
  return {};
}

// Rate of a film: three significant digits, without an exponent.
std::string rate_text(const FilmTime& film) {
  const int digits = static_cast<int>(std::floor(std::log10(film.rate))) - 2;
  const double unit = std::pow(10, digits);
  const double rate = std::round(film.rate / unit) * unit;
  return fmt::format("{}{} x real time", film.is_quiet ? "time-lapse: " : "",
                     digits < 0 ? fmt::format("{:g}", rate) : fmt::format("{:.0f}", rate));
}

// `metres_per_pixel`: scale at the rover; 0 where the rover is not seen.
Caption caption_of(const PictureMoment& moment, const PictureView& view, const DrawnBody& body,
                   double metres_per_pixel) {
  const SampleRow& sample = moment.rover->sample;
  const double elevation_deg = degrees(moment.sun.seen.elevation_rad);
  std::string utc = format_utc(moment.utc);
  utc = utc.substr(0, 10) + " " + utc.substr(11, 8) + " UTC";
  Caption caption;
  caption.title = fmt::format("{} ({})   {}", body.id, body.type, utc);
  if (moment.film) caption.title += "   " + rate_text(*moment.film);
  caption.lines = {
      fmt::format("lon {:.5f}\u00b0, lat {:.5f}\u00b0   {}   Sun {:.1f}\u00b0 {} the horizon at "
                  "azimuth {:.0f}\u00b0",
                  lon_deg(sample.place), lat_deg(sample.place), view_text(view, body.id),
                  std::abs(elevation_deg), elevation_deg < 0 ? "below" : "above",
                  degrees(moment.sun.seen.azimuth_rad))};
  caption.metres_per_pixel = metres_per_pixel;
  caption.scale_where = "at the rover";
  return caption;
}

PictureFrameOut as_the_sun_sees(const PictureRun& run, const PictureMoment& moment,
                                const PictureView& view, int size_px, const Gpu& gpu,
                                Lettering& letters) {
  const SiteFrame& site = run.ground->site();
  const Vec3 eye_S_m = moment.rover->sample.p_S_m, sun_S = moment.sun_S;
  std::vector<PictureSolid> solids;
  std::vector<PanelFace> panels;
  DrawnBody subject;
  for (const DrawnBody& body :
       drawn_bodies(run.files, *run.ground, *moment.rovers, eye_S_m, sun_S)) {
    solids.insert(solids.end(), body.solids.begin(), body.solids.end());
    if (body.id == moment.rover->sample.rover_id) {
      panels = body.panels;
      subject = body;
      continue;
    }
    for (const PanelFace& face : body.panels)
      solids.push_back({face_mesh(face), panel_dark, false});
  }
  const double reach_m = subject.reach_m;
  const Vec3 up_S = site.up_S(eye_S_m);
  const Vec3 across =
      up_S.cross(sun_S).norm() > 1e-6 ? up_S.cross(sun_S).normalized() : site.east_S(eye_S_m);
  PictureFrame frame;
  frame.towards = sun_S;
  frame.up = sun_S.cross(across);
  frame.centre_m = up_S * (reach_m / 3);
  frame.half_m = frame_reaches * reach_m;
  frame.size_px = size_px;
  // Add the ground that may hide the Sun, and the ground about the rover.
  const double wide_m = neighbours_reaches * reach_m;
  solids.push_back(
      {ground_mesh(*run.ground, sun_column(eye_S_m, wide_m, sun_S, 0)), ground_grey, false});
  solids.push_back(
      {ground_patch(*run.ground, eye_S_m, patch_reaches * reach_m, 160), ground_grey, false});
  for (const PanelFace& face : panels) {
    const bool is_towards = face.normal().dot(sun_S) > 0;
    solids.push_back({face_mesh(face), is_towards ? green : panel_dark, is_towards});
  }
  const Picture picture = draw(gpu, solids, frame);
  const std::vector<PictureSolid> alone(solids.end() - static_cast<std::ptrdiff_t>(panels.size()),
                                        solids.end());
  const int seen = green_pixels(picture), most = green_pixels(draw(gpu, alone, frame));
  PictureFrameOut out{
      {size_px, size_px, picture.rgb},
      {{"green_pixels", seen},
       {"green_pixels_alone", most},
       {"seen_share", most > 0 ? nlohmann::ordered_json(computed(static_cast<double>(seen) / most))
                               : nlohmann::ordered_json(nullptr)}}};
  add_caption({size_px, size_px, &out.picture.rgb},
              caption_of(moment, view, subject, 2 * frame.half_m / size_px), letters);
  return out;
}

PictureFrameOut as_a_camera_sees(const PictureRun& run, const PictureMoment& moment,
                                 const PictureView& view, SimTime until, const PictureSize& size,
                                 const Gpu& gpu, Lettering& letters) {
  const Ground& ground = *run.ground;
  const Vec3& near_S_m = moment.rover->sample.p_S_m;
  const auto bodies_about = [&](const Vec3& eye_S_m) {
    return drawn_bodies(run.files, ground, *moment.rovers, eye_S_m, moment.sun_S);
  };
  const Camera camera =
      camera_of(view, ground, *moment.rover, bodies_about(near_S_m), size.width_px, size.height_px);
  const Vec3& eye_S_m = camera.eye_S_m;
  std::vector<DrawnBody> bodies = bodies_about(eye_S_m);
  const DrawnBody subject =
      *std::ranges::find(bodies, moment.rover->sample.rover_id, &DrawnBody::id);
  // Sorted by distance: if there are too many bodies, only the nearest cast shadows.
  std::ranges::stable_sort(bodies, {},
                           [&](const DrawnBody& body) { return (body.p_S_m - eye_S_m).norm(); });
  const TerrainShadow shadow(ground, eye_S_m, moment.sun_S, moment.sun.disc_rad,
                             sector_of(ground.site(), camera));
  Scene scene;
  scene.sun_S = moment.sun_S;
  scene.up_S = ground.site().up_S(eye_S_m);
  scene.disc_rad = moment.sun.disc_rad;
  scene.air = air_of(ground.site().body().name, moment.sun.seen.elevation_rad);
  scene.ground = ground_view(ground, camera, shadow, scene.air.ground);
  for (const DrawnBody& body : bodies) scene.bodies.push_back(scene_body(body, eye_S_m, shadow));
  std::size_t place = 0;
  for (const auto& [id, track] : run.logged.tracks) {
    const Vec3 colour = rover_colour(place++);
    const auto body = std::ranges::find(bodies, id, &DrawnBody::id);
    if (body == bodies.end()) continue;
    const SceneMesh ribbon = track_ribbon(ground, track, {until, body->p_S_m}, camera,
                                          {colour, ribbon_share * body->reach_m});
    const auto first = static_cast<std::uint32_t>(scene.marks.vertices.size());
    scene.marks.vertices.insert(scene.marks.vertices.end(), ribbon.vertices.begin(),
                                ribbon.vertices.end());
    for (const auto& t : ribbon.triangles) {
      scene.marks.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
  }
  const double distance_m = (subject.p_S_m - eye_S_m).dot(camera.ahead_S);
  const bool is_seen = distance_m > subject.top_m / 2 && view.rover != subject.id;
  const double scale = is_seen ? camera.metres_per_pixel(distance_m) : 0;
  PictureFrameOut out{draw(gpu, scene, camera), {}};
  add_caption({size.width_px, size.height_px, &out.picture.rgb},
              caption_of(moment, view, subject, scale), letters);
  return out;
}

}  // namespace

PictureSize picture_size(const PictureRun& run, const PictureRequest& request) {
  const bool is_sun = view_of(request.from, run.rovers).kind == PictureView::Kind::sun;
  const int width_px = request.size_px > 0 ? request.size_px : is_sun ? 800 : 1280;
  // Even, as films require.
  return {width_px, is_sun ? width_px : std::max(2, width_px * 9 / 32 * 2)};
}

PictureFrameOut picture_of(const PictureRun& run, std::size_t k, const PictureRequest& request,
                           const Gpu& gpu, Lettering& letters) {
  const PictureView view = view_of(request.from, run.rovers);
  const PictureMoment then = moment(run, k, request.rover);
  const PictureSize size = picture_size(run, request);
  PictureFrameOut out = view.kind == PictureView::Kind::sun
                            ? as_the_sun_sees(run, then, view, size.width_px, gpu, letters)
                            : as_a_camera_sees(run, then, view, run.times[k], size, gpu, letters);
  nlohmann::ordered_json about{
      {"rover_id", then.rover->sample.rover_id},
      {"utc", format_utc(then.utc)},
      {"from", request.from},
      {"width_px", out.picture.width_px},
      {"height_px", out.picture.height_px},
      {"sun_azimuth_deg", computed(degrees(then.sun.seen.azimuth_rad))},
      {"sun_elevation_deg", computed(degrees(then.sun.seen.elevation_rad))}};
  if (out.about.is_object()) about.update(out.about);
  out.about = about;
  return out;
}

}  // namespace lsos
