#include "product/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "plan/kml_writer.h"
#include "product/overlay_marks.h"
#include "product/overlay_style.h"
#include "product/rover_days.h"
#include "product/rover_track.h"
#include "product/shown_rows.h"
#include "product/thinned_notes.h"

namespace lsos {

namespace {

KmlFolder named_folder(std::string name) {
  KmlFolder folder;
  folder.name = std::move(name);
  return folder;
}

KmlFolder folder_of_marks(std::string name, OverlayMarks marks) {
  KmlFolder folder = named_folder(std::move(name));
  for (OverlayMark& mark : marks) folder.placemarks.push_back(std::move(mark.placemark));
  return folder;
}

// How many days a mission has, the last of them part of a day.
int day_count(SimTime end) {
  return static_cast<int>((end + day_length - SimTime{1}) / day_length);
}

std::string minute_text(Instant instant) {
  const std::string utc = format_utc(instant);
  return utc.substr(0, 10) + " " + utc.substr(11, 5);
}

// A kind of Placemarks of a rover: "samples".
struct KindOfMarks {
  std::string name;
  OverlayMarks marks;
};

// Folders of each day's Placemarks, in which each kind has its own; then folders of those that
// belong to no day. Days without any are left out.
std::vector<KmlFolder> folders_by_day(const std::string& rover_id, std::vector<KindOfMarks> kinds,
                                      Instant start, SimTime end) {
  const int count = day_count(end);
  std::vector<KmlFolder> days(static_cast<std::size_t>(count)), undated;
  for (int day = 0; day < count; ++day) {
    KmlFolder& folder = days[static_cast<std::size_t>(day)];
    folder.name = fmt::format("{} day {}", rover_id, day + 1);
    const SimTime to = std::min((day + 1) * day_length, end);
    folder.description =
        fmt::format("{} to {} UTC", minute_text(start + day * day_length), minute_text(start + to));
  }
  for (KindOfMarks& kind : kinds) {
    std::map<int, OverlayMarks> of_days;
    OverlayMarks others;
    for (OverlayMark& mark : kind.marks) {
      const auto day = [&] {
        return std::min(static_cast<int>(*mark.time / day_length), count - 1);
      };
      (mark.time ? of_days[day()] : others).push_back(std::move(mark));
    }
    for (auto& [day, marks] : of_days) {
      KmlFolder& folder = days[static_cast<std::size_t>(day)];
      folder.folders.push_back(
          folder_of_marks(fmt::format("{} {}", folder.name, kind.name), std::move(marks)));
    }
    if (!others.empty()) {
      undated.push_back(
          folder_of_marks(fmt::format("{} {}", rover_id, kind.name), std::move(others)));
    }
  }
  std::erase_if(days, [](const KmlFolder& day) { return day.folders.empty(); });
  days.insert(days.end(), std::make_move_iterator(undated.begin()),
              std::make_move_iterator(undated.end()));
  return days;
}

// At most so many samples of each rover that all together keep to the limit of the document.
int samples_of_each(const std::map<std::string, SampleTotals>& totals) {
  std::vector<std::size_t> rows;
  for (const auto& [id, of_rover] : totals) rows.push_back(of_rover.rows);
  const std::size_t each = limit_of_each(std::move(rows), overlay_all_samples_max);
  return std::clamp(static_cast<int>(each), overlay_samples_min, overlay_samples_max);
}

std::map<std::string, RoverTrack> tracks(const LogReader& log, const Plan& plan,
                                         const std::map<std::string, SampleTotals>& totals,
                                         const std::vector<EventRow>& events) {
  const MissionInfo& mission = plan.mission;
  LSOS_ASSERT(mission.planet != nullptr);
  // Half of a track's points are spaced by distance driven, half by time.
  const int half = overlay_track_max / 2;
  const SimTime end = log.last_sample_time();
  const SimTime interval =
      sample_interval(end, half, mission.log_interval, mission.parked_log_interval);
  const SimTime piece_length = day_count(end) > 1 ? day_length : SimTime{};
  const int samples_max = samples_of_each(totals);
  std::map<std::string, RoverTrack> tracks;
  for (const auto& [id, of_rover] : totals) {
    const auto marks = [&, &id = id, &of_rover = of_rover](int most) {
      return DriveMarks(of_rover, events, id, static_cast<std::size_t>(most));
    };
    const bool is_whole = of_rover.rows <= static_cast<std::size_t>(overlay_track_max);
    tracks.try_emplace(id, *mission.planet, marks(samples_max), marks(half),
                       is_whole ? SimTime{} : interval, piece_length);
  }
  log.for_each_sample([&](const SampleRow& row) {
    const auto track = tracks.find(row.rover_id);
    if (track != tracks.end()) track->second.add(row);  // absent: it appeared while the run goes on
  });
  return tracks;
}

// What the Placemarks of all rovers are made of.
struct LoggedMarks {
  const Plan& plan;
  std::vector<PlannedPathRow> paths;  // with simplified lines
  std::vector<EventRow> events;
  Instant start;
  SimTime end;
};

// The folders of one rover: with one day each kind of Placemarks has its folder, with several each
// day has its own of each kind that happens at a time.
std::vector<KmlFolder> rover_folders(const RoverTrack& track, const LoggedMarks& logged,
                                     const std::string& rover_id, const RoverStyle& style) {
  const auto& [plan, paths, events, start, end] = logged;
  std::vector<KindOfMarks> at_times{{"planned", planned_lines(paths, start, rover_id, style)},
                                    {"driven", driven_lines(track, start, rover_id, style)},
                                    {"events", event_points(events, start, rover_id)},
                                    {"samples", sample_points(track, start, rover_id, style)}};
  std::vector<KmlFolder> folders{
      folder_of_marks(rover_id + " plan", drawn_lines(plan, rover_id, style)),
      folder_of_marks(rover_id + " track", moving_point(track, start, rover_id, style))};
  if (day_count(end) > 1) {
    std::vector<KmlFolder> days = folders_by_day(rover_id, std::move(at_times), start, end);
    folders.insert(folders.end(), std::make_move_iterator(days.begin()),
                   std::make_move_iterator(days.end()));
    return folders;
  }
  for (KindOfMarks& kind : at_times) {
    folders.push_back(folder_of_marks(rover_id + " " + kind.name, std::move(kind.marks)));
  }
  return folders;
}

}  // namespace

std::string overlay_kml(const LogReader& log, const Plan& plan, IconPlace icon_href) {
  LoggedMarks logged{plan, {}, log.events(), log.start(), log.last_sample_time()};
  const ShownRows paths = for_each_shown_path(log, [&](const PlannedPathRow& row) {
    logged.paths.push_back(row);
    logged.paths.back().line = simplified_line(*plan.mission.planet, row.line);
  });
  KmlDocument document;
  document.name = fmt::format("{}, simulated", std::filesystem::path(plan.file).stem().string());
  document.description = fmt::format("simulated from {}", format_utc(logged.start));
  if (!paths.is_whole()) document.description += "; " + shown_text(paths, "planned paths");
  document.target = target_of(*plan.mission.planet);
  document.schemas = overlay_schemas();
  std::size_t i = 0;
  for (const EventStatus status :
       {EventStatus::completed, EventStatus::failed, EventStatus::incomplete, EventStatus::skipped,
        EventStatus::not_started, EventStatus::disabled}) {
    for (const bool has_label : {true, false}) {
      document.styles.push_back(status_style(status, has_label, icon_href));
    }
  }
  document.styles.push_back(warning_style(icon_href));
  std::vector<Geodetic> places;
  const std::map<std::string, SampleTotals> totals = log.sample_totals();
  for (const auto& [rover_id, track] : tracks(log, plan, totals, logged.events)) {
    const RoverStyle style(i++);
    style.add_to(document.styles, icon_href);
    for (const SampleRow& row : track.samples()) places.push_back(row.place);
    KmlFolder rover = named_folder(rover_id);
    rover.open = true;
    const std::size_t shown = track.samples().size(), in_log = totals.at(rover_id).rows;
    if (shown < in_log) {
      rover.description = fmt::format("{} of {} samples; log.gpkg has all", shown, in_log);
    }
    rover.folders = rover_folders(track, logged, rover_id, style);
    document.folders.push_back(std::move(rover));
  }
  const ThinnedNotes notes = thinned_notes(log);
  const bool is_whole = notes.rows.size() == notes.in_log;
  document.folders.push_back(folder_of_marks(
      is_whole ? "notes" : fmt::format("notes ({} of {})", notes.rows.size(), notes.in_log),
      note_points(notes, logged.start)));
  document.look_at = look_at(*plan.mission.planet, places);
  return write_kml(document);
}

void write_overlay(const std::string& run_dir, const Plan& plan) {
  write_file(run_dir + "/overlay.kml", overlay_kml(LogReader(run_dir + "/log.gpkg"), plan));
}

void write_packed_overlay(const std::string& run_dir, const Plan& plan) {
  write_file(
      run_dir + "/overlay.kmz",
      pack_kmz(overlay_kml(LogReader(run_dir + "/log.gpkg"), plan, packed_icon), packed_icons()));
}

}  // namespace lsos
