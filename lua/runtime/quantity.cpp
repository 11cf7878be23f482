#include "base/quantity.h"
#include "lua/runtime/quantity.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace lsos {

GivenQuantity check_quantity(lua_State* L, int argument) {
  if (lua_type(L, argument) != LUA_TSTRING) return {luaL_checknumber(L, argument), nullptr};
  const std::string text = lua_tostring(L, argument);
  const std::size_t end = text.find_first_not_of("+-.0123456789eE");
  const std::size_t begin = end == std::string::npos ? end : text.find_first_not_of(' ', end);
  const std::string symbol = begin == std::string::npos ? "1" : text.substr(begin);
  const Unit* unit = find_unit(symbol);
  if (unit == nullptr) throw std::runtime_error(fmt::format("'{}': no unit '{}'", text, symbol));
  const auto parsed = parse_quantity(text, *unit);
  if (!parsed) throw std::runtime_error(fmt::format("'{}': {}", text, parsed.why));
  return {*parsed.value, unit};
}

double check_duration_s(lua_State* L, int argument, const char* what) {
  constexpr double longest_s = 1e9;
  double duration_s = 0;
  if (lua_type(L, argument) == LUA_TSTRING) {
    const Parsed<double> parsed = parse_quantity(lua_tostring(L, argument), *find_unit("s"));
    if (!parsed) throw std::runtime_error(fmt::format("{}: {}", what, parsed.why));
    duration_s = *parsed.value;
  } else {
    duration_s = luaL_checknumber(L, argument);
  }
  if (duration_s >= 0 && duration_s <= longest_s) return duration_s;
  throw std::runtime_error(
      fmt::format("{}: {} s; 0 to {} are allowed", what, duration_s, longest_s));
}

double check_deploying_s(lua_State* L, int argument, const char* what) {
  constexpr double longest_s = 366 * 86400.0;
  const double duration_s = luaL_checknumber(L, argument);
  if (duration_s >= 0 && duration_s <= longest_s) return duration_s;
  throw std::runtime_error(
      fmt::format("{}: a duration of {} s; 0 to {} are allowed", what, duration_s, longest_s));
}

}  // namespace lsos
