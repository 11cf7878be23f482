#include "lua/api/resources.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "lua/api/arguments.h"
#include "lua/runtime/handle.h"

namespace lsos {

namespace {

// The name of a resource that the rover carries, the second argument of `call`.
std::string checked_resource(lua_State* L, const char* call) {
  std::string name = luaL_checkstring(L, 2);
  if (rover_of(L).power().resource(name)) return name;
  throw std::runtime_error(fmt::format("rover:{}: the rover carries no '{}'", call, name));
}

double checked_amount(lua_State* L, const char* call) {
  const double amount = luaL_checknumber(L, 3);
  if (amount >= 0 && std::isfinite(amount)) return amount;
  throw std::runtime_error(
      fmt::format("rover:{}: {}; an amount of 0 or more is wanted", call, amount));
}

}  // namespace

std::map<std::string, double> check_amounts(lua_State* L, int index) {
  std::map<std::string, double> amounts;
  if (lua_isnil(L, index)) return amounts;
  constexpr const char* wanted = "a table of amounts is wanted, as { oxygen = 0.4 }, or nil";
  if (!lua_istable(L, index)) throw std::runtime_error(wanted);
  index = lua_absindex(L, index);
  for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
    const bool is_amount = lua_type(L, -2) == LUA_TSTRING && lua_type(L, -1) == LUA_TNUMBER &&
                           lua_tonumber(L, -1) >= 0;
    if (!is_amount) throw std::runtime_error(wanted);
    amounts[lua_tostring(L, -2)] = lua_tonumber(L, -1);
  }
  return amounts;
}

int left_of_resource(lua_State* L) {
  const auto amount = rover_of(L).power().resource(luaL_checkstring(L, 2));
  push_quantity(L, amount.value_or(not_modelled));
  return 1;
}

int use_resource(lua_State* L) {
  const double amount = checked_amount(L, "use");
  const std::string name = checked_resource(L, "use");
  lua_pushboolean(L, rover_of(L).power().use(name, amount));
  return 1;
}

int restock(lua_State* L) {
  const bool is_to_the_full = lua_isnoneornil(L, 3);
  const double amount =
      is_to_the_full ? std::numeric_limits<double>::infinity() : checked_amount(L, "restock");
  const std::string name = checked_resource(L, "restock");
  lua_pushnumber(L, rover_of(L).power().restock(name, amount));
  return 1;
}

}  // namespace lsos
