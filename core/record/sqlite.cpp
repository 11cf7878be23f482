#include "record/sqlite.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>

#include "base/error.h"

namespace lsos::sqlite {

namespace {

constexpr int busy_ms = 10'000;  // while another program commits
// The most bytes of a cell or a row. A checkpoint holds all state of a mission.
constexpr int row_bytes_max = 512 << 20;

// A path that SQLite takes for no URI and no database in memory.
std::string absolute(const std::string& file) { return std::filesystem::absolute(file).string(); }

// A name that is a URI: the file, which nobody changes while it is read.
std::string unchanging(const std::string& file) {
  std::string uri = "file:";
  for (const char c : absolute(file)) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '/';
    uri += is_plain ? std::string(1, c) : fmt::format("%{:02x}", static_cast<unsigned char>(c));
  }
  return uri + "?immutable=1";
}

}  // namespace

void harden(sqlite3* handle) {
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0, nullptr);
  sqlite3_exec(handle, "PRAGMA cell_size_check = ON; PRAGMA mmap_size = 0", nullptr, nullptr,
               nullptr);
}

Database::Database(const std::string& file) : file_(file) {
  const int flags = SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX;
  if (open(absolute(file), flags)) return;
  // Where nothing can be written, a file in WAL mode is read as it is if it has no such log.
  std::error_code ignored;
  const bool has_wal = std::filesystem::exists(file + "-wal", ignored);
  if (sqlite3_errcode(handle_) == SQLITE_CANTOPEN && !has_wal) {
    sqlite3_close(handle_);
    if (open(unchanging(file), flags | SQLITE_OPEN_URI)) return;
  }
  const std::string why = handle_ == nullptr ? "no memory" : sqlite3_errmsg(handle_);
  sqlite3_close(handle_);
  throw InputError({file_}, fmt::format("no log of lsos-host: {}", why));
}

Database::~Database() {
  sqlite3_close(handle_);
  // One who may only read leaves a journal behind, though there is nothing in it. One who may write
  // takes it away.
  std::error_code missing;
  if (std::filesystem::file_size(file_ + "-wal", missing) != 0 || missing) return;
  sqlite3* writer = nullptr;
  if (sqlite3_open_v2(absolute(file_).c_str(), &writer, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX,
                      nullptr) == SQLITE_OK) {
    harden(writer);
    sqlite3_exec(writer, "SELECT count(*) FROM sqlite_master", nullptr, nullptr, nullptr);
  }
  sqlite3_close(writer);
}

bool Database::open(const std::string& name, int flags) {
  if (sqlite3_open_v2(name.c_str(), &handle_, flags, nullptr) != SQLITE_OK) return false;
  sqlite3_busy_timeout(handle_, busy_ms);
  sqlite3_limit(handle_, SQLITE_LIMIT_LENGTH, row_bytes_max);
  harden(handle_);
  // The file is looked at only now.
  return sqlite3_exec(handle_, "SELECT count(*) FROM sqlite_master", nullptr, nullptr, nullptr) ==
         SQLITE_OK;
}

void Database::fail() const {
  throw InputError({file_}, fmt::format("cannot be read: {}", sqlite3_errmsg(handle_)));
}

void Database::run(const std::string& statement) const {
  if (sqlite3_exec(handle_, statement.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

Query::Query(const Database& database, const std::string& statement) : database_(database) {
  if (sqlite3_prepare_v2(database.handle_, statement.c_str(), -1, &statement_, nullptr) !=
      SQLITE_OK) {
    database_.fail();
  }
}

Query::~Query() { sqlite3_finalize(statement_); }

bool Query::next() {
  const int result = sqlite3_step(statement_);
  if (result == SQLITE_ROW) return true;
  if (result != SQLITE_DONE) database_.fail();
  return false;
}

CellKind Query::kind(int column) const {
  switch (sqlite3_column_type(statement_, column)) {
    case SQLITE_INTEGER:
      return CellKind::integer;
    case SQLITE_FLOAT:
      return CellKind::real;
    case SQLITE_TEXT:
      return CellKind::text;
    case SQLITE_BLOB:
      return CellKind::blob;
    default:
      return CellKind::null;
  }
}

std::int64_t Query::integer(int column) const { return sqlite3_column_int64(statement_, column); }
double Query::real(int column) const { return sqlite3_column_double(statement_, column); }

std::string_view Query::text(int column) const {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return {text, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

std::string_view Query::blob(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_, column));
  return {bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
}

}  // namespace lsos::sqlite
