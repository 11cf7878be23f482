#include "lua/app/saved_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/archive.h"
#include "base/files.h"
#include "base/quantity.h"
#include "lua/host/mission_reader.h"
#include "lua/host/run_from.h"
#include "lua/host/version.h"
#include "product/summary.h"

namespace lsos {

namespace {

// The last of the entries, which come in order of time, that can be read.
SavedRun last_readable(const LogReader& log, const std::string& folder,
                       const std::vector<CheckpointEntry>& entries,
                       std::vector<std::string>& damaged) {
  for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
    try {
      return saved_run(log, folder, entry->id);
    } catch (const InputError& error) {
      damaged.emplace_back(error.what());
    }
  }
  Faults faults;
  for (const std::string& what : damaged) faults.error({}, what);
  faults.error({folder}, "none of its checkpoints can be read: run the plan again");
  faults.throw_if_errors();
  return {};
}

}  // namespace

std::vector<CheckpointEntry> resumable_checkpoints(const std::string& folder) {
  const LogReader log(folder + "/log.gpkg");
  std::vector<CheckpointEntry> entries = log.checkpoints();
  const bool has_ended = is_summary(read_file(folder + "/summary.json").value_or(""));
  const bool was_stopped = std::ranges::any_of(
      entries, [](const CheckpointEntry& entry) { return entry.kind == CheckpointKind::stop; });
  if (has_ended && !was_stopped) {
    throw InputError({folder},
                     entries.empty()
                         ? "its run has finished or was stopped without checkpoints: there is "
                           "nothing to go on with"
                         : "its run has finished: there is nothing to go on with; 'lsos-host "
                           "branch' tries another end");
  }
  if (entries.empty()) {
    throw InputError({folder},
                     "its run has no checkpoint (it was killed before the first, or run with "
                     "--no-checkpoints): run the plan again");
  }
  return entries;
}

SavedRun saved_run(const LogReader& log, const std::string& folder, std::int64_t id) {
  const StoredCheckpoint stored = log.checkpoint(id);
  try {
    return {id, stored.time, stored.wall_s, saved_mission(stored.state)};
  } catch (const Archive::Mismatch&) {
    throw InputError({folder},
                     fmt::format("its checkpoint {} is not of this version of lsos-host", id));
  }
}

SavedRun last_saved_run(const std::string& folder, const std::vector<CheckpointEntry>& entries,
                        std::vector<std::string>& damaged) {
  return last_readable(LogReader(folder + "/log.gpkg"), folder, entries, damaged);
}

SavedRun saved_run_before(const LogReader& log, const std::string& folder, SimTime moment,
                          std::vector<std::string>& damaged) {
  std::vector<CheckpointEntry> entries = log.checkpoints();
  std::erase_if(entries, [&](const CheckpointEntry& entry) { return entry.time > moment; });
  if (entries.empty()) {
    throw InputError({folder},
                     "keeps no checkpoint at or before that moment: run the plan with "
                     "--checkpoint-every, as in --checkpoint-every \"1 d\"");
  }
  return last_readable(log, folder, entries, damaged);
}

PlanSource source_of_run(const std::string& folder, const SavedMission& mission) {
  PlanSource source = read_plan_source(folder + "/plan.kml");
  allow_around(source);
  std::error_code unreadable;
  const auto original = std::filesystem::path(mission.plan_file);
  if (std::filesystem::is_directory(original.parent_path(), unreadable)) {
    source.file = mission.plan_file;
    // A run may come from elsewhere: it opens what lies beside a plan of the user's only where
    // there is one, of that name.
    allow_other(original.string());
    allow_other(home_of(source.kml, source.file));
  }
  source.soil = mission.soil;
  return source;
}

MissionFiles files_of_run(const std::string& folder, const SavedMission& mission) {
  const auto known = mission.values.find("seed");
  const auto seed = parse_integer(known == mission.values.end() ? "" : known->second);
  if (!seed) throw InputError({folder}, "its checkpoint does not say which seed was run");
  const PlanSource source = source_of_run(folder, mission);
  MissionFiles files = read_mission(source, read_catalog(source), *seed.value);
  if (!mission.from.empty() && !files.faults.has_errors()) begin_from(mission.from, files);
  files.faults.throw_if_errors();
  return files;
}

void restore(Simulation& simulation, const SavedRun& saved, const std::string& folder) {
  const auto refuse = [&](const std::string& why) {
    throw InputError({folder},
                     fmt::format("its checkpoint {} does not fit the mission: {}", saved.id, why));
  };
  try {
    simulation.restore(saved.mission.state);
  } catch (const Archive::Mismatch& error) {
    refuse(error.what());
  }
  if (simulation.now() != saved.time) refuse("it is of another moment");
}

}  // namespace lsos
