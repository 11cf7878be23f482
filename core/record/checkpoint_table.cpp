#include "record/checkpoint_table.h"

#include <fmt/format.h>

#include "base/archive.h"
#include "base/sha256.h"

namespace lsos::gpkg {

namespace {

// How many of the recent ones stay, in case that the last cannot be read.
constexpr int recent_count = 3;

constexpr const char* parts_table = "lsos_checkpoint_parts";

const char* const kinds[] = {"recent", "kept", "stop"};

std::optional<CheckpointKind> kind_of(const std::string& text) {
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

bool has_table(GDALDataset& dataset, const char* name = "lsos_checkpoints") {
  bool is_there = false;
  run_sql(dataset,
          fmt::format("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = '{}'", name),
          [&](const OGRFeature&) { is_there = true; });
  return is_there;
}

void append_content(const OGRFeature& row, int field, std::string& bytes) {
  int size = 0;
  const GByte* content = row.GetFieldAsBinary(field, &size);
  if (content == nullptr) return;
  bytes.append(reinterpret_cast<const char*>(content), static_cast<std::size_t>(size));
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
  if (!has_table(dataset, parts_table)) return;
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
  if (!has_table(dataset)) return;
  run_sql(dataset, "DELETE FROM lsos_checkpoints WHERE kind <> 'kept'");
  remove_parts_of_none(dataset);
  if (!checkpoint_entries(dataset).empty()) return;
  run_sql(dataset, "DROP TABLE lsos_checkpoints");
  run_sql(dataset, fmt::format("DROP TABLE IF EXISTS {}", parts_table));
}

void remove_checkpoints_after(GDALDataset& dataset, std::int64_t id) {
  run_sql(dataset, fmt::format("DELETE FROM lsos_checkpoints WHERE id > {}", id));
  remove_parts_of_none(dataset);
}

std::vector<CheckpointEntry> checkpoint_entries(GDALDataset& dataset) {
  std::vector<CheckpointEntry> entries;
  if (!has_table(dataset)) return entries;
  run_sql(
      dataset, "SELECT id, time_us, kind FROM lsos_checkpoints ORDER BY id",
      [&](const OGRFeature& row) {
        const auto kind = kind_of(row.GetFieldAsString(2));
        if (!kind) return;
        entries.push_back({row.GetFieldAsInteger64(0), SimTime{row.GetFieldAsInteger64(1)}, *kind});
      });
  return entries;
}

std::optional<StoredCheckpoint> read_checkpoint(GDALDataset& dataset, std::int64_t id) {
  std::string sha256, bytes;
  run_sql(dataset, fmt::format("SELECT sha256, content FROM lsos_checkpoints WHERE id = {}", id),
          [&](const OGRFeature& row) {
            sha256 = row.GetFieldAsString(0);
            append_content(row, 1, bytes);
          });
  if (bytes.empty() && !sha256.empty() && has_table(dataset, parts_table)) {
    run_sql(
        dataset,
        fmt::format("SELECT content FROM {} WHERE checkpoint = {} ORDER BY part", parts_table, id),
        [&](const OGRFeature& row) { append_content(row, 0, bytes); });
  }
  if (bytes.empty() || sha256_hex(bytes) != sha256) return {};
  try {
    StoredCheckpoint checkpoint;
    Archive a = Archive::reader(bytes);
    LSOS_ARCHIVE(a, checkpoint.time, checkpoint.kind, checkpoint.wall_s, checkpoint.last_fids,
                 checkpoint.state);
    if (!a.is_exhausted()) return {};
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
                               quoted(origin.folder), quoted(origin.log_sha256),
                               origin.time.count(), quoted(origin.changes)));
}

std::optional<BranchOrigin> read_branch(GDALDataset& dataset) {
  std::optional<BranchOrigin> origin;
  if (!has_table(dataset, "lsos_branch")) return origin;
  run_sql(dataset, "SELECT folder, log_sha256, time_us, changes FROM lsos_branch",
          [&](const OGRFeature& row) {
            origin = {row.GetFieldAsString(0), row.GetFieldAsString(1),
                      SimTime{row.GetFieldAsInteger64(2)}, row.GetFieldAsString(3)};
          });
  return origin;
}

}  // namespace lsos::gpkg
