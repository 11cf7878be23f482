#include "lua/host/run_from.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/units.h"
#include "lua/host/run_mission.h"
#include "mission/model/site.h"
#include "planet/place_text.h"
#include "product/run_end.h"

namespace lsos {

namespace {

using RunValues = std::map<std::string, std::string>;

constexpr double place_off_m = 50;  // as for stationary events with a Point
constexpr double heading_off_rad = 0.02;
constexpr double same_height_m = 1e-3, same_site_m = 1e-3;
constexpr SimTime gap_least{1'000'000};

std::string run_value(const RunValues& run, const std::string& key) {
  const auto found = run.find(key);
  return found == run.end() ? "" : found->second;
}

std::string geodetic_text(const Geodetic& place) {
  return fmt::format("{:.6f},{:.6f}", lon_deg(place), lat_deg(place));
}

// Compares a mission with the run that it is to begin from.
class EndComparison {
 public:
  EndComparison(std::string folder, const RunEnd& end, const RunValues& run, const Plan& then,
                MissionFiles& files)
      : folder_(std::move(folder)), end_(end), run_(run), then_(then), files_(files) {}

  void compare() {
    compare_time();
    compare_ground();
    compare_site();
    for (const PlanRover& rover : files_.plan.rovers) {
      const auto found = end_.rovers.find(rover.id);
      if (found == end_.rovers.end()) {
        warn(rover.place, fmt::format("Rover '{}': it is not in {}, and begins as the plan says",
                                      rover.id, folder_));
      } else {
        compare_rover(rover, found->second);
      }
    }
    const bool is_any_known = std::ranges::any_of(
        files_.plan.rovers, [&](const PlanRover& rover) { return end_.rovers.contains(rover.id); });
    if (!is_any_known) {
      std::string ids;
      for (const auto& [id, rover] : end_.rovers) ids += (ids.empty() ? "" : ", ") + id;
      refuse(
          mission().place,
          fmt::format("no rover of this plan is in {}, so nothing of it is taken over; it has {}",
                      folder_, ids));
      return;
    }
    for (const auto& known : end_.rovers) {
      const auto same = [&](const PlanRover& planned) { return planned.id == known.first; };
      if (std::ranges::any_of(files_.plan.rovers, same)) continue;
      warn(mission().place, fmt::format("rover '{}' of {} is not in this plan: it is left out",
                                        known.first, folder_));
    }
  }

 private:
  const MissionInfo& mission() const { return files_.plan.mission; }
  void warn(const Place& place, const std::string& what) { files_.faults.warning(place, what); }
  void refuse(const Place& place, const std::string& what) { files_.faults.error(place, what); }

  void compare_time() {
    const SimTime gap = mission().start_time - end_.time;
    const std::string times =
        fmt::format("StartTime = {}: {} ended at {}", format_utc(mission().start_time), folder_,
                    format_utc(end_.time));
    if (gap < SimTime{}) {
      refuse(mission().place, times + "; the plan must not begin before that");
    } else if (gap > gap_least) {
      warn(mission().place,
           fmt::format("{}; of the {:.6g} s between nothing is simulated, and charge and all else "
                       "are taken as they were",
                       times, seconds(gap)));
    }
  }

  void compare_ground() {
    const std::string planet = run_value(run_, "planet"), terrain = run_value(run_, "terrain");
    if (planet != mission().planet->name) {
      refuse(mission().place, fmt::format("Planet = {}: {} was on {}; take its Planet",
                                          mission().planet->name, folder_, planet));
      return;
    }
    if (terrain != files_.terrain.name) {
      refuse(mission().place, fmt::format("Terrain = {}: {} was on {}; take its Terrain",
                                          files_.terrain.name, folder_, terrain));
      return;
    }
    const auto ground =
        ground_at(files_.terrain, *mission().planet, site_of(then_), mission().seed);
    if (ground->hash() == run_value(run_, "terrain_sha256")) return;
    const std::string seed = run_value(run_, "seed");
    if (is_soil_alone(*ground)) {
      warn(mission().place,
           fmt::format("{}: its soil is not what it was in {}", files_.terrain.name, folder_));
    } else if (seed != std::to_string(mission().seed)) {
      refuse(mission().place,
             fmt::format("Seed = {}: {} had Seed = {}, and other ground; take that", mission().seed,
                         folder_, seed));
    } else {
      refuse(files_.terrain.place,
             fmt::format("terrain {} is not what it was when {} was run: restore its script and "
                         "rasters, or run {} again",
                         terrain, folder_, folder_));
    }
  }

  // Whether the soil differs and, as far as can be seen where rovers stand, nothing else.
  bool is_soil_alone(const Ground& ground) const {
    bool is_other_soil = run_value(run_, "soil") != files_.terrain.soil.name;
    for (const Script& script : files_.catalog->scripts()) {
      const bool is_soil = script.kind == ScriptKind::soil;
      if (!is_soil && script.kind != ScriptKind::terrain) continue;
      const std::string then =
          run_value(run_, fmt::format("{}_{}_sha256", is_soil ? "soil" : "terrain", script.name));
      if (then.empty() || then == script.sha256) continue;
      if (!is_soil) return false;
      is_other_soil = true;
    }
    return is_other_soil && std::ranges::all_of(end_.rovers, [&](const auto& entry) {
             const SampleRow& sample = entry.second.sample;
             const auto elevation_m = ground.elevation_m(sample.place);
             return elevation_m && std::abs(*elevation_m - sample.elevation_m) < same_height_m;
           });
  }

  void compare_rover(const PlanRover& rover, const RoverEnd& end) {
    const std::string subject = fmt::format("Rover '{}': ", rover.id);
    const PlanRover* then = rover_of(then_, rover.id);
    if (then == nullptr) {
      refuse(rover.place, fmt::format("{}the plan in {} does not tell its RoverType any more",
                                      subject, folder_));
      return;
    }
    bool is_same = true;
    const auto compare = [&](const char* field, const std::string& now, const std::string& was) {
      if (now == was) return;
      is_same = false;
      const auto shown = [](const std::string& text) { return text.empty() ? "none" : text; };
      refuse(rover.place, fmt::format("{}{} = {}: in {} it was {}; take that, or give the rover "
                                      "another RoverId",
                                      subject, field, shown(now), folder_, shown(was)));
    };
    compare("RoverType", rover.type, then->type);
    if (rover.type == then->type) {
      compare("RoverConfig", rover.configuration, then->configuration);
      compare("Variant", rover.variant, then->variant);
      compare_scripts(rover.type);
    }
    if (!end.hindrance.empty()) {
      refuse(rover.place, fmt::format("{}{} in {}: it cannot go on from there", subject,
                                      end.hindrance, folder_));
    } else if (is_same) {
      warn_of(rover, end, subject);
    }
  }

  // Errors for the scripts that make this type and have changed, each of them once.
  void compare_scripts(const std::string& type) {
    std::set<std::string> rovers = files_.catalog->bases_of(type);
    rovers.insert(type);
    std::set<std::string> shared;
    for (const std::string& name : rovers) {
      shared.merge(files_.catalog->required_by(ScriptKind::rover, name));
    }
    for (const Script& script : files_.catalog->scripts()) {
      const bool is_rover = script.kind == ScriptKind::rover && rovers.contains(script.name);
      const bool is_shared = script.kind == ScriptKind::shared && shared.contains(script.name);
      if (!is_rover && !is_shared) continue;
      const std::string key = fmt::format("{}_{}_sha256", is_rover ? "rover" : "lib", script.name);
      if (run_value(run_, key) == script.sha256 || !refused_.insert(script.file).second) continue;
      refuse({script.file, 0}, fmt::format("it is not what it was when {} was run: restore it, or "
                                           "run {} again",
                                           folder_, folder_));
    }
  }

  void warn_of(const PlanRover& rover, const RoverEnd& end, const std::string& subject) {
    const double away_m = surface_distance_m(*mission().planet, rover.start, *end.start.place);
    if (away_m > place_off_m) {
      warn(rover.place, fmt::format("{}its Placemark at {} is {:.0f} m from {}, where {} left it "
                                    "and it begins",
                                    subject, geodetic_text(rover.start), away_m,
                                    geodetic_text(*end.start.place), folder_));
    }
    if (rover.heading_rad && std::abs(std::remainder(*rover.heading_rad - *end.start.heading_rad,
                                                     2 * std::numbers::pi)) > heading_off_rad) {
      warn(rover.place,
           fmt::format("{}Heading = {:.6g} is not used: it begins with {:.1f} deg", subject,
                       degrees(*rover.heading_rad), degrees(*end.start.heading_rad)));
    }
    if (rover.initial_charge != 1 && !std::isnan(end.sample.charge)) {
      warn(rover.place, fmt::format("{}InitialCharge = {:.6g} is not used: it begins with {:.4f}",
                                    subject, rover.initial_charge, end.sample.charge));
    }
    for (const std::string& doubt : end.doubts) warn(rover.place, subject + doubt);
  }

  void compare_site() {
    const Geodetic& begun = site_of(then_);
    if (!mission().site ||
        surface_distance_m(*mission().planet, *mission().site, begun) < same_site_m) {
      return;
    }
    warn(mission().place,
         fmt::format("MissionInfo: SiteOrigin = {} is not used: it is {}, as in {}",
                     lon_lat_text(*mission().site), lon_lat_text(begun), folder_));
  }

  std::string folder_;
  const RunEnd& end_;
  const RunValues& run_;
  const Plan& then_;
  MissionFiles& files_;
  std::set<std::string> refused_;  // files of scripts
};

}  // namespace

void begin_from(const std::string& folder, MissionFiles& files) {
  const LogReader log(folder + "/log.gpkg");
  if (!log.has_samples()) {
    throw InputError({folder},
                     "its log has no sample: the run was stopped before its first, and "
                     "no other can begin with its end");
  }
  const RunValues run = log.run();
  // Faults of that plan do not matter, as long as it tells of its rovers.
  const Plan then = mission_of_run(folder, run).plan;
  if (then.rovers.empty()) {
    throw InputError({folder}, "the plan in it cannot be read any more");
  }
  std::error_code unreadable;
  if (!std::filesystem::exists(folder + "/summary.json", unreadable)) {
    files.faults.warning({folder}, "the run in it did not finish: the last rows of its log count");
  }
  const RunEnd end = read_run_end(log);
  EndComparison(folder, end, run, then, files).compare();
  files.from = MissionStart{folder, log.sha256(), end.time, site_of(then), {}};
  files.plan.mission.earlier_site = files.from->site;
  for (const PlanRover& rover : files.plan.rovers) {
    const auto found = end.rovers.find(rover.id);
    if (found != end.rovers.end()) files.from->rovers[rover.id] = found->second.start;
  }
}

void check_not_from(const std::string& folder, const std::string& from) {
  std::error_code ignored;
  if (from.empty() || !std::filesystem::equivalent(folder, from, ignored)) return;
  throw InputError({folder},
                   "holds the run with whose end this one begins, and would be replaced: -o "
                   "names another folder");
}

}  // namespace lsos
