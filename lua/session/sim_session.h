// An interactive simulation of a prompt or a scenario. It can be stepped, queried and changed
// between exchanges, and leaves the files of a run.
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

// What a session works on.
struct SessionParts {
  PlanSource source;
  MissionFiles files;
  std::unique_ptr<RunFolder> folder;
  std::unique_ptr<Simulation> simulation;
  std::unique_ptr<RunRecord> record;
  std::vector<SourcePlacemark> dispatched;  // events added by it
};

class SimSession {
 public:
  // `folder`: folder of its log, replaced if it exists. Throws InputError with all faults.
  SimSession(PlanSource source, std::shared_ptr<const Catalog> catalog, const std::string& folder);
  // Takes over a mission that runs.
  explicit SimSession(SessionParts parts);
  // Writes the rest of the log, unless finish() or release() was called.
  ~SimSession();
  SimSession(const SimSession&) = delete;
  SimSession& operator=(const SimSession&) = delete;

  Simulation& simulation() { return *simulation_; }
  const MissionFiles& files() const { return files_; }
  const std::string& folder() const { return folder_->path(); }
  // The notes so far; of 64 MiB and more the first.
  const std::vector<NoteRow>& notes() const { return notes_; }
  bool has_all_notes() const { return note_bytes_ < note_bytes_max; }
  // Failures and warnings since the last call, one text each.
  std::vector<std::string> take_news();
  SimTime now() const { return simulation_->now(); }

  // Advances by `count` exchanges: 0.1 s each while something moves, else to the next time that
  // something happens. This and the next four end with the mission.
  void step(std::int64_t count);
  void run_for(double duration_s);
  // Evaluates `is_enough` after each exchange, and at whole seconds over quiet time. Returns false
  // when the limit is reached first.
  bool run_until(const std::function<bool()>& is_enough, double limit_s);
  void run();
  // Advances until a rover has entered another phase.
  void step_phase();

  // Adds an event. The Placemark has fields as a plan has them; without a Sequence the next free
  // one is used. Returns its Sequence. Throws InputError.
  std::int64_t dispatch(const std::string& rover_id, SourcePlacemark placemark);
  // Reads the catalog anew; changed scripts are called from the next phase on. Throws InputError
  // and then leaves everything unchanged.
  void reload();
  // Continues on another soil, rocks excepted. Throws as reload().
  void set_soil(const std::string& name);
  // First bytes of a saved session, before the version number of its format.
  static constexpr std::string_view saved_mark = "lsos-host session";
  std::string save();
  // Restores a saved session of the same plan. The log begins anew from there. Throws InputError
  // and then leaves everything unchanged.
  void load(const std::string& bytes);
  // Commits the log, so that the file contains all rows so far.
  void commit_log();
  // Ends the simulation: events under way are incomplete.
  void finish();

  // Gives its parts away; the session is of no use afterwards.
  SessionParts release();

  // Called by a signal handler: a running simulation ends with std::runtime_error at the next
  // exchange.
  static void interrupt();
  static void forget_interrupt();

 private:
  MissionFiles files_with(const std::string& soil, std::shared_ptr<const Catalog> catalog) const;
  // Constructs a simulation of these files with the dispatched events.
  std::unique_ptr<Simulation> make_simulation(const MissionFiles& files, bool plans_ahead,
                                              const std::vector<SourcePlacemark>& dispatched) const;
  // Replaces the simulation, in the same log or a new one.
  void replace_simulation(std::unique_ptr<Simulation> simulation, bool begins_log);
  // Continues from the present state with other files.
  void continue_with(MissionFiles files, bool plans_ahead);
  void advance(std::optional<SimTime> until = {});
  std::vector<std::string> phases() const;

  PlanSource source_;
  MissionFiles files_;
  std::unique_ptr<RunFolder> folder_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<RunRecord> record_;
  bool begins_log_ = true;  // its log begins with it
  // Sequences of the events dispatched to a rover.
  std::set<std::int64_t> dispatched_to(const std::string& rover_id) const;

  std::vector<SourcePlacemark> dispatched_;
  void keep(const NoteRow& note);

  static constexpr std::size_t note_bytes_max = std::size_t{64} << 20;
  std::vector<NoteRow> notes_;
  std::size_t note_bytes_ = 0;
  std::set<std::string> reported_;  // reported failed events, by rover and sequence
  std::size_t reported_warnings_ = 0;
};

}  // namespace lsos
