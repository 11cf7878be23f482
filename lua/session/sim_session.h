// A simulation in hand: of a prompt or a scenario. It is stepped, asked, changed between exchanges,
// and leaves what a run leaves.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lua/host/mission_reader.h"
#include "product/run_record.h"

namespace lsos {

class SimSession {
 public:
  // `folder`: of its log, replaced if it is there. Throws InputError with all that is wrong.
  SimSession(PlanSource source, std::shared_ptr<const Catalog> catalog, const std::string& folder);
  // Writes the rest of the log, if `finish` has not.
  ~SimSession();
  SimSession(const SimSession&) = delete;
  SimSession& operator=(const SimSession&) = delete;

  Simulation& simulation() { return *simulation_; }
  const MissionFiles& files() const { return files_; }
  const std::string& folder() const { return folder_.path(); }
  const std::vector<NoteRow>& notes() const { return notes_; }
  // What failed and what was warned of since this was last asked, a text each.
  std::vector<std::string> take_news();
  SimTime now() const { return simulation_->now(); }

  // So many exchanges: 0.1 s each while something moves, else to the next time that something
  // happens. All of these end with the mission.
  void step(std::int64_t count);
  void run_for(double duration_s);
  // Asks after each exchange, at whole seconds over quiet time. False: the limit came first.
  bool run_until(const std::function<bool()>& is_enough, double limit_s);
  void run();
  // Until a rover has entered another phase.
  void step_phase();

  // One more event. `fields` as a plan has them; the Sequence is the next that is free when absent.
  // Answers its Sequence. Throws InputError.
  std::int64_t dispatch(const std::string& rover_id, SourcePlacemark placemark);
  // Reads the catalog anew; what has changed is called from the next phase on. Throws InputError,
  // and all is as it was.
  void reload();
  // Goes on in another soil, rocks excepted. Throws as reload().
  void set_soil(const std::string& name);
  // What a saved one begins with, before the number of its form.
  static constexpr std::string_view saved_mark = "lsos-host session";
  std::string save();
  // Into the same plan. The log begins anew from there. Throws InputError, and all is as it was.
  void load(const std::string& bytes);
  // What has come so far is in the file then.
  void commit_log();
  // Ends it: events under way are incomplete.
  void finish();

  // Set by a signal: what runs ends with std::runtime_error at the next exchange.
  static void interrupt();
  static void forget_interrupt();

 private:
  MissionFiles files_with(const std::string& soil, std::shared_ptr<const Catalog> catalog) const;
  // Of these files, with what was dispatched.
  std::unique_ptr<Simulation> made(const MissionFiles& files, bool plans_ahead,
                                   const std::vector<SourcePlacemark>& dispatched) const;
  // Goes on with that in place of the one before, in the same log or a new one.
  void take(std::unique_ptr<Simulation> simulation, bool begins_log);
  // Goes on from where it is with other files.
  void go_on_with(MissionFiles files, bool plans_ahead);
  void advance(std::optional<SimTime> until = {});
  std::vector<std::string> phases() const;

  PlanSource source_;
  MissionFiles files_;
  RunFolder folder_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<RunRecord> record_;
  // Sequences.
  std::set<std::int64_t> dispatched_to(const std::string& rover_id) const;

  std::vector<SourcePlacemark> dispatched_;
  std::vector<NoteRow> notes_;
  std::set<std::string> told_;  // failed events, by rover and sequence
  std::size_t told_warnings_ = 0;
};

}  // namespace lsos
