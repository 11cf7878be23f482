#include "lua/runtime/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/units.h"
#include "base/utf8.h"
#include "base/visible_text.h"
#include "lua/runtime/context.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"
#include "lua/runtime/vec3.h"

namespace lsos {

namespace {

constexpr std::int64_t api_version_min = 1, api_version_max = 1;

// Suffixes of units that have no symbol in plans.
constexpr std::pair<std::string_view, std::string_view> compound_units[] = {
    {"_npm", "N/m"},    {"_nspm", "N s/m"}, {"_n_m_prad", "N m/rad"}, {"_n_m_sprad", "N m s/rad"},
    {"_kgm2", "kg m2"}, {"_pm2", "1/m2"},   {"_w_pn2m2", "W/(N m)^2"}};

constexpr std::int64_t instructions_per_key = 10;
constexpr int faults_max = 50;  // of one table

std::string range_text(const Range& range, const std::string& unit) {
  const std::string u = unit.empty() ? "" : " " + unit;
  if (std::isfinite(range.min) && std::isfinite(range.max)) {
    return range.is_above_min
               ? fmt::format("more than {} and at most {}{}", range.min, range.max, u)
               : fmt::format("{}..{}{}", range.min, range.max, u);
  }
  if (std::isfinite(range.min)) {
    return fmt::format("{} {}{}", range.is_above_min ? "more than" : "at least", range.min, u);
  }
  return std::isfinite(range.max) ? fmt::format("at most {}{}", range.max, u) : "";
}

std::string type_text(const char* type, const char* key, const Range& range) {
  const std::string unit = si_unit_of(key);
  const std::string limits = range_text(range, unit);
  if (!limits.empty()) return fmt::format("{}, {}", type, limits);
  return unit.empty() ? type : fmt::format("{}, {}", type, unit);
}

// A text that is wrong, as a message shows it.
std::string shortened_value(std::string_view text) {
  constexpr std::size_t bytes_max = 60;
  return visible_text(beginning(text, bytes_max)) + (text.size() > bytes_max ? "..." : "");
}

}  // namespace

std::string text_at(lua_State* L, int index) {
  std::size_t size = 0;
  const char* bytes = lua_tolstring(L, index, &size);
  return {bytes, size};
}

std::string si_unit_of(std::string_view key) {
  for (const auto& [suffix, symbol] : compound_units) {
    if (key.ends_with(suffix)) return std::string(symbol);
  }
  std::string_view best_suffix, best_symbol;
  for (const Unit& unit : all_units()) {
    const std::string_view suffix = unit.suffix;
    if (unit.si_factor != 1 || suffix.empty() || suffix.size() <= best_suffix.size()) continue;
    if (key.ends_with("_" + std::string(suffix))) {
      best_suffix = suffix;
      best_symbol = unit.symbol;
    }
  }
  return std::string(best_symbol);
}

std::string suggest_key(std::string_view key, std::span<const std::string> known) {
  for (const std::string& candidate : known) {
    if (candidate.starts_with(std::string(key) + "_") && !si_unit_of(candidate).empty()) {
      return fmt::format("; did you mean '{}'?", candidate);
    }
  }
  return did_you_mean(key, known);
}

Faults& load_faults(lua_State* L, const char* constructor) {
  if (Faults* faults = context(L).load_faults) return *faults;
  throw std::runtime_error(fmt::format("{} works only while a script loads", constructor));
}

TableReader::TableReader(lua_State* L, int index, std::string what, Place place, Faults& faults)
    : L_(L),
      index_(lua_absindex(L, index)),
      what_(std::move(what)),
      place_(std::move(place)),
      faults_(&faults) {}

TableReader::TableReader(std::vector<KeyDoc>& keys) : keys_(&keys) {}

void TableReader::fault(const std::string& text) {
  constexpr std::int64_t instructions_per_fault = 200;
  if (L_ != nullptr) charge(L_, instructions_per_fault);
  if (++fault_count_ > faults_max) return;
  faults_->error(place_, fmt::format("{}: {}", what_, text));
}

bool TableReader::take(Need need, const char* key, const char* type, const char* doc) {
  if (L_ != nullptr) charge(L_, instructions_per_key);
  known_.emplace_back(key);
  if (keys_ != nullptr) {
    keys_->push_back({key, type, need == required, doc});
    return false;
  }
  lua_pushstring(L_, key);
  lua_rawget(L_, index_);
  if (need == required && lua_isnil(L_, -1)) {
    std::string_view what = doc;
    if (what.ends_with('.')) what.remove_suffix(1);
    fault(fmt::format("'{}' is missing: {}", key, what));
  }
  return true;
}

bool TableReader::get(Need need, const char* key, const std::string& type, const char* doc,
                      int wanted_type, const char* wanted) {
  if (!take(need, key, type.c_str(), doc)) return false;
  if (lua_type(L_, -1) == wanted_type) return true;
  if (!lua_isnil(L_, -1)) {
    fault(fmt::format("{}: {} is wanted, found {}", key, wanted, describe(L_, -1)));
  }
  lua_pop(L_, 1);
  return false;
}

bool TableReader::check(const char* key, double value, const Range& range) {
  const bool above = range.is_above_min ? value > range.min : value >= range.min;
  if (std::isfinite(value) && above && value <= range.max) return true;
  const std::string limits = range_text(range, si_unit_of(key));
  fault(fmt::format("{} = {}: must be {}", key, value, limits.empty() ? "finite" : limits));
  return false;
}

// Adds a fault for an unknown word: "mode = 'tarck': 'fixed', 'point' or 'track' is wanted; did you
// mean 'track'?"
void TableReader::check_word(const char* key, const std::string& word,
                             const std::vector<std::string>& names) {
  if (std::ranges::find(names, word) != names.end()) return;
  const std::span others(names.data(), names.size() - 1);
  fault(fmt::format("{} = '{}': '{}' or '{}' is wanted{}", key, word, fmt::join(others, "', '"),
                    names.back(), did_you_mean(word, names)));
}

void TableReader::number(Need need, const char* key, std::optional<double>& value,
                         const Range& range, const char* doc) {
  if (!get(need, key, type_text("number", key, range), doc, LUA_TNUMBER, "a number")) return;
  const double found = lua_tonumber(L_, -1);
  lua_pop(L_, 1);
  if (check(key, found, range)) value = found;
}

void TableReader::integer(Need need, const char* key, std::optional<std::int64_t>& value,
                          const Range& range, const char* doc) {
  if (!get(need, key, type_text("integer", key, range), doc, LUA_TNUMBER, "a whole number")) return;
  int is_whole = 0;
  const lua_Integer whole = lua_tointegerx(L_, -1, &is_whole);
  const double found = lua_tonumber(L_, -1);
  lua_pop(L_, 1);
  if (is_whole == 0) {
    fault(fmt::format("{} = {}: must be a whole number", key, found));
  } else if (check(key, found, range)) {
    value = whole;
  }
}

void TableReader::boolean(Need need, const char* key, std::optional<bool>& value, const char* doc) {
  if (!get(need, key, "boolean", doc, LUA_TBOOLEAN, "true or false")) return;
  value = lua_toboolean(L_, -1) != 0;
  lua_pop(L_, 1);
}

void TableReader::text(Need need, const char* key, std::optional<std::string>& value,
                       const char* doc) {
  if (!get(need, key, "text", doc, LUA_TSTRING, "a text")) return;
  std::string found = text_at(L_, -1);
  lua_pop(L_, 1);
  if (std::string_view(key) == "name") {
    if (!check_name(key, found)) return;
  } else if (!is_utf8(found) || found.find('\0') != std::string::npos) {
    fault(fmt::format("{} = '{}': a text in UTF-8 is wanted", key, shortened_value(found)));
    return;
  }
  value = std::move(found);
  if (value->empty()) fault(fmt::format("{}: must not be empty", key));
}

void TableReader::vec3(Need need, const char* key, std::optional<Vec3>& value, const char* doc) {
  const std::string unit = si_unit_of(key);
  if (!take(need, key, unit.empty() ? "vec3" : ("vec3, " + unit).c_str(), doc)) return;
  value = to_vec3(L_, -1);
  if (!value && !lua_isnil(L_, -1)) {
    fault(fmt::format("{}: lsos.vec3(x, y, z) is wanted, found {}", key, describe(L_, -1)));
  }
  lua_pop(L_, 1);
}

void TableReader::numbers(Need need, const char* key, std::vector<double>& value,
                          const Range& range, const char* doc) {
  if (!get(need, key, type_text("list of numbers", key, range), doc, LUA_TTABLE,
           "a list of numbers"))
    return;
  value.clear();
  for (lua_Integer i = 1; lua_rawgeti(L_, -1, i) != LUA_TNIL; ++i, lua_pop(L_, 1)) {
    charge(L_, instructions_per_key);
    const std::string name = fmt::format("{}[{}]", key, i);
    if (lua_type(L_, -1) != LUA_TNUMBER) {
      fault(fmt::format("{}: a number is wanted, found {}", name, describe(L_, -1)));
    } else if (check(name.c_str(), lua_tonumber(L_, -1), range)) {
      value.push_back(lua_tonumber(L_, -1));
    }
  }
  lua_pop(L_, 2);
}

bool TableReader::check_name(const char* what, std::string_view name) {
  if (is_name(name)) return true;
  fault(fmt::format("{} = '{}': a name is text in UTF-8 without control characters", what,
                    shortened_value(name)));
  return false;
}

void TableReader::texts(Need need, const char* key, std::vector<std::string>& value,
                        const char* doc) {
  if (!get(need, key, "list of texts", doc, LUA_TTABLE, "a list of texts")) return;
  value.clear();
  if (need == required && lua_rawlen(L_, -1) == 0) fault(fmt::format("{}: is empty", key));
  for (lua_Integer i = 1; lua_rawgeti(L_, -1, i) != LUA_TNIL; ++i, lua_pop(L_, 1)) {
    charge(L_, instructions_per_key);
    if (lua_type(L_, -1) == LUA_TSTRING) {
      value.emplace_back(lua_tostring(L_, -1));
    } else {
      fault(fmt::format("{}[{}]: a text is wanted, found {}", key, i, describe(L_, -1)));
    }
  }
  lua_pop(L_, 2);
}

void TableReader::api_version() {
  std::int64_t version = api_version_max;
  if (!get(required, "api", "integer", "Version of this interface: 1.", LUA_TNUMBER,
           "a whole number"))
    return;
  version = lua_tointeger(L_, -1);
  const double found = lua_tonumber(L_, -1);
  lua_pop(L_, 1);
  if (static_cast<double>(version) == found && version >= api_version_min &&
      version <= api_version_max)
    return;
  const std::string known = api_version_min == api_version_max
                                ? fmt::format("{}", api_version_max)
                                : fmt::format("{} to {}", api_version_min, api_version_max);
  fault(fmt::format("api = {}: this program knows api {}", found, known));
}

const ConstructedValue* TableReader::constructed_value(Need need, const char* key, const char* kind,
                                                       const char* doc) {
  const std::string type = fmt::format("lsos.{}", kind);
  if (!take(need, key, type.c_str(), doc)) return nullptr;
  const ConstructedValue* found = to_constructed(L_, -1);  // stays alive: the table holds it
  if (found != nullptr && found->kind != kind) found = nullptr;
  if (found == nullptr && !lua_isnil(L_, -1)) {
    fault(fmt::format("{}: {} {{...}} is wanted, found {}", key, type, describe(L_, -1)));
  }
  lua_pop(L_, 1);
  return found;
}

void TableReader::constructed_list(Need need, const char* key, const char* kind, const char* doc,
                                   const std::function<void(const ConstructedValue&)>& add) {
  const std::string type = fmt::format("list of lsos.{}", kind);
  if (!get(need, key, type, doc, LUA_TTABLE, ("a " + type).c_str())) return;
  for (lua_Integer i = 1; lua_rawgeti(L_, -1, i) != LUA_TNIL; ++i, lua_pop(L_, 1)) {
    charge(L_, instructions_per_key);
    const ConstructedValue* found = to_constructed(L_, -1);
    if (found != nullptr && found->kind == kind) {
      add(*found);
    } else {
      fault(fmt::format("{}[{}]: lsos.{} {{...}} is wanted, found {}", key, i, kind,
                        describe(L_, -1)));
    }
  }
  lua_pop(L_, 2);
}

void TableReader::finish() {
  if (L_ == nullptr) return;
  std::vector<std::string> unknown;
  lua_pushnil(L_);
  while (lua_next(L_, index_) != 0) {
    lua_pop(L_, 1);
    charge(L_, instructions_per_key);
    if (lua_type(L_, -1) == LUA_TSTRING) {
      const std::string key = key_text(L_, -1);
      if (std::ranges::find(known_, key) == known_.end()) unknown.push_back(key);
    } else if (lua_type(L_, -1) == LUA_TNUMBER) {
      unknown.push_back(fmt::format("[{}]", lua_tonumber(L_, -1)));
    } else {
      unknown.push_back(fmt::format("[{}]", luaL_typename(L_, -1)));
    }
  }
  std::ranges::sort(unknown);
  std::ranges::sort(known_);
  for (const std::string& key : unknown) {
    if (fault_count_ > faults_max) break;
    const std::string near = suggest_key(key, known_);
    fault(
        fmt::format("unknown key '{}'{}", key,
                    near.empty() ? fmt::format("; known are {}", fmt::join(known_, ", ")) : near));
  }
}

}  // namespace lsos
