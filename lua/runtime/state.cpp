#include "lua/runtime/state.h"

#include <fmt/format.h>

#include <time.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <utility>

#include "base/utf8.h"
#include "lua/runtime/source_budget.h"

namespace lsos {

namespace {

// Once the budget is spent every later check raises again.
void raise_spent(lua_State* L, const char* place) {
  LuaContext& ctx = context(L);
  if (ctx.spent.empty()) {
    ctx.spent =
        fmt::format("{}more than {} instructions in one call (a loop or recursion without an end?)",
                    place, ctx.instructions_max);
  }
  lua_pushstring(L, ctx.spent.c_str());
  lua_error(L);
}

void raise_if_spent(lua_State* L) {
  LuaContext& ctx = context(L);
  const bool is_stopped = ctx.is_stop_wanted != nullptr && ctx.is_stop_wanted();
  const bool may_go_on = ctx.instructions_left > 0 && ctx.spent.empty();
  if (may_go_on && !is_stopped) return;
  char place[160];
  write_place(L, place, sizeof place);
  if (ctx.spent.empty() && is_stopped) ctx.spent = std::string(place) + "stopped";
  raise_spent(L, place);
}

void check_clock(lua_State* L) {
  LuaContext& ctx = context(L);
  const double now_s = cpu_now_s();
  if (!ctx.cpu_end_s) ctx.cpu_end_s = now_s + ctx.limits.cpu_s;
  if (now_s <= *ctx.cpu_end_s || !ctx.spent.empty()) return;
  char place[160];
  write_place(L, place, sizeof place);
  ctx.spent =
      fmt::format("{}more than {} s of the processor's time in one call", place, ctx.limits.cpu_s);
}

void count_hook(lua_State* L, lua_Debug*) {
  LuaContext& ctx = context(L);
  check_clock(L);
  ctx.instructions_left -= lua_gethookcount(L) * ctx.memory.weight();
  ctx.instructions_left -= ctx.memory.collect_if_due(L);
  raise_if_spent(L);
}

}  // namespace

double cpu_now_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void note_memory_spent(lua_State* L) {
  LuaContext& ctx = context(L);
  if (!ctx.spent.empty()) return;
  const ScriptMemory& memory = ctx.memory;
  const std::string_view why = memory.refusal() == nullptr ? "memory" : memory.refusal();
  ctx.spent = memory.refused_at();
  if (why == "traffic") {
    ctx.spent += fmt::format("more than {} MiB of texts and tables made in one call",
                             memory.traffic_max() >> 20);
  } else if (why == "stack") {
    ctx.spent += "too many values on the stack (a recursion without an end?)";
  } else {
    ctx.spent += fmt::format("more than {} MiB of memory for all scripts together",
                             memory.bytes_max() >> 20);
  }
}

namespace {

// A message cut to a readable length.
std::string shortened_message(const std::string& message) {
  constexpr std::size_t bytes_max = 4000;
  return message.size() <= bytes_max ? message : beginning(message, bytes_max) + "...";
}

// Whether a message begins with a place such as "file:12: ".
bool has_place(std::string_view message) {
  const std::size_t end = message.substr(0, 200).find(": ");
  if (end == std::string_view::npos || end == 0) return false;
  std::size_t digits = end;
  while (digits > 0 && std::isdigit(static_cast<unsigned char>(message[digits - 1])) != 0) --digits;
  return digits < end && digits > 1 && message[digits - 1] == ':';
}

// Message handler. An error may lack a place: its value is no text, or C code called C code.
int keep_traceback(lua_State* L) {
  std::string message = shortened_message(error_text(L, 1));
  if (!has_place(message)) {
    char place[160];
    write_place(L, place, sizeof place);
    message.insert(0, place);
  }
  luaL_traceback(L, L, nullptr, 1);
  context(L).traceback = lua_tostring(L, -1);
  lua_pushlstring(L, message.data(), message.size());
  return 1;
}

int call_body(lua_State* L) {
  const auto* body = static_cast<const std::function<void(lua_State*)>*>(lua_touserdata(L, 1));
  lua_settop(L, 0);
  try {
    (*body)(L);
    return 0;
  } catch (const std::exception&) {
    context(L).internal_error = std::current_exception();
  }
  lua_pushnil(L);
  return lua_error(L);
}

}  // namespace

LuaContext& context(lua_State* L) { return **static_cast<LuaContext**>(lua_getextraspace(L)); }

LuaState::LuaState(void (*make_libraries)(lua_State*), const Limits& limits)
    : context_(std::make_unique<LuaContext>(limits)) {
  L_ = lua_newstate(ScriptMemory::allocate, &context_->memory);
  LSOS_ASSERT(L_ != nullptr);
  *static_cast<LuaContext**>(lua_getextraspace(L_)) = context_.get();
  lua_gc(L_, LUA_GCSTOP);  // ScriptMemory collects
  try {
    run(make_libraries);
  } catch (const std::exception&) {
    lua_close(L_);
    throw;
  }
}

LuaState::~LuaState() { lua_close(L_); }

void LuaState::run(const std::function<void(lua_State*)>& body) {
  const int top = lua_gettop(L_);
  lua_pushcfunction(L_, call_body);
  lua_pushlightuserdata(L_, const_cast<std::function<void(lua_State*)>*>(&body));
  const int status = lua_pcall(L_, 1, 0, 0);
  if (status == LUA_OK) return;
  const std::string message = error_text(L_, -1);
  lua_settop(L_, top);
  if (status == LUA_ERRMEM) {
    note_memory_spent(L_);
    throw ScriptError(context_->spent);
  }
  if (const std::exception_ptr error = std::exchange(context_->internal_error, nullptr)) {
    std::rethrow_exception(error);
  }
  throw InternalError(message);
}

namespace {

// A text that is given to the parser line by line, which then can be stopped, and whose errors
// without a place have one.
struct Feed {
  std::string_view rest;
  int line = 1;  // that is read
  bool is_line_read = false;
  double cpu_end_s = 0;
};

const char* feed_line(lua_State* L, void* data, std::size_t* size) {
  constexpr std::size_t bytes_max = 256;
  Feed& feed = *static_cast<Feed*>(data);
  if (cpu_now_s() > feed.cpu_end_s) {
    lua_pushfstring(L, "takes more than %f s of the processor's time to compile",
                    context(L).limits.compile_cpu_s);
    lua_error(L);
  }
  const std::string_view begin = feed.rest.substr(0, bytes_max);
  const std::size_t end = begin.find('\n');
  const std::string_view line = begin.substr(0, end == std::string_view::npos ? end : end + 1);
  if (feed.is_line_read) ++feed.line;
  feed.is_line_read = end != std::string_view::npos;
  feed.rest.remove_prefix(line.size());
  *size = line.size();
  return line.data();
}

// Errors of the parser that are about its own stack do not say where.
std::string with_place(const std::string& message, const std::string& file, int line) {
  if (split_place(message, file).first.line != 0) return message;
  const bool is_nesting = message.find("C stack overflow") != std::string::npos;
  return fmt::format(
      "{}:{}: {}", file, line,
      is_nesting ? "is nested too deeply: brackets, blocks, functions, '..' and '^' may lie some "
                   "190 deep in each other"
                 : message);
}

}  // namespace

std::optional<LuaFailure> load_text(lua_State* L, const std::string& source,
                                    const std::string& file) {
  if (const auto fault = source_fault(source)) {
    if (fault->line == 0) return LuaFailure{fault->what, ""};
    return LuaFailure{fmt::format("{}:{}: {}", file, fault->line, fault->what), ""};
  }
  const std::string chunk = "@" + file;
  Feed feed{source, 1, false, cpu_now_s() + context(L).limits.compile_cpu_s};
  const int status = lua_load(L, feed_line, &feed, chunk.c_str(), "t");
  if (status == LUA_OK) return {};
  std::string message = error_text(L, -1);
  lua_pop(L, 1);
  if (status == LUA_ERRMEM) {
    return LuaFailure{fmt::format("more than {} MiB of memory for all scripts together",
                                  context(L).memory.bytes_max() >> 20),
                      ""};
  }
  return LuaFailure{with_place(message, file, feed.line), ""};
}

std::optional<LuaFailure> call_script(lua_State* L, int argument_count, int result_count,
                                      double share) {
  LuaContext& ctx = context(L);
  ctx.instructions_max =
      static_cast<std::int64_t>(static_cast<double>(ctx.limits.instructions) * share);
  ctx.instructions_left = ctx.instructions_max;
  ctx.cpu_end_s.reset();
  ctx.spent.clear();
  ctx.traceback.clear();
  ctx.equipment_fault.reset();
  ctx.notes = 0;
  ctx.note_bytes = 0;
  const std::int64_t traffic_max =
      std::min<std::int64_t>(ctx.instructions_max, 1 << 30) * bytes_per_instruction;
  ctx.memory.begin_call(L, static_cast<std::size_t>(traffic_max), ctx.call != nullptr);

  const int handler = lua_gettop(L) - argument_count;
  lua_pushcfunction(L, keep_traceback);
  lua_insert(L, handler);
  ctx.is_charging = true;
  lua_sethook(L, count_hook, LUA_MASKCOUNT, ctx.memory.hook_interval());
  const int status = lua_pcall(L, argument_count, result_count, handler);
  lua_sethook(L, nullptr, 0, 0);
  ctx.is_charging = false;
  ctx.memory.end_call();
  ctx.instructions_of_calls += ctx.instructions_max - ctx.instructions_left;
  lua_remove(L, handler);
  if (status == LUA_OK) return {};

  LuaFailure failure{error_text(L, -1), ctx.traceback};
  lua_pop(L, 1);
  if (ctx.internal_error) std::rethrow_exception(std::exchange(ctx.internal_error, nullptr));
  if (status == LUA_ERRMEM) note_memory_spent(L);
  if (!ctx.spent.empty()) failure.message = ctx.spent;
  return failure;
}

void charge(lua_State* L, std::int64_t instructions) {
  LuaContext& ctx = context(L);
  if (!ctx.is_charging) return;
  ctx.instructions_left -= instructions;
  ctx.instructions_left -= ctx.memory.collect_if_due(L);
  const bool may_go_on = ctx.instructions_left > 0 && ctx.spent.empty();
  if (!may_go_on || ctx.is_stop_wanted != nullptr) raise_if_spent(L);
}

void charge_bytes(lua_State* L, std::size_t bytes) {
  constexpr std::size_t bytes_per_charge = 16;  // handled in about the time of one Lua instruction
  charge(L, static_cast<std::int64_t>(bytes / bytes_per_charge));
}

void write_note(lua_State* L, const EventCall& call, const std::string& name,
                const std::string& fields_json) {
  LuaContext& ctx = context(L);
  ctx.notes += 1;
  ctx.note_bytes += name.size() + fields_json.size();
  if (ctx.notes > notes_max || ctx.note_bytes > note_bytes_max) {
    throw std::runtime_error(fmt::format(
        "a phase call may write {} notes of {} KiB together into the log; this is number {} with "
        "{} KiB",
        notes_max, note_bytes_max >> 10, ctx.notes, ctx.note_bytes >> 10));
  }
  call.phase.rover.note(name, fields_json);
}

const EventCall& running_call(lua_State* L, const char* what) {
  const EventCall* call = context(L).call;
  if (call == nullptr) {
    throw std::runtime_error(fmt::format("{} works only while a phase of an event runs", what));
  }
  return *call;
}

std::string error_text(lua_State* L, int index) {
  if (lua_type(L, index) == LUA_TSTRING) {
    std::size_t size = 0;
    const char* text = lua_tolstring(L, index, &size);
    return {text, size};
  }
  return fmt::format("an error whose value is a {} (only texts say what went wrong)",
                     luaL_typename(L, index));
}

std::pair<Place, std::string> split_place(const std::string& message, const std::string& file) {
  const Place whole{file, 0};
  std::size_t line_at = file.size();
  if (!message.starts_with(file + ":")) {
    // Lua shortens a long name to "...its/end.lua".
    line_at = message.find(".lua:");
    if (line_at == std::string::npos || !message.starts_with("...")) return {whole, message};
    line_at += 4;
    if (!file.ends_with(std::string_view(message).substr(3, line_at - 3))) return {whole, message};
  }
  int line = 0;
  const char* digits = message.c_str() + line_at + 1;
  const auto [end, error] = std::from_chars(digits, message.c_str() + message.size(), line);
  if (error != std::errc{} || end[0] != ':' || end[1] != ' ') return {whole, message};
  return {{file, line}, end + 2};
}

Place caller_place(lua_State* L) {
  lua_Debug ar;
  // Skips C functions in between, as when lsos.derive calls constructors.
  for (int level = 1;; ++level) {
    if (lua_getstack(L, level, &ar) == 0 || lua_getinfo(L, "Sl", &ar) == 0) return {};
    if (std::string_view(ar.what) != "C") break;
  }
  const std::string source = ar.source;
  return {source.starts_with('@') ? source.substr(1) : source, std::max(0, ar.currentline)};
}

int definition_line(lua_State* L) {
  lua_Debug ar;
  lua_pushvalue(L, -1);
  return lua_getinfo(L, ">S", &ar) != 0 ? ar.linedefined : 0;
}

void raise_error(lua_State* L, const std::string& whole) {
  const std::string message = shortened_message(whole);
  luaL_where(L, 1);
  const bool says_where = message.starts_with(lua_tostring(L, -1));  // has its place already
  lua_pushlstring(L, message.data(), message.size());
  if (!says_where) lua_concat(L, 2);
  lua_error(L);
  std::abort();  // lua_error does not return
}

void keep_internal_error(lua_State* L) { context(L).internal_error = std::current_exception(); }

}  // namespace lsos
