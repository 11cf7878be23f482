// The log of a run: one GeoPackage that other programs can read at any moment.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/output_error.h"
#include "planet/utc.h"
#include "record/checkpoint.h"
#include "record/layers.h"
#include "record/rows.h"

namespace lsos {

// The key in layer `run` that holds the StartTime, in microseconds of TAI as in Instant. LogWriter
// writes it.
inline constexpr std::string_view start_key = "start_tai_us";

// The log cannot be written, e.g. on a full disk: the run must stop. Rows committed before stay
// readable.
class LogError : public OutputError {
  using OutputError::OutputError;
};

// Writes log.gpkg. All layers exist and are committed when the constructor returns; `commit_if_due`
// commits rows at least once per second of wall time. Fids count up from 1 in each layer, in the
// order of writing. Not thread-safe.
class LogWriter {
 public:
  // `file` must not exist. `crs`: as in Body. `start`: converts time_s to utc. All functions throw
  // LogError on failure, after which the file is closed in the state of the last commit.
  LogWriter(const std::string& file, const std::string& crs, Instant start);
  // Goes on with the log of a run that did not finish, from one of its checkpoints: rows and
  // checkpoints written after it are removed with the first commit.
  LogWriter(const std::string& file, Instant start, std::int64_t checkpoint_id);
  // Without `finish` the file stays in the state of the last commit.
  ~LogWriter();
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  void write(const SampleRow& row);
  void write(const JointRow& row);
  void write(const PanelRow& row);
  void write(const PairRow& row);
  void write(const SightIntervalRow& row);
  void write(const ResourceRow& row);
  void write(const EventRow& row);  // updates the row of the same rover and sequence
  void write(const PhaseRow& row);
  void write(const PlannedPathRow& row);
  void write(const NoteRow& row);
  void write(const OrderRow& row);
  // Writes layer `run`, one row per key, which is updated when written again. Values must not
  // differ between two equal runs.
  void write_run(const std::map<std::string, std::string>& values);

  // Styles are not part of the digest.
  void write_styles(const std::vector<LayerStyle>& styles);

  // What numbers were too large for their column, or not finite, and are NULL in the log; "": none.
  std::string lost_numbers() const;

  // From now on a commit with which the file takes more than that throws LogError.
  void limit_size(std::uintmax_t bytes);

  // Commits if the last commit is about a second of wall time old.
  void commit_if_due();
  void commit();
  // Commits the rows so far and this checkpoint at once.
  void write(const Checkpoint& checkpoint);

  // Begins a branch: removes the checkpoints of the run whose log this is a copy of, and writes
  // where it was left, in an internal table.
  void begin_branch(const BranchOrigin& origin);

  // Removes the rows of events that are not among these, each a rover and a Sequence.
  void keep_events(const std::set<std::pair<std::string, std::int64_t>>& events);

  // Commits all, folds the write-ahead log into the one file and closes it. If another program has
  // the file open at that time, the write-ahead log is removed when that program closes it. Of the
  // checkpoints only the kept ones stay, unless the run `can_resume`.
  void finish(bool can_resume = false);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// A row of any layer, as it enters the digest.
struct LogRow {
  std::int64_t fid = 0;
  std::vector<ColumnValue> values;  // in the order of the layer's columns
  std::string geometry;             // ISO WKB; "" is NULL
};

// Speed above which a rover counts as moving.
inline constexpr double moving_mps = 1e-3;

// Totals of one rover's samples.
struct SampleTotals {
  std::size_t rows = 0, moving = 0;  // moving: those above moving_mps
  double distance_m = 0;             // greatest distance driven
};

// A closed interval.
struct TimeSpan {
  SimTime from = SimTime::min(), to = SimTime::max();
};

// Reads the log of a finished, running or killed run. Rows come in fid order.
class LogReader {
 public:
  explicit LogReader(const std::string& file);  // throws InputError if it is no log
  ~LogReader();

  std::vector<SampleRow> samples() const;
  std::vector<JointRow> joints() const;
  std::vector<PanelRow> panels() const;
  std::vector<PairRow> pairs() const;
  std::vector<SightIntervalRow> sight_intervals() const;
  std::vector<ResourceRow> resources() const;
  std::vector<EventRow> events() const;
  std::vector<PhaseRow> phases() const;
  std::vector<PlannedPathRow> planned_paths() const;
  std::vector<NoteRow> notes() const;
  std::vector<OrderRow> orders() const;  // none in a log of an older version
  // One row at a time, so that the rows of weeks need not fit into memory.
  void for_each_sample(const std::function<void(const SampleRow&)>& visit) const;
  void for_each_joint(const std::function<void(const JointRow&)>& visit,
                      const TimeSpan& within = {}) const;
  void for_each_panel(const std::function<void(const PanelRow&)>& visit,
                      const TimeSpan& within = {}) const;
  void for_each_pair(const std::function<void(const PairRow&)>& visit) const;
  void for_each_sight_interval(const std::function<void(const SightIntervalRow&)>& visit) const;
  void for_each_resource(const std::function<void(const ResourceRow&)>& visit,
                         const TimeSpan& within = {}) const;
  void for_each_planned_path(const std::function<void(const PlannedPathRow&)>& visit) const;
  void for_each_note(const std::function<void(const NoteRow&)>& visit) const;
  // False if the run was killed before its first sample.
  bool has_samples() const;
  // Keyed by rover id.
  std::map<std::string, SampleTotals> sample_totals() const;
  // Number of rows of a layer of the contract.
  std::size_t row_count(std::string_view layer) const;
  // Number of rows of the pair that has most.
  std::size_t pair_count() const;
  using NoteKind = std::pair<std::string, std::string>;  // rover_id, name
  struct NoteCounts {
    std::size_t in_all = 0;
    // Empty if there are more than kinds_max, or one with a name of more than 200 characters.
    std::map<NoteKind, std::size_t> by_kind;
  };
  NoteCounts note_counts(std::size_t kinds_max) const;
  // The rows of a layer that follow `fid`, at most `count`, in fid order; fewer where they are
  // large, but at least one where there is one.
  std::vector<LogRow> rows_after(std::string_view layer, std::int64_t fid, std::size_t count) const;
  // Time of the row that was written last; 0 if there is none.
  SimTime last_sample_time() const;
  std::map<std::string, std::string> run() const;
  Instant start() const;
  // Oldest first.
  std::vector<CheckpointEntry> checkpoints() const;
  // Throws InputError where it is damaged.
  StoredCheckpoint checkpoint(std::int64_t id) const;
  // Where the run left another one; absent: it is no branch.
  std::optional<BranchOrigin> branch() const;
  // Writes all of the log into a new file. Throws InputError.
  void copy_to(const std::string& file) const;

  // SHA-256 over all layers of the contract in fixed order, rows in fid order, each value with its
  // type: equal for equal runs.
  std::string sha256() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lsos
