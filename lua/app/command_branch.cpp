// `lsos-host branch`: goes on otherwise from a moment of a run.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "base/console.h"
#include "base/files.h"
#include "base/stop_signal.h"
#include "interchange/plan_document.h"
#include "lua/app/branch_measured.h"
#include "lua/app/branch_moment.h"
#include "lua/app/commands.h"
#include "lua/app/progress.h"
#include "lua/app/run_to_end.h"
#include "lua/app/saved_run.h"
#include "lua/host/mission_reader.h"
#include "lua/host/plan_table.h"
#include "lua/host/run_from.h"
#include "lua/host/run_values.h"
#include "lua/host/version.h"
#include "lua/session/change_script.h"
#include "mission/model/plan_revision.h"
#include "plan/renumbered.h"
#include "product/replaced_run.h"
#include "product/summary.h"

namespace lsos {

namespace {

struct BranchOptions : OutcomeOptions {
  std::string folder;    // of the trunk
  std::string at;        // UTC, a duration from the start, or an event
  std::string output;    // folder of the branch
  std::string plan;      // "": the trunk's
  std::string measured;  // a table of telemetry; "": none
  std::string changes;   // a script; "": none
  bool is_forced = false;
  bool is_renderer_allowed = false;
  CheckpointOptions checkpoints;
};

void check_branch(const BranchOptions& options) {
  Faults faults;
  if (options.at.empty()) faults.error({}, "--at: a time or an event of the run is required");
  if (options.output.empty()) faults.error({}, "-o: the folder of the branch is required");
  std::error_code ignored;
  if (std::filesystem::equivalent(options.folder, options.output, ignored)) {
    faults.error({}, fmt::format("-o {}: a branch needs a folder of its own", options.output));
  }
  if (!options.changes.empty() && !std::filesystem::is_regular_file(options.changes, ignored)) {
    faults.error({}, fmt::format("--with {}: no such file", options.changes));
  }
  faults.throw_if_errors();
}

// The plan that takes over, with the numbers that events which have begun have in the trunk.
PlanSource revised_source(const BranchOptions& options, const MissionFiles& trunk,
                          const EventReferences& begun) {
  PlanSource source = read_plan_source(options.plan);
  allow_beside(options.plan);
  const MissionFiles files = read_mission(source, read_catalog(source), trunk.plan.mission.seed);
  files.faults.throw_if_errors();
  const auto numbers = renumbered_events(trunk.plan, begun, files.plan);
  if (numbers.empty()) return source;
  renumber_events(source.kml, numbers);
  source.bytes = kml_of(source.kml);
  return source;
}

// "plan b.kml, measured t.csv, with dust.lua"
std::string changes_text(const BranchOptions& options) {
  std::string text;
  const auto add = [&](const char* what, const std::string& file) {
    if (!file.empty()) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", what, file);
  };
  add("plan", options.plan);
  add("measured", options.measured);
  add("with", options.changes);
  return text;
}

// Digest of the log of a finished run, computed from the log; "": the run did not finish.
std::string digest_of(const std::string& folder, const LogReader& log) {
  return is_summary(read_file(folder + "/summary.json").value_or("")) ? log.sha256() : "";
}

void print_faults_of_branch(const Faults& faults, bool is_quiet) {
  for (const Fault& fault : faults.sorted()) {
    if (!is_quiet) print_message("{}\n", to_string(fault));
  }
}

// The mission of `source`, which begins as that of the trunk did.
MissionFiles branch_files(const PlanSource& source, const SavedRun& saved, std::uint64_t seed) {
  MissionFiles files = read_mission(source, read_catalog(source), seed);
  if (!saved.mission.from.empty() && !files.faults.has_errors()) {
    begin_from(saved.mission.from, files);
  }
  return files;
}

// Replaces the simulation by one of the changed mission, in the same log. It is made as `resume`
// makes it, so that a branch that is stopped goes on as it would have.
void take_up(SessionParts& parts, MissionFiles files, const BranchOptions& options,
             PlanningWatch& watch) {
  SimulationSetup setup = run_setup(files, options, watch);
  setup.cached_legs = parts.simulation->cached_legs();
  auto simulation = std::make_unique<Simulation>(std::move(setup));
  parts.simulation->log_changes();
  simulation->go_on_from(*parts.simulation);
  simulation->set_log(&parts.record->log());
  std::set<std::pair<std::string, std::int64_t>> events;
  for (const PlanEvent& event : files.plan.events) {
    events.insert({event.rover_id, event.sequence});
  }
  parts.record->log().keep_events(events);
  files.faults.add(simulation->advice());
  parts.simulation = std::move(simulation);
  parts.files = std::move(files);
}

// Runs the script of changes. Events that it adds become part of the plan.
void change(SessionParts& parts, const BranchOptions& options) {
  const SimTime moment = parts.simulation->now();
  run_change_script(parts, options.changes);
  if (parts.simulation->now() != moment) {
    throw InputError({options.changes},
                     "lets time pass (step, run_for, run_until, run): what it changes must be at "
                     "the moment of --at; --at names another");
  }
  if (parts.dispatched.empty()) return;
  std::vector<SourcePlacemark>& placemarks = parts.source.kml.placemarks;
  placemarks.insert(placemarks.end(), parts.dispatched.begin(), parts.dispatched.end());
  parts.source.bytes = kml_of(parts.source.kml);
}

// What a branch begins with: the trunk's last checkpoint at or before the moment, and what is to
// change there.
struct Leave {
  SimTime moment{};
  EventReferences begun;  // events of the trunk that have begun by then
  SavedRun saved;
  std::uint64_t seed = 0;
  std::optional<PlanSource> source;  // of the plan that takes over; absent: the trunk's goes on
  MissionFiles files;                // of that plan
  MeasuredStates measured;
};

// Reads what is to change; nothing is written yet.
Leave read_leave(const BranchOptions& options, const LogReader& log, SessionParts& parts) {
  Leave leave;
  leave.moment = branch_moment(log, options.folder, options.at);
  std::vector<std::string> damaged;
  leave.saved = saved_run_before(log, options.folder, leave.moment, damaged);
  for (const std::string& what : damaged) print_message("warning: {}\n", what);
  check_not_from(options.output, leave.saved.mission.from);
  leave.begun = begun_events(log, leave.moment);
  const SavedMission& mission = leave.saved.mission;
  parts.source = source_of_run(options.folder, mission);
  parts.files = files_of_run(options.folder, mission);
  leave.seed = parts.files.plan.mission.seed;
  if (options.plan.empty()) return leave;
  leave.source = revised_source(options, parts.files, leave.begun);
  leave.source->soil = mission.soil;
  leave.files = branch_files(*leave.source, leave.saved, leave.seed);
  check_revision(parts.files.plan, leave.begun, leave.files.plan, leave.files.faults);
  leave.files.faults.throw_if_errors();
  return leave;
}

// The trunk's simulation at its checkpoint. What is not as it was then is refused.
void restore_trunk(SessionParts& parts, Leave& leave, const BranchOptions& options,
                   PlanningWatch& watch) {
  parts.simulation = std::make_unique<Simulation>(run_setup(parts.files, options, watch));
  const Faults differing =
      differences(leave.saved.mission, program_build(), run_values(parts.files, *parts.simulation),
                  options.folder, options.is_renderer_allowed);
  differing.throw_if_errors();
  parts.files.faults.add(parts.simulation->advice());
  parts.files.faults.add(differing.sorted());
  leave.files.faults.add(differing.sorted());
  restore(*parts.simulation, leave.saved, options.folder);
}

// Simulates up to the moment, in a copy of the trunk's log, and makes the changes there.
void leave_trunk(SessionParts& parts, Leave leave, const BranchOptions& options,
                 const LogReader& log, PlanningWatch& watch) {
  write_file(parts.folder->file("plan.kml"), parts.source.bytes);
  log.copy_to(parts.folder->file("log.gpkg"));
  parts.record =
      std::make_unique<RunRecord>(*parts.folder, parts.files, leave.saved.id, *parts.simulation);
  const std::string trunk = std::filesystem::absolute(options.folder).lexically_normal();
  parts.record->log().begin_branch(
      {trunk, digest_of(options.folder, log), leave.moment, changes_text(options)});
  while (parts.simulation->now() < leave.moment && !parts.simulation->is_finished()) {
    parts.simulation->advance(leave.moment);
  }
  LSOS_ASSERT(parts.simulation->begun_events() == leave.begun);
  if (!options.measured.empty()) {
    go_on_from_measured(*parts.simulation, leave.measured, options.measured, options.is_quiet);
  }
  if (leave.source) {
    take_up(parts, std::move(leave.files), options, watch);
    parts.source = std::move(*leave.source);
  }
  if (!options.changes.empty()) {
    change(parts, options);
    MissionFiles changed = branch_files(parts.source, leave.saved, leave.seed);
    changed.faults.throw_if_errors();
    take_up(parts, std::move(changed), options, watch);
  }
  parts.simulation->log_changes();
  parts.files.faults.add(leave.measured.warnings);
  write_file(parts.folder->file("plan.kml"), parts.source.bytes);
}

int branch_command(const BranchOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  check_branch(options);
  const SimTime every = kept_every(options.checkpoints);
  const LogReader log(options.folder + "/log.gpkg");
  SessionParts parts;
  Leave leave = read_leave(options, log, parts);
  const std::string other =
      check_replaced_run(options.output, parts.source.file, false, options.is_forced);
  parts.folder = std::make_unique<RunFolder>(options.output, options.is_forced);
  PlanningWatch watch(options.is_quiet);
  restore_trunk(parts, leave, options, watch);
  if (!options.measured.empty()) {
    leave.measured = read_measured(options.measured, log, leave.moment, parts.simulation->ground());
  }
  const SavedMission trunk = leave.saved.mission;
  const SimTime left = leave.saved.time;

  // From here on the folder of the branch is written. Until its first checkpoint it cannot be
  // resumed.
  parts.folder->prepare();
  try {
    leave_trunk(parts, std::move(leave), options, log, watch);
  } catch (...) {
    parts.record.reset();
    parts.folder->discard();
    throw;
  }
  parts.folder->settle();
  tell_of_replaced_run(parts.folder->path(), other);
  print_faults_of_branch(parts.files.faults, options.is_quiet);
  std::map<std::string, std::string> values = run_values(parts.files, *parts.simulation);
  if (const auto renderer = values.find("renderer"); renderer != values.end()) {
    const auto before = trunk.values.find("renderer");
    if (before != trunk.values.end()) {
      renderer->second = renderers_text(before->second, renderer->second, left);
    }
  }
  parts.record->log().write_run(values);
  if (!options.is_quiet) {
    print_message("{}: leaves {} at {} of the mission\n", parts.folder->path(), options.folder,
                  clock_text(seconds(parts.simulation->now())));
  }
  catch_stop_signals();
  const std::string plan_file = std::filesystem::absolute(parts.source.file).lexically_normal();
  Checkpoints checkpoints(
      parts.record->log(),
      {program_build(), plan_file, values, every, parts.source.soil, trunk.from, ""},
      options.checkpoints.is_on, seconds_since(begin));
  checkpoints.start(*parts.simulation);
  return run_to_end({parts.files, *parts.simulation, *parts.folder, *parts.record, checkpoints},
                    options);
}

}  // namespace

std::function<int()> prepare_branch(CommandOptions& command) {
  const auto options = std::make_shared<BranchOptions>();
  command.add_option("DIR", options->folder, "Folder of a run that keeps checkpoints").required();
  command.add_option("--at", options->at,
                     "When it goes on otherwise: UTC, a time from the start, or an event (its "
                     "label, or ROVER/SEQUENCE): just before that begins");
  command.add_option("-o,--output", options->output, "Folder of the branch");
  command.add_option("--plan", options->plan,
                     "A plan whose later events take the place of the run's");
  command.add_option("--measured", options->measured,
                     "A table of telemetry, CSV: rovers go on from the place, heading and charge "
                     "that were measured last");
  command.add_option("--with", options->changes,
                     "A Lua script of changes at that moment, to 'sim' as in scenarios");
  command.add_flag("--force", options->is_forced, "Replace an unfinished run");
  add_outcome_options(command, *options);
  add_checkpoint_options(command, options->checkpoints);
  command.add_flag("--allow-renderer", options->is_renderer_allowed,
                   "Go on although another renderer draws light and sight");
  return [options] { return branch_command(*options); };
}

}  // namespace lsos
