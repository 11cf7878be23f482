#include "system/mutations.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <regex>
#include <utility>
#include <vector>

#include "base/sha256.h"
#include "record/layers.h"

namespace lsos::test {

namespace {

constexpr std::size_t hash_bytes = 64;

template <class List>
auto one_of(const List& list, Random& random) {
  return list[any(random, std::size(list))];
}

// Replaces what stands in one of the groups 1 that the pattern finds.
std::string with_value(const std::string& text, const std::regex& pattern, const std::string& value,
                       Random& random) {
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), pattern);
       at != std::sregex_iterator(); ++at) {
    places.emplace_back(at->position(1), at->length(1));
  }
  if (places.empty()) return text;
  const auto [begin, size] = one_of(places, random);
  return text.substr(0, begin) + value + text.substr(begin + size);
}

constexpr std::array odd_texts{"",
                               " ",
                               "0",
                               "-1",
                               "nan",
                               "inf",
                               "1e308",
                               "-1e-320",
                               "99999999999999999999",
                               "0x7fffffff",
                               "1 km/h",
                               "50 %",
                               "PT1H",
                               "2026-02-30T25:00:00Z",
                               "2099-12-31T23:59:59Z",
                               "1960-01-01",
                               "Earth",
                               "Mars",
                               "SEV1/10",
                               "goto Pause 20",
                               "charge < 0.5 and",
                               "((((((((((((((((((",
                               "../../etc/passwd",
                               "/dev/zero",
                               "MER",
                               "ATHLETE",
                               "\xff\xfe",
                               "&#0;",
                               "\xe2\x80\xae",
                               "0,90 180,-90",
                               "0,0 0,0 0,0",
                               "1e9,1e9",
                               "true",
                               "<x/>"};

constexpr std::array odd_cells{"NULL",
                               "0",
                               "-1",
                               "1",
                               "9e999",
                               "-9e999",
                               "1e300",
                               "-1e19",
                               "9223372036854775807",
                               "1e9",
                               "''",
                               "x''",
                               "x'ff00'",
                               "'fast'",
                               "CAST(x'c328' AS TEXT)",
                               "'A' || char(0) || 'B'",
                               "'{\"a\":'",
                               "'{\"what\":1,\"mode\":2,\"part\":3,\"repair\":\"x\",\"share\":[]}'",
                               "replace(hex(zeroblob(500)), '00', '[')",
                               "hex(zeroblob(100000))",
                               "zeroblob(100000)",
                               "'completed'",
                               "'link'",
                               "'Earth'",
                               "'nobody'",
                               "char(27) || '[2J'",
                               "'</script><script>'",
                               "1e-320",
                               "179.9999999",
                               "90",
                               "3.0"};

constexpr std::array odd_tables{
    "DELETE FROM {0}",
    "DELETE FROM {0} WHERE fid % 2 = 0",
    "UPDATE {0} SET fid = fid + 1000000000000",
    "INSERT INTO {0} SELECT * FROM {0} WHERE 0",
    "DROP TABLE {0}",
    "ALTER TABLE {0} RENAME TO old; CREATE VIEW {0} AS SELECT * FROM old",
    "ALTER TABLE {0} ADD COLUMN more AS (fid * 2)",
    "CREATE TRIGGER t{0} AFTER UPDATE ON {0} BEGIN DELETE FROM run; END",
    "CREATE INDEX i{0} ON {0} (fid, fid)",
    "PRAGMA application_id = 7",
    "PRAGMA user_version = 1",
    "PRAGMA journal_mode = WAL",
    "DELETE FROM gpkg_contents",
    "DELETE FROM gpkg_geometry_columns",
    "UPDATE gpkg_spatial_ref_sys SET definition = 'x'",
    "UPDATE run SET value = '-5' WHERE fid = {1}",
    "DELETE FROM run WHERE fid = {1}",
    "UPDATE lsos_checkpoints SET time_us = time_us * 1000003",
    "UPDATE lsos_checkpoints SET content = x''"};

// The bytes are few and the changes many, or the other way round.
void change(std::string& bytes, Random& random) {
  if (bytes.empty()) return;
  const std::size_t at = any(random, bytes.size());
  switch (any(random, 6)) {
    case 0:
      bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1u << any(random, 8)));
      break;
    case 1:
      bytes[at] = static_cast<char>(any(random, 256));
      break;
    case 2:
      bytes.erase(at, any(random, 40));
      break;
    case 3:
      bytes.insert(at, bytes.substr(at, any(random, 40)));
      break;
    case 4: {
      constexpr std::array counts{0xffffffffffffffffULL, 0x7fffffffffffffffULL,
                                  0x7ff0000000000000ULL, 0x7ff8000000000000ULL,
                                  0x0000000100000000ULL, 0ULL};
      const auto number = one_of(counts, random);
      for (std::size_t k = 0; k < 8 && at + k < bytes.size(); ++k) {
        bytes[at + k] = static_cast<char>(number >> (8 * k));
      }
      break;
    }
    default:
      if (any(random, 10) == 0) bytes.resize(at);
  }
}

class Database {
 public:
  explicit Database(const std::filesystem::path& file) { sqlite3_open(file.c_str(), &handle_); }
  ~Database() { sqlite3_close(handle_); }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  void run(const std::string& sql) {
    sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
  }
  std::string blob(const std::string& sql) {
    sqlite3_stmt* statement = nullptr;
    std::string bytes;
    if (sqlite3_prepare_v2(handle_, sql.c_str(), -1, &statement, nullptr) == SQLITE_OK &&
        sqlite3_step(statement) == SQLITE_ROW) {
      bytes.assign(static_cast<const char*>(sqlite3_column_blob(statement, 0)),
                   static_cast<std::size_t>(sqlite3_column_bytes(statement, 0)));
    }
    sqlite3_finalize(statement);
    return bytes;
  }

 private:
  sqlite3* handle_ = nullptr;
};

std::string hex(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) text += fmt::format("{:02x}", static_cast<unsigned char>(c));
  return text;
}

}  // namespace

std::size_t any(Random& random, std::size_t count) { return random() % count; }

std::string mutated_bytes(std::string bytes, Random& random) {
  for (std::size_t k = 1 + any(random, 8); k > 0; --k) change(bytes, random);
  return bytes;
}

std::string mutated_kml(std::string kml, Random& random) {
  static const std::regex value("<(?:SimpleData|coordinates|name)[^>]*>([^<]*)<");
  static const std::regex attribute("=\"([^\"]*)\"");
  static const std::regex element(
      "(<Placemark>[^]*?</Placemark>|<SimpleData[^>]*>[^<]*</SimpleData>)");
  for (std::size_t k = 1 + any(random, 4); k > 0; --k) {
    switch (any(random, 8)) {
      case 0:
        kml = with_value(kml, attribute, one_of(odd_texts, random), random);
        break;
      case 1:
        kml = with_value(kml, element, "", random);
        break;
      case 2: {
        std::smatch found;
        if (!std::regex_search(kml, found, element)) break;
        kml = with_value(kml, element, found[1].str() + found[1].str(), random);
        break;
      }
      default:
        kml = with_value(kml, value, one_of(odd_texts, random), random);
    }
  }
  return kml;
}

std::string mutated_json(std::string json, Random& random) {
  static const std::regex value(":\\s*(\"[^\"]*\"|-?[0-9.e+-]+|null|true|false)");
  static const std::regex name("\"([a-z_0-9]+)\":");
  constexpr std::array odd{"null",
                           "0",
                           "-1",
                           "1e308",
                           "1e999",
                           "\"\"",
                           "[]",
                           "[[1]]",
                           "{}",
                           "true",
                           "\"x\"",
                           "99999999999999999999",
                           "[{\"a\":[{}]}]",
                           "\"\\u0000\""};
  for (std::size_t k = 1 + any(random, 4); k > 0; --k) {
    json = any(random, 5) == 0 ? with_value(json, name, "other", random)
                               : with_value(json, value, one_of(odd, random), random);
  }
  return json;
}

void mutate_cells(const std::filesystem::path& log, Random& random) {
  Database database(log);
  const auto& layers = contract_layers();
  for (std::size_t k = 1 + any(random, 3); k > 0; --k) {
    const LayerSpec& layer = layers[any(random, layers.size())];
    if (any(random, 5) == 0) {
      database.run(
          fmt::format(fmt::runtime(one_of(odd_tables, random)), layer.name, 1 + any(random, 12)));
      continue;
    }
    const std::size_t number = any(random, layer.columns.size() + 2);
    const std::string column = number < layer.columns.size()
                                   ? std::string(layer.columns[number].name)
                               : number == layer.columns.size() ? "geom"
                                                                : "fid";
    const std::string where =
        any(random, 3) == 0 ? "" : fmt::format(" WHERE fid = {}", 1 + any(random, 6));
    database.run(fmt::format("UPDATE {} SET \"{}\" = {}{}", layer.name, column,
                             one_of(odd_cells, random), where));
  }
}

void mutate_checkpoint(const std::filesystem::path& log, Random& random) {
  Database database(log);
  const std::string last = "(SELECT max(id) FROM lsos_checkpoints)";
  const std::string content = mutated_bytes(
      database.blob("SELECT content FROM lsos_checkpoints WHERE id = " + last), random);
  database.run(
      fmt::format("UPDATE lsos_checkpoints SET content = x'{}', sha256 = '{}' WHERE id = {}",
                  hex(content), sha256_hex(content), last));
}

std::string mutated_after_hash(const std::string& bytes, Random& random) {
  const std::size_t head = bytes.find('\n') + 1;
  if (bytes.size() < head + hash_bytes) return bytes;
  const std::string content = mutated_bytes(bytes.substr(head + hash_bytes), random);
  return bytes.substr(0, head) + sha256_hex(content) + content;
}

}  // namespace lsos::test
