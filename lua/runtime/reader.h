// Reads the table that a script gives to a constructor into a struct. Each key is named once, with
// its range and meaning; its unit is its suffix. The same code reads tables and, without a table,
// lists the keys for lua/README.md.
//
//   void read(TableReader& t, Wheel& wheel) {
//     t.number(required, "radius_m", wheel.radius_m, positive, "Rolling radius.");
//   }
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <lua.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/vector.h"
#include "lua/runtime/constructed_value.h"

namespace lsos {

// Range of a key's number, in SI.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool is_above_min = false;  // min itself is not allowed
};
inline constexpr Range any_number{};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range not_negative{0};
inline constexpr Range fraction{0, 1};

enum Need { optional, required };

// A key as the documentation shows it.
struct KeyDoc {
  std::string key;
  std::string type;  // "number, m, above 0"
  bool is_required;
  std::string doc;
};

class TableReader {
 public:
  // Faults are collected as "WHAT: ..." at `place`. `what`: name of the constructor, "wheel".
  TableReader(lua_State* L, int index, std::string what, Place place, Faults& faults);
  // Reads no table; lists the keys.
  explicit TableReader(std::vector<KeyDoc>& keys);

  void number(Need, const char* key, std::optional<double>& value, const Range&, const char* doc);
  void integer(Need, const char* key, std::optional<std::int64_t>& value, const Range&,
               const char* doc);
  void boolean(Need, const char* key, std::optional<bool>& value, const char* doc);
  void text(Need, const char* key, std::optional<std::string>& value, const char* doc);
  void vec3(Need, const char* key, std::optional<Vec3>& value, const char* doc);
  // Overloads for members with a default of their own, which stays when the key is absent or wrong.
  void number(Need need, const char* key, double& value, const Range& range, const char* doc) {
    assign(value, [&](auto& found) { number(need, key, found, range, doc); });
  }
  void integer(Need need, const char* key, std::int64_t& value, const Range& range,
               const char* doc) {
    assign(value, [&](auto& found) { integer(need, key, found, range, doc); });
  }
  void boolean(Need need, const char* key, bool& value, const char* doc) {
    assign(value, [&](auto& found) { boolean(need, key, found, doc); });
  }
  void text(Need need, const char* key, std::string& value, const char* doc) {
    assign(value, [&](auto& found) { text(need, key, found, doc); });
  }
  void vec3(Need need, const char* key, Vec3& value, const char* doc) {
    assign(value, [&](auto& found) { vec3(need, key, found, doc); });
  }
  // A key whose text is one of some words; each word maps to a value.
  template <class T, std::size_t count>
  void word(Need need, const char* key, const std::pair<const char*, T> (&words)[count], T& value,
            const char* doc) {
    std::optional<std::string> found;
    text(need, key, found, doc);
    if (!found) return;
    std::vector<std::string> names;
    for (const auto& [name, meaning] : words) {
      if (*found == name) value = meaning;
      names.push_back(name);
    }
    check_word(key, *found, names);
  }
  void numbers(Need, const char* key, std::vector<double>& value, const Range&, const char* doc);
  // A required list must not be empty.
  void texts(Need, const char* key, std::vector<std::string>& value, const char* doc);
  // Reads api = 1.
  void api_version();

  // Reads a value made by the constructor lsos.KIND; leaves `value` unchanged when the key is
  // absent or the value is of another kind.
  template <class T>
  void made(Need need, const char* key, const char* kind, T& value, const char* doc) {
    if (const ConstructedValue* found = constructed_value(need, key, kind, doc))
      value = std::any_cast<T>(found->value);
  }
  // Reads an array of such values.
  template <class T>
  void list(Need need, const char* key, const char* kind, std::vector<T>& value, const char* doc) {
    constructed_list(need, key, kind, doc, [&](const ConstructedValue& found) {
      value.push_back(std::any_cast<T>(found.value));
    });
  }

  // For types without a function above: pushes the key's value (nil when absent) and returns true;
  // without a table it pushes nothing and returns false. The key then counts as known. The table is
  // read raw, since its metatables could run a script outside its budgets.
  bool take(Need need, const char* key, const char* type, const char* doc);

  // Whether a name of the script can stand in logs and pages; adds a fault where it cannot.
  bool check_name(const char* what, std::string_view name);

  // Adds the fault "WHAT: text".
  void fault(const std::string& text);
  // Adds a fault for each key of the table that was not read.
  void finish();

  lua_State* L() const { return L_; }
  const Place& place() const { return place_; }
  const std::string& what() const { return what_; }

 private:
  template <class T, class F>
  static void assign(T& value, F&& read) {
    std::optional<T> found;
    read(found);
    if (found) value = std::move(*found);
  }
  bool get(Need need, const char* key, const std::string& type, const char* doc, int lua_type,
           const char* wanted);
  bool check(const char* key, double value, const Range& range);
  void check_word(const char* key, const std::string& word, const std::vector<std::string>& names);
  const ConstructedValue* constructed_value(Need need, const char* key, const char* kind,
                                            const char* doc);
  void constructed_list(Need need, const char* key, const char* kind, const char* doc,
                        const std::function<void(const ConstructedValue&)>& add);

  lua_State* L_ = nullptr;
  int index_ = 0;
  int fault_count_ = 0;
  std::string what_;
  Place place_;
  Faults* faults_ = nullptr;
  std::vector<KeyDoc>* keys_ = nullptr;
  std::vector<std::string> known_;
};

// The text at `index`, zero bytes and all.
std::string text_at(lua_State* L, int index);

// Faults of the script that is loading. Throws std::runtime_error when none is loading: "lsos.wheel
// works only while a script loads".
Faults& load_faults(lua_State* L, const char* constructor);

// "; did you mean 'speed_mps'?" for 'speed': a key whose unit was left out, else the nearest key.
std::string suggest_key(std::string_view key, std::span<const std::string> known);

// Unit in a key's suffix: "m/s" for "speed_mps", "" for none.
std::string si_unit_of(std::string_view key);

}  // namespace lsos
