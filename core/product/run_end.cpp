#include "product/run_end.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace lsos {

namespace {

using PlainJson = nlohmann::json;

const std::string mast_prefix = "antenna ";

// The findings after which a rover no longer stands on its wheels on known ground.
const std::map<std::string, std::string> hindrances = {
    {"rollover", "it had rolled over"},
    {"left_terrain", "it had left the terrain that is known"},
    {"broken_dynamics", "its dynamics had failed"},
};

// "" where it is null.
std::string field_text(const PlainJson& fields, const char* name) {
  const auto found = fields.find(name);
  return found != fields.end() && found->is_string() ? found->get<std::string>() : "";
}

// The breakage that a note "fault" tells of; see breakage_json().
std::optional<Breakage> breakage_of(const NoteRow& note) {
  const PlainJson fields = PlainJson::parse(note.fields_json, nullptr, false);
  if (!fields.is_object()) return {};
  // Notes of event scripts may have that name too, with other fields.
  for (const char* name : {"mode", "part", "repair", "share", "what"}) {
    if (!fields.contains(name)) return {};
  }
  Breakage breakage;
  breakage.what = field_text(fields, "what");
  breakage.part = field_text(fields, "part");
  breakage.mode = field_text(fields, "mode");
  if (const auto share = fields.find("share"); share != fields.end() && share->is_number()) {
    breakage.share = share->get<double>();
  }
  const auto repair = fields.find("repair");
  breakage.is_repair = repair != fields.end() && repair->is_boolean() && repair->get<bool>();
  return breakage;
}

// The share of sunlight that a note "shaded" tells of; 1 where it is another note of that name.
double shade_of(const NoteRow& note) {
  const PlainJson fields = PlainJson::parse(note.fields_json, nullptr, false);
  if (!fields.is_object()) return 1;
  const auto share = fields.find("share");
  return share != fields.end() && share->is_number() ? share->get<double>() : 1;
}

void add_note(RoverEnd& rover, const NoteRow& note) {
  if (const auto found = hindrances.find(note.name); found != hindrances.end()) {
    rover.hindrance = found->second;
  }
  if (note.name == "shaded") rover.shade = shade_of(note);
  if (note.name != "fault") return;
  const std::optional<Breakage> breakage = breakage_of(note);
  if (breakage && !breakage->what.empty()) rover.start.breakages.push_back(*breakage);
}

void add_joint(RoverEnd& rover, const JointRow& row) {
  if (row.joint.starts_with(mast_prefix)) {
    rover.start.masts_m[row.joint.substr(mast_prefix.size())] = row.extension_m;
  } else {
    rover.start.joints[row.joint] = std::isnan(row.angle_rad) ? row.extension_m : row.angle_rad;
  }
}

void add_panel(RoverEnd& rover, const PanelRow& row) {
  RoverStart::Panel& panel = rover.start.panels[row.panel];
  if (std::isnan(row.elevation_rad)) return;
  panel.face = PanelAngles{row.azimuth_rad, row.elevation_rad};
}

void add_order(RoverEnd& rover, const OrderRow& row) {
  if (row.part == OrderRow::limb) {
    if (!rover.start.stance) rover.start.stance = RoverStart::Stance{};
    rover.start.stance->hubs_B_m[row.name] = {row.x_m, row.y_m, row.z_m};
    rover.start.stance->is_level = row.order == OrderRow::level;
  }
  if (row.part != OrderRow::panel) return;
  RoverStart::Panel& panel = rover.start.panels[row.name];
  panel.goes_up = row.order != OrderRow::stowed;
  panel.steering.mode = steer_mode(row.order).value_or(SteerMode::fixed);
  panel.steering.angles = {row.azimuth_rad, row.elevation_rad};
}

}  // namespace

RunEnd read_run_end(const LogReader& log) {
  RunEnd end;
  SimTime last{};
  log.for_each_sample([&](const SampleRow& row) {
    end.rovers[row.rover_id].sample = row;
    last = std::max(last, row.time);
  });
  end.time = log.start() + last;
  SimTime first_of_last = last;  // a rover that is parked may have its last row earlier
  for (auto& [id, rover] : end.rovers) {
    const SampleRow& row = rover.sample;
    first_of_last = std::min(first_of_last, row.time);
    rover.start.place = row.place;
    rover.start.heading_rad = row.heading_rad;
    if (!std::isnan(row.energy_j)) rover.start.energy_j = row.energy_j;
    if (row.speed_mps > moving_mps) {
      rover.doubts.push_back(
          fmt::format("it was still driving, {:.2g} m/s fast, and begins at rest", row.speed_mps));
    }
  }
  // Rows of other layers are written with the samples, at the same times.
  const auto visit_last = [&](const auto& row, auto add) {
    const auto rover = end.rovers.find(row.rover_id);
    if (rover != end.rovers.end() && row.time == rover->second.sample.time) {
      add(rover->second, row);
    }
  };
  const TimeSpan span{first_of_last, last};
  log.for_each_joint([&](const JointRow& row) { visit_last(row, add_joint); }, span);
  log.for_each_panel([&](const PanelRow& row) { visit_last(row, add_panel); }, span);
  log.for_each_resource(
      [&](const ResourceRow& row) {
        visit_last(row, [](RoverEnd& rover, const ResourceRow& last_row) {
          rover.start.resources[last_row.resource] = last_row.amount;
        });
      },
      span);
  const auto visit_all = [&](const auto& row, auto add) {
    const auto rover = end.rovers.find(row.rover_id);
    if (rover != end.rovers.end()) add(rover->second, row);
  };
  log.for_each_note([&](const NoteRow& row) { visit_all(row, add_note); });
  for (auto& [id, rover] : end.rovers) {
    if (rover.shade == 1) continue;
    rover.doubts.push_back(
        fmt::format("a script left its panels {:.3g} % of the sunlight; they begin in all of it",
                    100 * rover.shade));
  }
  const std::vector<OrderRow> orders = log.orders();
  for (const OrderRow& row : orders) visit_all(row, add_order);
  if (!orders.empty()) return end;
  for (auto& [id, rover] : end.rovers) {
    if (rover.start.panels.empty()) continue;
    rover.doubts.emplace_back(
        "its log, of an older version, does not say what its panels followed; they stay fixed");
  }
  return end;
}

}  // namespace lsos
