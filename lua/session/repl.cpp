#include "lua/session/repl.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <regex>

#include "base/stop_signal.h"
#include "lua/runtime/environment.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/module.h"
#include "lua/session/line_names.h"
#include "lua/session/prompt_help.h"
#include "lua/session/session_api.h"
#include "lua/session/shown_value.h"

namespace lsos {

namespace {

constexpr const char* shown_file = "prompt";
constexpr int tables_behind = 4;  // chained by __index

// Set by Ctrl-C while a line runs; it stops a script, and SimSession stops a run.
std::atomic<bool> is_stop_wanted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // a signal's handler sets it

class StopByInterrupt {
 public:
  StopByInterrupt() {
    is_stop_wanted = false;
    SimSession::forget_interrupt();
    ::sigaction(SIGINT, nullptr, &before_);
    catch_signal(SIGINT, [](int) {
      is_stop_wanted = true;
      SimSession::interrupt();
    });
  }
  ~StopByInterrupt() { ::sigaction(SIGINT, &before_, nullptr); }
  StopByInterrupt(const StopByInterrupt&) = delete;
  StopByInterrupt& operator=(const StopByInterrupt&) = delete;

 private:
  struct sigaction before_ {};
};

int help(lua_State* L) {
  std::string text = general_help();
  if (lua_type(L, 1) == LUA_TSTRING) {
    text = help_of(lua_tostring(L, 1));
  } else if (const HandleType* type = handle_type(L, 1)) {
    text = help_of(*type);
  } else if (!lua_isnoneornil(L, 1)) {
    text = "help(x) knows objects such as sim and its rovers, and names: help 'sim'";
  }
  context(L).interactive_rovers->say(text);
  return 0;
}

// Prints the values at 2 and above; 1 holds the names that they have in the line. It is a call of
// its own, since a script may produce a value's text.
int print_values(lua_State* L) {
  const int count = lua_gettop(L);
  const auto& names = *static_cast<const std::vector<std::string>*>(lua_touserdata(L, 1));
  for (int i = 2; i <= count; ++i) {
    if (lua_isnil(L, i) && count == 2) break;
    // The last expression may be a call that gives several values.
    const std::size_t number = std::min(static_cast<std::size_t>(i - 2), names.size() - 1);
    context(L).interactive_rovers->say(shown_value(L, i, names[number]));
  }
  return 0;
}

// Adds the text keys of the table at the top.
void add_keys(lua_State* L, std::vector<std::string>& names) {
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) == LUA_TSTRING) names.emplace_back(lua_tostring(L, -2));
  }
}

// Names of the members of the value at the top. A library is an empty, protected table: its members
// are in a table behind it.
std::vector<std::string> member_names(lua_State* L) {
  std::vector<std::string> names;
  if (const HandleType* type = handle_type(L, -1)) {
    for (const HandleField& field : type->fields) names.emplace_back(field.name);
    for (const HandleMethod& method : type->methods) names.emplace_back(method.name);
  } else if (lua_istable(L, -1)) {
    luaL_checkstack(L, 8 + 2 * tables_behind, "names of members");
    add_keys(L, names);
    const int top = lua_gettop(L);
    while (luaL_getmetafield(L, -1, "__index") != LUA_TNIL && lua_istable(L, -1) &&
           lua_gettop(L) <= top + tables_behind) {
      add_keys(L, names);
    }
    lua_settop(L, top);
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
  }
  return names;
}

// Whether the text is "quit" or "exit", as in other prompts.
bool is_exit_word(const std::string& text) {
  static const std::regex word(R"(\s*(quit|exit)\s*(\(\s*\))?\s*)");
  return std::regex_match(text, word);
}

}  // namespace

Repl::Repl(const std::string& plan_file, const std::string& folder,
           std::function<void(const std::string&)> say)
    : say_(std::move(say)), lua_(make_session_api, session_limits()), sim_sessions_(folder, say_) {
  lua_.context().interactive_rovers = &sim_sessions_;
  lua_.context().is_stop_wanted = [] { return is_stop_wanted.load(); };
  std::optional<ScriptInstance> number;
  if (!plan_file.empty()) number = sim_sessions_.open(plan_file);
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
  if (is_exit_word(text)) return Outcome::ended;
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
  const auto print_news = [&] {
    for (const std::string& news : sim_sessions_.take_news()) say_(news);
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
    print_news();
    say_(failure->message + local_hint(failure->message));
    return Outcome::failed;
  }
  print_news();
  if (is_statement) {
    const std::vector<std::string> names = local_names(text);
    locals_.insert(names.begin(), names.end());
  }
  luaL_checkstack(L, 4, "too many values");
  lua_pushcfunction(L, guard<print_values>);
  lua_insert(L, top + 1);
  std::vector<std::string> names = value_names(text);
  lua_pushlightuserdata(L, &names);
  lua_insert(L, top + 2);
  const auto failure = call_script(L, lua_gettop(L) - top - 1, 0);
  lua_settop(L, top);
  if (failure) {
    say_(failure->message);
    return Outcome::failed;
  }
  return Outcome::done;
}

// Hint for a local variable of an earlier line: each line is a separate chunk, so that its locals
// are not known on the next.
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
    std::string known;  // known part of the path, with its last dot
    for (std::size_t at = 0;;) {
      const std::size_t end = path.find_first_of(".:", at);
      if (end == std::string::npos) break;
      const std::string name = path.substr(at, end - at);
      const std::vector<std::string> members = member_names(L);
      if (std::ranges::find(members, name) == members.end()) return;
      luaL_checkstack(L, 8, "a path of names");
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
