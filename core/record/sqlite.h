// A thin wrapper of SQLite, to read logs: it tells what each cell holds, where GDAL takes a text in
// a column of numbers for 0. Only for use in this folder.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace lsos::sqlite {

// A database that is open to be read. It may come from anyone: views and triggers are off, its
// schema may call no function that reaches out of it, no extension is loaded, and damaged pages are
// errors. All functions throw InputError, which names the file.
class Database {
 public:
  explicit Database(const std::string& file);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  const std::string& file() const { return file_; }
  // Runs a statement without results.
  void run(const std::string& statement) const;

 private:
  friend class Query;

  bool open(const std::string& name, int flags);
  [[noreturn]] void fail() const;

  std::string file_;
  sqlite3* handle_ = nullptr;
};

// A handle of SQLite that somebody else opened, such as GDAL, to write: the same precautions.
void harden(sqlite3* handle);

enum class CellKind { null, integer, real, text, blob };

// The rows of one statement. Texts and blobs stay valid until the next row.
class Query {
 public:
  Query(const Database& database, const std::string& statement);
  ~Query();
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  // Goes to the first, or the next, row; false: there is none.
  bool next();

  CellKind kind(int column) const;
  // Converted as SQLite does where the cell is of another kind; 0 or "" for NULL.
  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string_view text(int column) const;
  std::string_view blob(int column) const;

 private:
  const Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

}  // namespace lsos::sqlite
