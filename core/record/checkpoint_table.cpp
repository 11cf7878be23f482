#include "record/checkpoint_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/archive.h"
#include "base/error.h"
#include "base/sha256.h"
#include "base/utf8.h"
#include "record/columns.h"
#include "record/log_cells.h"

namespace lsos::gpkg {

namespace {

// How many of the recent ones stay, in case that the last cannot be read.
constexpr int recent_count = 3;

constexpr const char* parts_table = "lsos_checkpoint_parts";

const char* const kinds[] = {"recent", "kept", "stop"};

std::optional<CheckpointKind> kind_of(std::string_view text) {
  for (int k = 0; k < 3; ++k) {
    if (text == kinds[k]) return static_cast<CheckpointKind>(k);
  }
  return {};
}

// Bytes of a checkpoint that one statement holds. A statement is written out and copied several
// times on its way, so that a state of 100 MB, as scripts may have, took 1.5 GB.
constexpr std::size_t part_bytes = std::size_t{4} << 20;

// All of it in one block of bytes, so that one hash guards it.
std::string bytes_of(StoredCheckpoint& checkpoint) {
  Archive a = Archive::writer();
  LSOS_ARCHIVE(a, checkpoint.time, checkpoint.kind, checkpoint.wall_s, checkpoint.last_fids,
               checkpoint.state);
  return a.bytes();
}

std::string hex(std::string_view bytes) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

bool holds_table(GDALDataset& dataset, const char* name) {
  bool is_any = false;
  run_sql(dataset,
          fmt::format("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = '{}'", name),
          [&](const OGRFeature&) { is_any = true; });
  return is_any;
}

bool has_checkpoints(GDALDataset& dataset, const char* which = "") {
  if (!holds_table(dataset, "lsos_checkpoints")) return false;
  if (*which == '\0') return true;
  bool is_any = false;
  run_sql(dataset, fmt::format("SELECT 1 FROM lsos_checkpoints {} LIMIT 1", which),
          [&](const OGRFeature&) { is_any = true; });
  return is_any;
}

// A moment of a mission, counted in microseconds.
bool is_time(std::int64_t time_us) {
  return time_us >= 0 && seconds(SimTime{time_us}) <= time_max_s;
}

[[noreturn]] void refuse_row(const sqlite::Database& database, const char* table, std::int64_t id) {
  throw InputError(
      {database.file()},
      fmt::format("table '{}', id {}: holds what lsos-host does not write", table, id));
}

// The bytes of the last checkpoint, which are too many for its own row.
void add_parts(GDALDataset& dataset, std::string_view bytes) {
  run_sql(dataset,
          fmt::format("CREATE TABLE IF NOT EXISTS {} (checkpoint INTEGER NOT NULL, part INTEGER "
                      "NOT NULL, content BLOB NOT NULL, PRIMARY KEY (checkpoint, part))",
                      parts_table));
  for (std::size_t part = 0; part * part_bytes < bytes.size(); ++part) {
    run_sql(dataset,
            fmt::format("INSERT INTO {} SELECT max(id), {}, X'{}' FROM lsos_checkpoints",
                        parts_table, part, hex(bytes.substr(part * part_bytes, part_bytes))));
  }
}

void remove_parts_of_none(GDALDataset& dataset) {
  if (!holds_table(dataset, parts_table)) return;
  run_sql(dataset, fmt::format("DELETE FROM {} WHERE checkpoint NOT IN (SELECT id FROM "
                               "lsos_checkpoints)",
                               parts_table));
}

}  // namespace

void make_checkpoint_table(GDALDataset& dataset) {
  run_sql(dataset,
          "CREATE TABLE IF NOT EXISTS lsos_checkpoints (id INTEGER PRIMARY KEY AUTOINCREMENT, "
          "time_us INTEGER NOT NULL, kind TEXT NOT NULL, sha256 TEXT NOT NULL, content BLOB NOT "
          "NULL)");
}

void add_checkpoint(GDALDataset& dataset, StoredCheckpoint& checkpoint) {
  const std::string bytes = bytes_of(checkpoint);
  const bool has_parts = bytes.size() > part_bytes;
  run_sql(dataset,
          fmt::format("INSERT INTO lsos_checkpoints (time_us, kind, sha256, content) VALUES ({}, "
                      "'{}', '{}', X'{}')",
                      checkpoint.time.count(), kinds[static_cast<int>(checkpoint.kind)],
                      sha256_hex(bytes), has_parts ? "" : hex(bytes)));
  if (has_parts) add_parts(dataset, bytes);
  run_sql(dataset, fmt::format("DELETE FROM lsos_checkpoints WHERE kind = 'recent' AND id NOT IN "
                               "(SELECT id FROM lsos_checkpoints WHERE kind = 'recent' ORDER BY "
                               "id DESC LIMIT {})",
                               recent_count));
  remove_parts_of_none(dataset);
}

void remove_passing_checkpoints(GDALDataset& dataset) {
  if (!has_checkpoints(dataset)) return;
  run_sql(dataset, "DELETE FROM lsos_checkpoints WHERE kind <> 'kept'");
  remove_parts_of_none(dataset);
  if (has_checkpoints(dataset, "WHERE kind = 'kept'")) return;
  run_sql(dataset, "DROP TABLE lsos_checkpoints");
  run_sql(dataset, fmt::format("DROP TABLE IF EXISTS {}", parts_table));
}

void remove_checkpoints_after(GDALDataset& dataset, std::int64_t id) {
  run_sql(dataset, fmt::format("DELETE FROM lsos_checkpoints WHERE id > {}", id));
  remove_parts_of_none(dataset);
}

std::vector<CheckpointEntry> checkpoint_entries(const sqlite::Database& database) {
  std::vector<CheckpointEntry> entries;
  if (!has_table(database, "lsos_checkpoints")) return entries;
  sqlite::Query query(database, "SELECT id, time_us, kind FROM lsos_checkpoints ORDER BY id");
  while (query.next()) {
    const std::int64_t id = query.integer(0), time_us = query.integer(1);
    const auto kind = kind_of(query.text(2));
    const bool is_early = !entries.empty() && SimTime{time_us} < entries.back().time;
    if (query.kind(1) != sqlite::CellKind::integer || !is_time(time_us) || is_early || !kind) {
      refuse_row(database, "lsos_checkpoints", id);
    }
    entries.push_back({id, SimTime{time_us}, *kind});
  }
  return entries;
}

std::optional<StoredCheckpoint> read_checkpoint(const sqlite::Database& database, std::int64_t id) {
  std::string sha256, bytes;
  {
    sqlite::Query query(
        database, fmt::format("SELECT sha256, content FROM lsos_checkpoints WHERE id = {}", id));
    if (!query.next()) return {};
    sha256 = query.text(0);
    bytes = query.blob(1);
  }
  if (bytes.empty() && !sha256.empty() && has_table(database, parts_table)) {
    sqlite::Query parts(
        database,
        fmt::format("SELECT content FROM {} WHERE checkpoint = {} ORDER BY part", parts_table, id));
    while (parts.next()) bytes += parts.blob(0);
  }
  if (bytes.empty() || sha256_hex(bytes) != sha256) return {};
  try {
    StoredCheckpoint checkpoint;
    Archive a = Archive::reader(bytes);
    LSOS_ARCHIVE(a, checkpoint.time, checkpoint.kind, checkpoint.wall_s, checkpoint.last_fids,
                 checkpoint.state);
    const bool is_whole = a.is_exhausted() && is_time(checkpoint.time.count()) &&
                          std::isfinite(checkpoint.wall_s) && checkpoint.wall_s >= 0;
    if (!is_whole || std::ranges::any_of(checkpoint.last_fids, [](auto fid) { return fid < 0; })) {
      return {};
    }
    return checkpoint;
  } catch (const Archive::Mismatch&) {
    return {};
  }
}

void write_branch(GDALDataset& dataset, const BranchOrigin& origin) {
  run_sql(dataset,
          "CREATE TABLE IF NOT EXISTS lsos_branch (id INTEGER PRIMARY KEY CHECK (id = 1), folder "
          "TEXT NOT NULL, log_sha256 TEXT NOT NULL, time_us INTEGER NOT NULL, changes "
          "TEXT NOT NULL)");
  run_sql(dataset, fmt::format("INSERT OR REPLACE INTO lsos_branch VALUES (1, {}, {}, {}, {})",
                               quoted(utf8_text(origin.folder)), quoted(origin.log_sha256),
                               origin.time.count(), quoted(utf8_text(origin.changes))));
}

std::optional<BranchOrigin> read_branch(const sqlite::Database& database) {
  if (!has_table(database, "lsos_branch")) return {};
  sqlite::Query query(database, "SELECT folder, log_sha256, time_us, changes FROM lsos_branch");
  if (!query.next()) return {};
  for (const int text : {0, 1, 3}) {
    const bool is_text = query.kind(text) == sqlite::CellKind::text && is_utf8(query.text(text));
    if (!is_text) refuse_row(database, "lsos_branch", 1);
  }
  if (query.kind(2) != sqlite::CellKind::integer || !is_time(query.integer(2))) {
    refuse_row(database, "lsos_branch", 1);
  }
  return BranchOrigin{std::string(query.text(0)), std::string(query.text(1)),
                      SimTime{query.integer(2)}, std::string(query.text(3))};
}

}  // namespace lsos::gpkg
