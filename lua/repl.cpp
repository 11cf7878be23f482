#include "lua/repl.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "lua/api.h"
#include "lua/handle.h"
#include "lua/reader.h"
#include "lua/sandbox.h"

namespace lsos {

namespace {

constexpr const char* shown_file = "prompt";

std::string value_text(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TNUMBER && lua_isinteger(L, index) == 0) {
    return fmt::format("{:.9g}", lua_tonumber(L, index));
  }
  push_text(L, index);
  std::string text = lua_tostring(L, -1);
  lua_pop(L, 1);
  return text;
}

// With the unit that its name says: "1.97 m/s" of speed_mps.
std::string quantity_text(lua_State* L, int index, const std::string& name) {
  std::string text = value_text(L, index);
  const std::string unit = si_unit_of(name);
  if (lua_type(L, index) == LUA_TNUMBER && !unit.empty()) text += " " + unit;
  return text;
}

// The fields of a handle, or what a table holds, a line each.
void add_members(lua_State* L, int index, std::string& text) {
  index = lua_absindex(L, index);
  if (const HandleType* type = handle_type(L, index)) {
    for (const HandleField& field : type->fields) {
      lua_getfield(L, index, field.name);
      text += fmt::format("\n  {} = {}", field.name, quantity_text(L, -1, field.name));
      lua_pop(L, 1);
    }
    return;
  }
  push_sorted_keys(L, index);
  for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i, lua_pop(L, 1)) {
    const std::string key = value_text(L, -1);
    lua_pushvalue(L, -1);
    lua_rawget(L, index);
    text += fmt::format("\n  {} = {}", key, quantity_text(L, -1, key));
    lua_pop(L, 1);
  }
  lua_pop(L, 2);
}

std::string shown(lua_State* L, int index, const std::string& name) {
  std::string text = quantity_text(L, index, name);
  const bool has_members =
      handle_type(L, index) != nullptr ||
      (lua_istable(L, index) && luaL_getmetafield(L, index, "__tostring") == 0);
  if (has_members) add_members(L, index, text);
  return text;
}

// "speed_mps" of "sim.rovers.A.speed_mps".
std::string last_name(const std::string& text) {
  const auto is_letter = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  auto end = text.end();
  while (end != text.begin() && std::isspace(static_cast<unsigned char>(*(end - 1))) != 0) --end;
  auto begin = end;
  while (begin != text.begin() && is_letter(*(begin - 1))) --begin;
  return {begin, end};
}

std::string help_of(const HandleType& type) {
  std::string text = fmt::format("{}: {}", type.name, type.doc);
  for (const HandleField& field : type.fields) {
    text += fmt::format("\n  .{:<18} {:<10} {}", field.name, field.type, field.doc);
  }
  for (const HandleMethod& method : type.methods) {
    text += fmt::format("\n  {}\n      {}", method.signature, method.doc);
  }
  return text;
}

std::string help_of(const std::string& name) {
  for (const ApiFunction& entry : api_functions()) {
    if (name == entry.name) return fmt::format("{}\n  {}", entry.signature, entry.doc);
  }
  for (const ApiSection& section : api_sections()) {
    for (const Constructor& entry : section.constructors) {
      if (name == entry.name) return fmt::format("lsos.{} {{...}}\n  {}", name, entry.doc);
    }
  }
  std::vector<std::string> known;
  for (const ApiFunction& entry : api_functions()) known.emplace_back(entry.name);
  return fmt::format("there is no lsos.{}{}", name, did_you_mean(name, known));
}

constexpr const char* general_help =
    "sim                 the simulation: help(sim)\n"
    "sim:run_for(60)     a minute; sim:step(n), sim:run_until(function), sim:step_phase(), "
    "sim:run()\n"
    "sim:where()         what all rovers do\n"
    "sim.rovers.SEV1     a rover: help(sim.rovers.SEV1)\n"
    "lsos.sim {...}      another one: help 'sim'\n"
    "Ctrl-C stops a run, Ctrl-D ends.";

int help(lua_State* L) {
  std::string text = general_help;
  if (lua_type(L, 1) == LUA_TSTRING) {
    text = help_of(lua_tostring(L, 1));
  } else if (const HandleType* type = handle_type(L, 1)) {
    text = help_of(*type);
  } else if (!lua_isnoneornil(L, 1)) {
    text = "help(x) knows objects such as sim and its rovers, and names: help 'sim'";
  }
  context(L).in_hand->say(text);
  return 0;
}

// Names of what the value at the top has.
std::vector<std::string> member_names(lua_State* L) {
  std::vector<std::string> names;
  if (const HandleType* type = handle_type(L, -1)) {
    for (const HandleField& field : type->fields) names.emplace_back(field.name);
    for (const HandleMethod& method : type->methods) names.emplace_back(method.name);
  } else if (lua_istable(L, -1)) {
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
      if (lua_type(L, -2) == LUA_TSTRING) names.emplace_back(lua_tostring(L, -2));
    }
    std::ranges::sort(names);
  }
  return names;
}

Limits at_a_prompt() {
  Limits limits;
  limits.instructions = 2'000'000'000;  // some 20 s
  return limits;
}

}  // namespace

Repl::Repl(const std::string& plan_file, const std::string& folder,
           std::function<void(const std::string&)> say)
    : say_(std::move(say)), lua_(at_a_prompt()), sims_(folder, say_) {
  lua_.context().in_hand = &sims_;
  std::optional<ScriptInstance> number;
  if (!plan_file.empty()) number = sims_.open(plan_file);
  lua_.run([&](lua_State* L) {
    push_open_environment(L);
    push_lsos_module(L);
    lua_setfield(L, -2, "lsos");
    lua_pushcfunction(L, guard<help>);
    lua_setfield(L, -2, "help");
    if (number) {
      push_handle(L, sim_handle_type(), *number);
      lua_setfield(L, -2, "sim");
    }
    environment_ = luaL_ref(L, LUA_REGISTRYINDEX);
  });
}

Repl::Outcome Repl::run(const std::string& text, int line) {
  SimSession::forget_interrupt();
  Outcome outcome = Outcome::failed;
  try {
    lua_.run([&](lua_State* L) { outcome = run_in(L, text, line); });
  } catch (const std::exception& error) {
    say_(fmt::format("fault inside the program: {}", error.what()));
  }
  return outcome;
}

Repl::Outcome Repl::run_in(lua_State* L, const std::string& text, int line) {
  const int top = lua_gettop(L);
  const std::string before(static_cast<std::size_t>(line - 1), '\n');
  const auto tell_news = [&] {
    for (const std::string& news : sims_.take_news()) say_(news);
  };
  const bool is_statement = load_text(L, before + "return " + text, shown_file).has_value();
  if (is_statement) {
    if (const auto failure = load_text(L, before + text, shown_file)) {
      if (failure->message.ends_with("near <eof>")) return Outcome::incomplete;
      say_(failure->message);
      return Outcome::failed;
    }
  }
  lua_rawgeti(L, LUA_REGISTRYINDEX, environment_);
  lua_setupvalue(L, -2, 1);  // _ENV
  if (const auto failure = call_script(L, 0, LUA_MULTRET)) {
    tell_news();
    say_(failure->message);
    return Outcome::failed;
  }
  tell_news();
  for (int i = top + 1; i <= lua_gettop(L); ++i) {
    if (lua_isnil(L, i) && lua_gettop(L) == top + 1) break;
    say_(shown(L, i, last_name(text)));
  }
  lua_settop(L, top);
  return Outcome::done;
}

std::vector<std::string> Repl::completions(const std::string& text) {
  const auto is_part = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == ':';
  };
  auto begin = text.end();
  while (begin != text.begin() && is_part(*(begin - 1))) --begin;
  const std::string path(begin, text.end());
  std::vector<std::string> found;
  lua_.run([&](lua_State* L) {
    lua_rawgeti(L, LUA_REGISTRYINDEX, environment_);
    std::string known;  // of the path, with its last dot
    for (std::size_t at = 0;;) {
      const std::size_t end = path.find_first_of(".:", at);
      if (end == std::string::npos) break;
      const std::string name = path.substr(at, end - at);
      const std::vector<std::string> members = member_names(L);
      if (std::ranges::find(members, name) == members.end()) return;
      lua_getfield(L, -1, name.c_str());
      known = path.substr(0, end + 1);
      at = end + 1;
    }
    for (const std::string& name : member_names(L)) {
      if ((known + name).starts_with(path)) found.push_back(known + name);
    }
  });
  return found;
}

}  // namespace lsos
