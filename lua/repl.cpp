#include "lua/repl.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <regex>

#include "lua/api.h"
#include "lua/handle.h"
#include "lua/reader.h"
#include "lua/sandbox.h"

namespace lsos {

namespace {

constexpr const char* shown_file = "prompt";

// Set by Ctrl-C while a line runs; it stops a script, and SimSession stops a run.
std::atomic<bool> is_stop_wanted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // a signal's handler sets it

class StopByInterrupt {
 public:
  StopByInterrupt() {
    is_stop_wanted = false;
    SimSession::forget_interrupt();
    before_ = std::signal(SIGINT, [](int) {
      is_stop_wanted = true;
      SimSession::interrupt();
    });
  }
  ~StopByInterrupt() { std::signal(SIGINT, before_); }
  StopByInterrupt(const StopByInterrupt&) = delete;
  StopByInterrupt& operator=(const StopByInterrupt&) = delete;

 private:
  void (*before_)(int);
};

std::string value_text(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TNUMBER && lua_isinteger(L, index) == 0) {
    return fmt::format("{:.9g}", lua_tonumber(L, index));
  }
  push_text(L, index);
  std::string text = error_text(L, -1);
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

// "a boolean" when a key is neither a number nor a text, so that keys have no order.
std::string other_key(lua_State* L, int index) {
  std::string found;
  lua_pushnil(L);
  for (; lua_next(L, index) != 0; lua_pop(L, 1)) {
    const int type = lua_type(L, -2);
    if (type != LUA_TNUMBER && type != LUA_TSTRING)
      found = "a " + std::string(luaL_typename(L, -2));
  }
  return found;
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
  if (const std::string other = other_key(L, index); !other.empty()) {
    text += fmt::format("\n  (with {} as a key)", other);
    return;
  }
  constexpr lua_Integer members_max = 200;
  push_sorted_keys(L, index);
  const auto count = static_cast<lua_Integer>(lua_rawlen(L, -1));
  for (lua_Integer i = 1; i <= std::min(count, members_max); ++i, lua_pop(L, 1)) {
    lua_rawgeti(L, -1, i);
    const std::string key = value_text(L, -1);
    lua_pushvalue(L, -1);
    lua_rawget(L, index);
    text += fmt::format("\n  {} = {}", key, quantity_text(L, -1, key));
    lua_pop(L, 1);
  }
  if (count > members_max) text += fmt::format("\n  and {} more", count - members_max);
  lua_pop(L, 1);
}

std::string shown(lua_State* L, int index, const std::string& name) {
  std::string text = quantity_text(L, index, name);
  bool has_members = handle_type(L, index) != nullptr || lua_istable(L, index);
  if (lua_istable(L, index) && luaL_getmetafield(L, index, "__tostring") != LUA_TNIL) {
    lua_pop(L, 1);
    has_members = false;
  }
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
    "x = 5               keeps a value; a local lasts to the end of its line\n"
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

// Says the values at 2 and above; 1 is the name that the line ends in. As a call of its own, since
// a value's text may be made by a script.
int say_values(lua_State* L) {
  const int count = lua_gettop(L);
  const std::string name = lua_tostring(L, 1);
  for (int i = 2; i <= count; ++i) {
    if (lua_isnil(L, i) && count == 2) break;
    context(L).in_hand->say(shown(L, i, name));
  }
  return 0;
}

// Names that a line makes local: "x", "y" of "local x, y = 1, 2".
std::vector<std::string> locals_in(const std::string& text) {
  static const std::regex statement(R"((?:^|[;\s])local\s+(?:function\s+)?([\w\s,<>]+))");
  static const std::regex word(R"([A-Za-z_]\w*)");
  std::vector<std::string> names;
  for (std::sregex_iterator at(text.begin(), text.end(), statement), end; at != end; ++at) {
    const std::string list = (*at)[1];
    for (std::sregex_iterator name(list.begin(), list.end(), word); name != end; ++name) {
      names.push_back(name->str());
    }
  }
  return names;
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
  limits.cpu_s = 1e9;
  return limits;
}

}  // namespace

Repl::Repl(const std::string& plan_file, const std::string& folder,
           std::function<void(const std::string&)> say)
    : say_(std::move(say)), lua_(at_a_prompt()), sims_(folder, say_) {
  lua_.context().in_hand = &sims_;
  lua_.context().is_stop_wanted = [] { return is_stop_wanted.load(); };
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
  const StopByInterrupt stop;
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
    say_(failure->message + local_hint(failure->message));
    return Outcome::failed;
  }
  tell_news();
  if (is_statement) {
    const std::vector<std::string> names = locals_in(text);
    locals_.insert(names.begin(), names.end());
  }
  luaL_checkstack(L, 4, "too many values");
  lua_pushcfunction(L, guard<say_values>);
  lua_insert(L, top + 1);
  lua_pushstring(L, last_name(text).c_str());
  lua_insert(L, top + 2);
  const auto failure = call_script(L, lua_gettop(L) - top - 1, 0);
  lua_settop(L, top);
  if (failure) {
    say_(failure->message);
    return Outcome::failed;
  }
  return Outcome::done;
}

// A local of one line is not known on the next, as each line is a chunk of its own.
std::string Repl::local_hint(const std::string& message) const {
  constexpr std::string_view mark = "no global '";
  const std::size_t at = message.find(mark);
  if (at == std::string::npos) return "";
  const std::string rest = message.substr(at + mark.size());
  if (!locals_.contains(rest.substr(0, rest.find('\'')))) return "";
  return "; a local lasts to the end of its line here: leave out 'local'";
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
