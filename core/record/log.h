// The log of a run: one GeoPackage that other programs can read at any moment.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/output_error.h"
#include "planet/utc.h"
#include "record/layers.h"
#include "record/rows.h"

namespace lsos {

// The key in layer `run` that holds the StartTime, microseconds of TAI as in Instant. Written by
// LogWriter itself.
inline constexpr std::string_view start_key = "start_tai_us";

// The log could not be written (a full disk): the run must stop. What was committed before stays
// readable.
class LogError : public OutputError {
  using OutputError::OutputError;
};

// Writes log.gpkg. All layers exist and are committed before the constructor returns; rows are
// committed at least once a wall second by `commit_if_due`. Fids count up from 1 in each layer,
// in order of writing. Not for use from two threads.
class LogWriter {
 public:
  // `file` must not exist. `crs` as in Body; `start` turns time_s into utc. All functions throw
  // LogError; after one the file is closed as the last commit left it.
  LogWriter(const std::string& file, const std::string& crs, Instant start);
  // Without `finish` the file stays as the last commit left it.
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
  // Layer `run`, a row a key, updated when written again; nothing that differs between two equal
  // runs.
  void write_run(const std::map<std::string, std::string>& values);

  // No part of the digest.
  void write_styles(const std::vector<LayerStyle>& styles);

  // Commits when the last commit is a wall second old.
  void commit_if_due();
  void commit();

  // Commits all, folds the write-ahead log into the one file and closes it. Where another program
  // has the file open just then, that program's closing removes the write-ahead log.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// A row of any layer, as the digest has it.
struct LogRow {
  std::int64_t fid = 0;
  std::vector<ColumnValue> values;  // in the order of the layer's columns
  std::string geometry;             // ISO WKB; "" is NULL
};

// Faster than this a rover moves.
inline constexpr double moving_mps = 1e-3;

// What the samples of one rover come to.
struct SampleTotals {
  std::size_t rows = 0, moving = 0;  // those in which it moves
  double distance_m = 0;             // driven at the last
};

// Both ends belong to it.
struct TimeSpan {
  SimTime from = SimTime::min(), to = SimTime::max();
};

// Reads a log back, of a finished, running or killed run. Rows in fid order.
class LogReader {
 public:
  explicit LogReader(const std::string& file);  // throws InputError when it is no log of ours
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
  // One row at a time: weeks of them need not fit into memory.
  void for_each_sample(const std::function<void(const SampleRow&)>& visit) const;
  void for_each_joint(const std::function<void(const JointRow&)>& visit,
                      const TimeSpan& within = {}) const;
  void for_each_panel(const std::function<void(const PanelRow&)>& visit,
                      const TimeSpan& within = {}) const;
  void for_each_pair(const std::function<void(const PairRow&)>& visit) const;
  void for_each_note(const std::function<void(const NoteRow&)>& visit) const;
  // False of a run that was killed before its first.
  bool has_samples() const;
  // By rover.
  std::map<std::string, SampleTotals> sample_totals() const;
  // Rows of the pair that has most.
  std::size_t pair_count() const;
  using NoteKind = std::pair<std::string, std::string>;  // rover_id, name
  struct NoteCounts {
    std::size_t in_all = 0;
    std::map<NoteKind, std::size_t> by_kind;  // empty where there are more than were asked for
  };
  NoteCounts note_counts(std::size_t kinds_max) const;
  // The next rows of a layer of the contract, `count` at most, in fid order.
  std::vector<LogRow> rows_after(std::string_view layer, std::int64_t fid, std::size_t count) const;
  // Of the row that was written last; 0 when there is none.
  SimTime last_sample_time() const;
  std::map<std::string, std::string> run() const;
  Instant start() const;

  // SHA-256 over all layers of the contract in fixed order, rows in fid order, every value with
  // its type: equal for equal runs.
  std::string sha256() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lsos
