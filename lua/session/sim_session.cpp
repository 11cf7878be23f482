#include "lua/session/sim_session.h"
#include "interchange/plan_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "base/console.h"
#include "base/quantity.h"
#include "base/sha256.h"
#include "lua/host/event_check.h"
#include "lua/host/mission_reader.h"
#include "lua/host/plan_table.h"
#include "lua/host/run_from.h"
#include "lua/host/run_values.h"
#include "plan/kml_reader.h"

namespace lsos {

namespace {

std::atomic<bool> is_interrupted{false};

constexpr SimTime quiet_interval{1'000'000};
constexpr std::size_t hash_bytes = 64;

// The number changes with the saved format.
std::string saved_head() { return std::string(SimSession::saved_mark) + " 5\n"; }

// An event that is checked as those of a plan's file are. Throws InputError.
PlanEvent checked_event(const SourcePlacemark& placemark, const Plan& plan,
                        const MissionFiles& files) {
  PlanEvent event = read_event(placemark, plan, files.catalog->declarations());
  Plan with = plan;
  with.events = {event};
  Faults faults;
  check_events(with, files, faults);
  check_names(with, files, faults);
  faults.throw_if_errors();
  return event;
}

}  // namespace

void SimSession::interrupt() { is_interrupted = true; }
void SimSession::forget_interrupt() { is_interrupted = false; }

SimSession::SimSession(PlanSource source, std::shared_ptr<const Catalog> catalog,
                       const std::string& folder)
    : source_(std::move(source)),
      files_(read_mission(source_, std::move(catalog))),
      folder_(std::make_unique<RunFolder>(folder, true)) {
  files_.faults.throw_if_errors();
  replace_simulation(make_simulation(files_, true, {}), true);
  simulation_->start();
}

SimSession::SimSession(SessionParts parts)
    : source_(std::move(parts.source)),
      files_(std::move(parts.files)),
      folder_(std::move(parts.folder)),
      record_(std::move(parts.record)),
      begins_log_(false),
      dispatched_(std::move(parts.dispatched)) {
  replace_simulation(std::move(parts.simulation), false);
}

SessionParts SimSession::release() {
  simulation_->set_note_listener({});
  return {std::move(source_),     std::move(files_),  std::move(folder_),
          std::move(simulation_), std::move(record_), std::move(dispatched_)};
}

SimSession::~SimSession() {
  try {
    finish();
  } catch (const std::exception&) {
    // The committed part of the log stays.
  }
}

MissionFiles SimSession::files_with(const std::string& soil,
                                    std::shared_ptr<const Catalog> catalog) const {
  PlanSource source = source_;
  source.soil = soil;
  MissionFiles files = read_mission(source, std::move(catalog), files_.plan.mission.seed);
  files.faults.throw_if_errors();
  if (files_.from) begin_from(files_.from->folder, files);
  files.faults.throw_if_errors();
  return files;
}

std::unique_ptr<Simulation> SimSession::make_simulation(
    const MissionFiles& files, bool plans_ahead,
    const std::vector<SourcePlacemark>& dispatched) const {
  SimulationSetup setup = simulation_setup(files);
  setup.keeps_sight = true;
  setup.plans_ahead = plans_ahead;
  if (simulation_) setup.cached_legs = simulation_->cached_legs();
  auto simulation = std::make_unique<Simulation>(std::move(setup));
  for (const SourcePlacemark& placemark : dispatched) {
    simulation->dispatch(checked_event(placemark, simulation->plan(), files));
  }
  return simulation;
}

void SimSession::replace_simulation(std::unique_ptr<Simulation> simulation, bool begins_log) {
  simulation_ = std::move(simulation);
  simulation_->set_note_listener([this](const NoteRow& row) { keep(row); });
  if (!begins_log) return simulation_->set_log(&record_->log());
  record_.reset();
  record_ = std::make_unique<RunRecord>(*folder_, source_.bytes, files_,
                                        run_values(files_, *simulation_), *simulation_);
}

void SimSession::continue_with(MissionFiles files, bool plans_ahead) {
  std::unique_ptr<Simulation> simulation = make_simulation(files, plans_ahead, dispatched_);
  try {
    simulation->restore(simulation_->save());
  } catch (const Archive::Mismatch& error) {
    throw InputError({}, fmt::format("what runs cannot go on so: {}", error.what()));
  }
  files_ = std::move(files);
  replace_simulation(std::move(simulation), false);
}

void SimSession::advance(std::optional<SimTime> until) {
  if (is_interrupted.exchange(false)) {
    throw std::runtime_error(fmt::format("stopped at {} s", seconds(now())));
  }
  simulation_->advance(until);
}

void SimSession::step(std::int64_t count) {
  for (std::int64_t k = 0; k < count && !simulation_->is_finished(); ++k) advance();
}

void SimSession::run_for(double duration_s) {
  const SimTime end = round_up_to_exchange(now() + from_seconds(duration_s));
  while (now() < end && !simulation_->is_finished()) advance(end);
}

bool SimSession::run_until(const std::function<bool()>& is_enough, double limit_s) {
  const SimTime end = round_up_to_exchange(now() + from_seconds(limit_s));
  while (!is_enough()) {
    if (now() >= end || simulation_->is_finished()) return false;
    advance(std::min(end, (now() / quiet_interval + 1) * quiet_interval));
  }
  return true;
}

void SimSession::run() {
  while (!simulation_->is_finished()) advance();
}

std::vector<std::string> SimSession::phases() const {
  std::vector<std::string> phases;
  for (const FleetRover& rover : simulation_->fleet().rovers) {
    const EventSequence& sequence = rover.sequence;
    phases.push_back(sequence.event_label() + '\n' + sequence.phase());
  }
  return phases;
}

void SimSession::step_phase() {
  const std::vector<std::string> before = phases();
  while (!simulation_->is_finished() && phases() == before) advance();
}

std::set<std::int64_t> SimSession::dispatched_to(const std::string& rover_id) const {
  std::set<std::int64_t> sequences;
  for (const SourcePlacemark& placemark : dispatched_) {
    const std::vector<SourceField>& fields = placemark.data.front().fields;
    const auto text = [&](const char* name) {
      const auto found = std::ranges::find(fields, name, &SourceField::name);
      return found == fields.end() ? std::string() : found->text;
    };
    const auto sequence = parse_integer(text("Sequence"));
    if (text("RoverId") == rover_id && sequence) sequences.insert(*sequence.value);
  }
  return sequences;
}

std::int64_t SimSession::dispatch(const std::string& rover_id, SourcePlacemark placemark) {
  const Fleet& fleet = simulation_->fleet();
  const FleetRover* rover = fleet.find(rover_id);
  if (rover == nullptr) {
    throw InputError({}, fmt::format("there is no rover '{}'{}", rover_id,
                                     did_you_mean(rover_id, fleet.rover_ids())));
  }
  const EventSequence* sequence = &rover->sequence;
  std::vector<SourceField>& fields = placemark.data.front().fields;
  fields.push_back({"RoverId", rover_id, 0});
  if (std::ranges::find(fields, "Sequence", &SourceField::name) == fields.end()) {
    // The number follows the events that have begun or were dispatched earlier, and precedes the
    // plan's next event where there is room.
    std::int64_t last = 0, next = std::numeric_limits<std::int64_t>::max(), highest = 0;
    const std::set<std::int64_t> earlier = dispatched_to(rover_id);
    for (std::size_t i = 0; i < sequence->events().size(); ++i) {
      const std::int64_t number = sequence->events()[i].event.sequence;
      const EventRecord& record = sequence->records()[i];
      highest = std::max(highest, number);
      if (record.ready || record.end || (number < next && earlier.contains(number))) {
        last = number;
      } else {
        next = std::min(next, number);
      }
    }
    if (last + 1 >= next && highest == std::numeric_limits<std::int64_t>::max()) {
      throw InputError({}, "there is no Sequence behind the last");
    }
    const std::int64_t number = last + 1 < next ? last + 1 : highest + 1;
    fields.push_back({"Sequence", std::to_string(number), 0});
  }
  const PlanEvent event = checked_event(placemark, simulation_->plan(), files_);
  simulation_->dispatch(event);
  dispatched_.push_back(std::move(placemark));
  return event.sequence;
}

void SimSession::reload() { continue_with(files_with(source_.soil, read_catalog(source_)), true); }

void SimSession::set_soil(const std::string& name) {
  continue_with(files_with(name, files_.catalog), false);
  source_.soil = name;
}

std::vector<std::string> SimSession::take_news() {
  std::vector<std::string> news;
  for (const FleetRover& rover : simulation_->fleet().rovers) {
    const EventSequence& sequence = rover.sequence;
    for (std::size_t i = 0; i < sequence.events().size(); ++i) {
      const EventRecord& record = sequence.records()[i];
      const PlanEvent& event = sequence.events()[i].event;
      const std::string name = fmt::format("{}/{}", rover.agent->id(), event.sequence);
      if (record.status != EventStatus::failed || !reported_.insert(name).second) continue;
      news.push_back(fmt::format("{} '{}' failed at {} s: {}", name, event.label,
                                 seconds(record.end.value_or(now())), record.reason));
    }
  }
  // The reason of a failed script occurs in a warning again, with its traceback.
  const std::vector<std::string>& warnings = simulation_->warnings();
  for (std::size_t& i = reported_warnings_; i < warnings.size(); ++i) {
    const std::size_t reason = warnings[i].find('\n');
    const bool is_more = reason != std::string::npos;
    news.push_back(is_more ? warnings[i].substr(reason + 1) : "warning: " + warnings[i]);
  }
  return news;
}

void SimSession::keep(const NoteRow& note) {
  if (!has_all_notes()) return;
  notes_.push_back(note);
  note_bytes_ += sizeof note + note.name.size() + note.fields_json.size();
}

std::string SimSession::save() {
  Archive a = Archive::writer();
  std::string plan = files_.plan.hash(), soil = source_.soil;
  std::string dispatched = dispatched_.empty() ? "" : kml_of({source_.file, dispatched_});
  std::string state = simulation_->save();
  a(plan)(soil)(dispatched)(notes_)(state);
  return saved_head() + sha256_hex(a.bytes()) + a.bytes();
}

void SimSession::load(const std::string& bytes) {
  if (!begins_log_) {
    throw InputError({}, "cannot be gone back to: the log of a branch goes on from its moment");
  }
  if (!bytes.starts_with(saved_head())) {
    throw InputError({}, "is not what sim:save of this version of the program wrote");
  }
  const std::string marked = bytes.substr(saved_head().size());
  const std::string content = marked.substr(std::min(hash_bytes, marked.size()));
  if (marked.substr(0, hash_bytes) != sha256_hex(content)) throw InputError({}, "is damaged");
  std::string plan, soil, dispatched_kml, state;
  std::vector<NoteRow> notes;
  try {
    Archive a = Archive::reader(content);
    a(plan)(soil)(dispatched_kml)(notes)(state);
    MissionFiles files = files_with(soil, files_.catalog);
    if (files.plan.hash() != plan) throw InputError({}, "was saved with another plan");
    std::vector<SourcePlacemark> dispatched;
    if (!dispatched_kml.empty()) dispatched = parse_kml(dispatched_kml, source_.file).placemarks;
    for (SourcePlacemark& placemark : dispatched) placemark.line = 0;  // the line was not saved
    std::unique_ptr<Simulation> simulation = make_simulation(files, true, dispatched);
    simulation->restore(state);
    dispatched_ = std::move(dispatched);
    notes_.clear();
    note_bytes_ = 0;
    for (const NoteRow& note : notes) keep(note);
    files_ = std::move(files);
    source_.soil = soil;
    replace_simulation(std::move(simulation), true);
  } catch (const Archive::Mismatch& error) {
    throw InputError({}, fmt::format("is of another version of the program: {}", error.what()));
  }
  reported_.clear();
  reported_warnings_ = 0;
  take_news();  // earlier failures and warnings have been reported
}

void SimSession::commit_log() {
  if (record_) record_->log().commit();
}

void SimSession::finish() {
  if (!record_) return;
  if (!simulation_->is_finished()) simulation_->stop("the session has ended");
  simulation_->terminate();
  const std::unique_ptr<RunRecord> record = std::move(record_);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin_;
  record->finish(files_, *simulation_, wall.count(),
                 [](const std::string& what) { print_message("warning: {}\n", what); });
}

}  // namespace lsos
