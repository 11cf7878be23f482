// Bounded versions of string functions that could hang the program, exhaust its memory or show an
// address.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "lua/runtime/sandbox.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value_text.h"

namespace lsos {

namespace {

constexpr double rep_bytes_max = 1 << 20;

// Cost of snprintf of a number with all its digits.
constexpr std::int64_t instructions_per_conversion = 100;

std::size_t text_bytes(lua_State* L, int first) {
  std::size_t bytes = 0;
  for (int i = lua_gettop(L); i >= first; --i) {
    if (lua_type(L, i) == LUA_TSTRING) bytes += lua_rawlen(L, i);
  }
  return bytes;
}

// upper, lower, reverse, sub, char, byte: their work is proportional to their results.
int charged_by_results(lua_State* L) {
  const int count = call_original(L);
  charge_bytes(L, text_bytes(L, lua_gettop(L) - count + 1));
  charge(L, count);
  return count;
}

// Arithmetic on texts: parsing numbers is charged by the length of the arguments.
int charged_by_arguments(lua_State* L) {
  charge_bytes(L, 4 * text_bytes(L, 1));
  return call_original(L);
}

int string_byte(lua_State* L) {
  const auto size = static_cast<lua_Integer>(text_argument(L, 1).size());
  const lua_Integer first = luaL_optinteger(L, 2, 1), last = luaL_optinteger(L, 3, first);
  const auto from_begin = [&](lua_Integer i) {
    return i >= 0 ? i : std::max(-size - 1, i) + size + 1;
  };
  const lua_Integer count =
      std::min(size, from_begin(last)) - std::max<lua_Integer>(1, from_begin(first)) + 1;
  if (count > values_max) {
    throw std::runtime_error(
        fmt::format("string.byte of {} characters; at most {}", count, values_max));
  }
  return charged_by_results(L);
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
  if (bytes == 0) {  // Lua's own would loop `count` times to append nothing
    lua_pushliteral(L, "");
    return 1;
  }
  charge(L, static_cast<std::int64_t>(count / 4));
  charge_bytes(L, static_cast<std::size_t>(bytes));
  return call_original(L);
}

// pack, unpack, packsize: a format is parsed letter by letter; unpack gives a value for each
// letter.
int packing(lua_State* L) {
  const auto letters = static_cast<lua_Integer>(text_argument(L, 1).size());
  if (letters > values_max) {
    throw std::runtime_error(
        fmt::format("a packing format of {} bytes; at most {}", letters, values_max));
  }
  charge(L, letters);
  return charged_by_results(L);
}

// Throws for %p.
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
  const std::string_view format = text_argument(L, 1);
  charge_bytes(L, 4 * format.size());
  charge(L, std::ranges::count(format, '%') * instructions_per_conversion);
  refuse_addresses(format);
  for (int i = lua_gettop(L); i > 1; --i) {
    if (lua_type(L, i) < LUA_TTABLE) continue;
    push_text(L, i);
    lua_replace(L, i);
  }
  charge_bytes(L, text_bytes(L, 2));  // even %.1s reads the whole text
  return charged_by_results(L);
}

void wrap(lua_State* L, const luaL_Reg& replacement) {
  lua_getfield(L, -1, replacement.name);
  lua_pushcclosure(L, replacement.func, 1);
  lua_setfield(L, -2, replacement.name);
}

}  // namespace

void replace_string_functions(lua_State* L) {
  constexpr luaL_Reg replacements[] = {{"rep", guard<rep>},
                                       {"format", guard<format>},
                                       {"byte", guard<string_byte>},
                                       {"upper", guard<charged_by_results>},
                                       {"lower", guard<charged_by_results>},
                                       {"reverse", guard<charged_by_results>},
                                       {"sub", guard<charged_by_results>},
                                       {"char", guard<charged_by_results>},
                                       {"pack", guard<packing>},
                                       {"unpack", guard<packing>},
                                       {"packsize", guard<packing>}};
  for (const luaL_Reg& replacement : replacements) wrap(L, replacement);
  replace_pattern_functions(L);
}

void replace_text_arithmetic(lua_State* L) {
  for (const char* name :
       {"__add", "__sub", "__mul", "__mod", "__pow", "__div", "__idiv", "__unm"}) {
    wrap(L, {name, guard<charged_by_arguments>});
  }
}

}  // namespace lsos
