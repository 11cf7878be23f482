#include "lua/sim_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "lua/host.h"
#include "plan/kml_reader.h"

namespace lsos {

namespace {

std::atomic<bool> is_interrupted{false};

constexpr SimTime quiet_look{1'000'000};
constexpr std::string_view tag = "lsos-host session";

}  // namespace

void SimSession::interrupt() { is_interrupted = true; }
void SimSession::forget_interrupt() { is_interrupted = false; }

SimSession::SimSession(MissionFiles files, const std::string& plan_bytes, const std::string& folder)
    : files_(std::move(files)), plan_bytes_(plan_bytes), folder_(folder, true) {
  take(made());
  simulation_->start();
}

SimSession::~SimSession() {
  try {
    finish();
  } catch (const std::exception&) {
    // What was committed of the log stays.
  }
}

std::unique_ptr<Simulation> SimSession::made() const {
  SimulationSetup setup = simulation_setup(files_);
  setup.keeps_sight = true;
  return std::make_unique<Simulation>(std::move(setup));
}

void SimSession::take(std::unique_ptr<Simulation> simulation) {
  simulation_ = std::move(simulation);
  simulation_->set_note_listener([this](const NoteRow& row) { notes_.push_back(row); });
  record_.reset();
  record_ = std::make_unique<RunRecord>(folder_, plan_bytes_, files_, *simulation_);
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
    advance(std::min(end, (now() / quiet_look + 1) * quiet_look));
  }
  return true;
}

void SimSession::run() {
  while (!simulation_->is_finished()) advance();
}

std::vector<std::string> SimSession::phases() const {
  std::vector<std::string> phases;
  for (const std::string& id : simulation_->rover_ids()) {
    const EventSequence& sequence = *simulation_->sequence(id);
    phases.push_back(sequence.event_label() + '\n' + sequence.phase());
  }
  return phases;
}

void SimSession::step_phase() {
  const std::vector<std::string> before = phases();
  while (!simulation_->is_finished() && phases() == before) advance();
}

std::int64_t SimSession::dispatch(const std::string& rover_id, SourcePlacemark placemark) {
  const EventSequence* sequence = simulation_->sequence(rover_id);
  if (sequence == nullptr) {
    throw InputError({}, fmt::format("there is no rover '{}'{}", rover_id,
                                     did_you_mean(rover_id, simulation_->rover_ids())));
  }
  std::vector<SourceField>& fields = placemark.data.front().fields;
  fields.push_back({"RoverId", rover_id, 0});
  if (std::ranges::find(fields, "Sequence", &SourceField::name) == fields.end()) {
    // Behind what has had its turn, before what has not, where there is room.
    std::int64_t last = 0, next = std::numeric_limits<std::int64_t>::max(), highest = 0;
    for (std::size_t i = 0; i < sequence->events().size(); ++i) {
      const std::int64_t number = sequence->events()[i].event.sequence;
      const EventRecord& record = sequence->records()[i];
      highest = std::max(highest, number);
      if (record.ready || record.end) last = number;
      if (!record.ready && !record.end) next = std::min(next, number);
    }
    const std::int64_t number = last + 1 < next ? last + 1 : highest + 1;
    fields.push_back({"Sequence", std::to_string(number), 0});
  }
  const PlanEvent event =
      read_event(placemark, simulation_->plan(), files_.catalog->declarations());
  simulation_->dispatch(event);
  dispatched_.push_back(event);
  return event.sequence;
}

void SimSession::reload() {
  const std::shared_ptr<const Catalog> catalog = read_catalog(files_.plan.file);
  for (const PlanEvent& event : simulation_->plan().events) {
    const std::vector<Fault> faults = catalog->faults_of(ScriptKind::event, event.type);
    if (!faults.empty()) throw InputError(faults);
  }
  simulation_->take_scripts([catalog] { return std::make_unique<LuaHost>(*catalog); });
  files_.catalog = catalog;
}

std::vector<std::string> SimSession::take_news() {
  std::vector<std::string> news;
  for (const std::string& id : simulation_->rover_ids()) {
    const EventSequence& sequence = *simulation_->sequence(id);
    for (std::size_t i = 0; i < sequence.events().size(); ++i) {
      const EventRecord& record = sequence.records()[i];
      const PlanEvent& event = sequence.events()[i].event;
      const std::string name = fmt::format("{}/{}", id, event.sequence);
      if (record.status != EventStatus::failed || !told_.insert(name).second) continue;
      news.push_back(fmt::format("{} '{}' failed at {} s: {}", name, event.label,
                                 seconds(record.end.value_or(now())), record.reason));
    }
  }
  // The reason of a script that broke comes again there, with its traceback.
  const std::vector<std::string>& warnings = simulation_->warnings();
  for (std::size_t& i = told_warnings_; i < warnings.size(); ++i) {
    const std::size_t reason = warnings[i].find('\n');
    const bool is_more = reason != std::string::npos;
    news.push_back(is_more ? warnings[i].substr(reason + 1) : "warning: " + warnings[i]);
  }
  return news;
}

std::string SimSession::save() {
  Archive a = Archive::writer();
  std::string plan = simulation_->plan().hash(), state = simulation_->save();
  a.tag(tag)(plan)(state);
  return a.bytes();
}

void SimSession::load(const std::string& bytes) {
  std::string plan, state;
  try {
    Archive a = Archive::reader(bytes);
    a.tag(tag)(plan)(state);
    std::unique_ptr<Simulation> simulation = made();
    std::size_t count = 0;
    while (simulation->plan().hash() != plan && count < dispatched_.size()) {
      simulation->dispatch(dispatched_[count++]);
    }
    if (simulation->plan().hash() != plan) throw InputError({}, "was saved with another plan");
    simulation->restore(state);
    dispatched_.resize(count);
    take(std::move(simulation));
  } catch (const Archive::Mismatch& error) {
    throw InputError({}, fmt::format("is not what sim:save wrote: {}", error.what()));
  }
  std::erase_if(notes_, [&](const NoteRow& row) { return row.time > now(); });
  told_.clear();
  told_warnings_ = 0;
  take_news();  // what had come until then was told
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
  record->finish(files_, *simulation_, wall.count());
}

}  // namespace lsos
