#include "lua/runtime/shared_script.h"

#include <fmt/format.h>

#include <algorithm>

#include "lua/runtime/constructed_value.h"
#include "lua/runtime/context.h"
#include "lua/runtime/environment.h"
#include "lua/runtime/read_only.h"
#include "lua/runtime/state.h"

namespace lsos {

namespace {

constexpr const char* results_key = "lsos.shared scripts";
constexpr std::string_view prefix = "lib/";

[[noreturn]] void refuse_shared(const std::string& name, const std::string& why) {
  throw std::runtime_error(fmt::format("require '{}': {}", name, why));
}

const Script& find_script(const LuaContext& ctx, const std::string& name) {
  std::vector<std::string> names;
  for (const Script& script : *ctx.scripts) {
    if (script.kind != ScriptKind::shared) continue;
    if (prefix.size() + script.name.size() == name.size() && name.ends_with(script.name)) {
      return script;
    }
    names.push_back(std::string(prefix) + script.name);
  }
  refuse_shared(name, "there is no such script" + did_you_mean(name, names));
}

}  // namespace

void push_shared_script(lua_State* L, const std::string& name) {
  LuaContext& ctx = context(L);
  if (!name.starts_with(prefix)) {
    refuse_shared(name, "'lsos' and scripts of lib/ ('lib/NAME') can be required");
  }
  if (ctx.load_faults == nullptr || ctx.scripts == nullptr) {
    refuse_shared(name, "only at the head of a script in events/, rovers/ or terrain/");
  }
  const Script& script = find_script(ctx, name);
  ctx.required.insert(script.name);
  luaL_getsubtable(L, LUA_REGISTRYINDEX, results_key);
  const int results = lua_gettop(L);
  if (lua_getfield(L, results, name.c_str()) == LUA_TNIL) {
    lua_pop(L, 1);
    if (std::ranges::count(ctx.requiring, name) > 0) refuse_shared(name, "it requires itself");
    ctx.requiring.push_back(name);
    run_within(L, script);
    ctx.requiring.pop_back();
    if (!lua_istable(L, -1)) {
      refuse_shared(name,
                    fmt::format("{} must return a table, found {}", script.file, describe(L, -1)));
    }
    make_read_only(L, name.c_str(), Maker::script);
    lua_pushvalue(L, -1);
    lua_setfield(L, results, name.c_str());
  }
  lua_remove(L, results);
}

void forget_shared_scripts(lua_State* L) {
  context(L).requiring.clear();  // what a script that failed may have left
  context(L).required.clear();
  lua_pushnil(L);
  lua_setfield(L, LUA_REGISTRYINDEX, results_key);
}

}  // namespace lsos
