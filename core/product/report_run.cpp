#include "product/report_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/files.h"
#include "picture/jpeg.h"
#include "picture/picture_frame.h"
#include "product/estimate_text.h"
#include "product/report_map.h"
#include "product/report_moments.h"
#include "product/rover_days.h"

namespace lsos {

namespace {

constexpr int chase_px = 800, sun_px = 450, quality = 80;
// Smaller where a mission is longer than a day: most of a picture's time goes into the mesh of its
// ground, which has nodes by the pixel.
constexpr int chase_px_of_days = 640;

std::vector<ReportPicture> drawn_pictures(PictureRun& run, const LogReader& log,
                                          const ReportData& data,
                                          std::vector<std::string>& left_out) {
  const std::vector<ReportMoment> moments = report_moments(log, data, left_out);
  std::vector<SimTime> times;
  for (const ReportMoment& moment : moments) times.push_back(moment.time);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  read_moments(run, log, times);
  const int behind_px = from_seconds(data.end_s) > day_length ? chase_px_of_days : chase_px;
  const Gpu gpu;
  Lettering letters;
  std::vector<ReportPicture> drawn;
  for (const ReportMoment& moment : moments) {
    const auto k = static_cast<std::size_t>(std::ranges::find(times, moment.time) - times.begin());
    const auto add = [&](const std::string& from, int size_px, const std::string& view) {
      const RgbPicture picture =
          picture_of(run, k, {from, moment.rover_id, size_px}, gpu, letters).picture;
      drawn.push_back({moment.rover_id,
                       seconds(moment.time),
                       moment.title,
                       view,
                       {"image/jpeg",
                        jpeg_bytes(picture.width_px, picture.height_px, 3, picture.rgb, quality)}});
    };
    add("chase", behind_px, "from behind");
    if (moment.is_solar) add("sun", sun_px, "as the Sun sees it, panels green");
  }
  return drawn;
}

}  // namespace

std::map<std::string, ReportBattery> report_batteries(const MissionModel& files) {
  std::map<std::string, ReportBattery> found;
  for (const PlanRover& rover : files.plan.rovers) {
    const auto model = files.rover_models.find(rover.model());
    if (model == files.rover_models.end() || !model->second.power.battery) continue;
    const BatterySpec& battery = *model->second.power.battery;
    found[rover.id] = {battery.capacity_j, battery.reserve * battery.capacity_j};
  }
  return found;
}

std::string report_of(PictureRun run, const LogReader& log, const std::string& summary,
                      const ReportRequest& request, std::vector<std::string>& left_out) {
  const SiteFrame site = run.ground ? run.ground->site() : site_of(log, run.files.plan);
  const ReportData data = read_report_data(log, run.files.plan, site);
  ReportExtras extras;
  extras.batteries = report_batteries(run.files);
  extras.estimate = request.estimate;
  if (run.ground) {
    extras.map = report_map(*run.ground, data, request.shadow_at, request.threads);
    // Pictures may fail, as without a font or a GPU; the rest is still worth reading.
    try {
      if (request.has_pictures) extras.pictures = drawn_pictures(run, log, data, left_out);
    } catch (const std::exception& error) {
      left_out.push_back(fmt::format("pictures: {}", error.what()));
    }
  }
  left_out.insert(left_out.end(), data.left_out.begin(), data.left_out.end());
  extras.left_out = left_out;
  return report_html(data, run.files.plan, site, summary, extras);
}

void write_report(const std::string& run_dir, const MissionModel& files, const Ground& ground,
                  const RunSummary& summary, ReportRequest request) {
  request.estimate = read_file(run_dir + "/" + estimate_file).value_or("");
  const LogReader log(run_dir + "/log.gpkg");
  PictureRun run;
  run.files = files;
  run.ground = std::shared_ptr<const Ground>(std::shared_ptr<const Ground>(), &ground);
  run.start = log.start();
  run.end = log.last_sample_time();
  std::vector<std::string> left_out;  // the page lists it
  write_file(run_dir + "/report.html",
             report_of(std::move(run), log, to_json(summary), request, left_out));
}

}  // namespace lsos
