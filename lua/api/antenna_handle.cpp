// `rover.antennas`: raises and stows the rover's antennas.
#include <fmt/format.h>

#include <optional>
#include <string>

#include "lua/runtime/handle.h"
#include "lua/runtime/quantity.h"
#include "lua/runtime/state.h"

namespace lsos {

namespace {

template <bool up>
int deploy_antenna(lua_State* L) {
  RoverPort& rover = handle_rover(L, antennas_handle_type());
  std::optional<double> duration_s;
  if (!lua_isnoneornil(L, 3)) duration_s = check_deploying_s(L, 3, "antennas");
  const Deployment deployment = rover.deploy_antenna(luaL_optstring(L, 2, ""), up, duration_s);
  lua_pushnumber(L, deployment.takes_s);
  lua_pushboolean(L, deployment.moves);
  return 2;
}

}  // namespace

const HandleType& antennas_handle_type() {
  static const HandleType type{
      "rover.antennas",
      "The rover's antennas.",
      {},
      {{"deploy", guard<deploy_antenna<true>>, "antennas:deploy(name, duration_s)",
        "Raises the one with that name (nil: all that can be stowed), in that time or its own. "
        "Answers how long it takes, s, and whether any moves: false when all are up.",
        "fun(self: lsos.rover.antennas, name?: string, duration_s?: number): number, boolean"},
       {"stow", guard<deploy_antenna<false>>, "antennas:stow(name, duration_s)", "The reverse.",
        "fun(self: lsos.rover.antennas, name?: string, duration_s?: number): number, boolean"}}};
  return type;
}

}  // namespace lsos
