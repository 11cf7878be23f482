// string functions that could hang the program, eat its memory or show an address, bounded.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "lua/pattern_cost.h"
#include "lua/sandbox.h"
#include "lua/state.h"

namespace lsos {

namespace {

constexpr double rep_bytes_max = 1 << 20;

// Bytes that a C function handles in about the time of one Lua instruction.
constexpr std::int64_t bytes_per_instruction = 64;

std::string_view text_argument(lua_State* L, int index) {
  std::size_t size = 0;
  const char* text = luaL_checklstring(L, index, &size);
  return {text, size};
}

// Calls Lua's own function (upvalue 1) in this frame, so that its messages name the script.
int call_original(lua_State* L) { return lua_tocfunction(L, lua_upvalueindex(1))(L); }

int charged(lua_State* L) {
  std::int64_t bytes = 0;
  for (int i = lua_gettop(L); i > 0; --i) {
    if (lua_type(L, i) == LUA_TSTRING) bytes += static_cast<std::int64_t>(lua_rawlen(L, i));
  }
  charge(L, bytes / bytes_per_instruction);
  return call_original(L);
}

int rep(lua_State* L) {
  const double count = std::max<double>(0, static_cast<double>(luaL_checkinteger(L, 2)));
  const double separator =
      static_cast<double>(lua_isnoneornil(L, 3) ? 0 : text_argument(L, 3).size());
  const double bytes = count * (static_cast<double>(text_argument(L, 1).size()) + separator);
  if (bytes > rep_bytes_max) {
    throw std::runtime_error(
        fmt::format("string.rep would make {:.0f} bytes; at most {:.0f}", bytes, rep_bytes_max));
  }
  charge(L, static_cast<std::int64_t>(bytes) / bytes_per_instruction);
  return call_original(L);
}

// find, match, gmatch, gsub.
int match(lua_State* L) {
  const std::string_view subject = text_argument(L, 1);
  const std::string_view pattern = text_argument(L, 2);
  const double steps = pattern_steps(pattern, subject.size());
  if (steps > pattern_steps_max) {
    throw std::runtime_error(fmt::format(
        "a pattern with {} repetitions (* + - %b) can take too long on a text of {} bytes; at most "
        "{:.0f}{}",
        pattern_repetitions(pattern), subject.size(), subject_bytes_max(pattern),
        pattern.starts_with('^') ? "" : ", more if it begins with '^'"));
  }
  charge(L, static_cast<std::int64_t>(steps / 100));
  return call_original(L);
}

int find(lua_State* L) {
  return lua_toboolean(L, 4) != 0 ? charged(L) : match(L);  // 4: plain, no pattern
}

// Conversions in the format; throws for %p.
void refuse_addresses(std::string_view format) {
  for (std::size_t i = 0; i + 1 < format.size(); ++i) {
    if (format[i] != '%') continue;
    i = format.find_first_not_of("-+ #0123456789.", i + 1);
    if (i == std::string_view::npos) return;
    if (format[i] == 'p') {
      throw std::runtime_error("'%p' is not allowed: addresses differ from run to run");
    }
  }
}

int format(lua_State* L) {
  refuse_addresses(text_argument(L, 1));
  for (int i = lua_gettop(L); i > 1; --i) {
    if (lua_type(L, i) < LUA_TTABLE) continue;
    push_text(L, i);
    lua_replace(L, i);
  }
  return charged(L);
}

}  // namespace

void replace_string_functions(lua_State* L) {
  constexpr luaL_Reg replacements[] = {
      {"rep", guard<rep>},       {"find", guard<find>},      {"match", guard<match>},
      {"gmatch", guard<match>},  {"gsub", guard<match>},     {"format", guard<format>},
      {"upper", guard<charged>}, {"lower", guard<charged>},  {"reverse", guard<charged>},
      {"sub", guard<charged>},   {"byte", guard<charged>},   {"char", guard<charged>},
      {"pack", guard<charged>},  {"unpack", guard<charged>}, {"packsize", guard<charged>}};
  for (const luaL_Reg& replacement : replacements) {
    lua_getfield(L, -1, replacement.name);
    lua_pushcclosure(L, replacement.func, 1);
    lua_setfield(L, -2, replacement.name);
  }
}

}  // namespace lsos
