#include "lua/state.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <utility>

#include "lua/api.h"
#include "lua/sandbox.h"

namespace lsos {

namespace {

// Instructions between two looks of the count hook.
constexpr int hook_interval = 1000;

// Writes the place of the innermost script function without allocating.
void note_place(lua_State* L, char* text, std::size_t size) {
  lua_Debug ar;
  text[0] = '\0';
  for (int level = 0; lua_getstack(L, level, &ar) == 1; ++level) {
    if (lua_getinfo(L, "Sl", &ar) == 0 || ar.currentline < 0) continue;
    std::snprintf(text, size, "%s:%d: ", ar.short_src, ar.currentline);
    return;
  }
}

void* allocate(void* data, void* block, std::size_t old_size, std::size_t new_size) {
  auto& context = *static_cast<LuaContext*>(data);
  if (block == nullptr) old_size = 0;  // then it is the kind of object
  if (new_size == 0) {
    std::free(block);
    context.memory_bytes -= old_size;
    return nullptr;
  }
  if (new_size > old_size &&
      context.memory_bytes - old_size + new_size > context.limits.memory_bytes) {
    if (context.L != nullptr) note_place(context.L, context.refused_at, sizeof context.refused_at);
    return nullptr;
  }
  void* moved = std::realloc(block, new_size);
  if (moved != nullptr) context.memory_bytes += new_size - old_size;
  return moved;
}

void raise_spent(lua_State* L, const char* place) {
  LuaContext& ctx = context(L);
  if (ctx.spent.empty()) {
    ctx.spent = fmt::format("{}more than {} instructions in one call (a loop without an end?)",
                            place, ctx.limits.instructions);
  }
  lua_pushstring(L, ctx.spent.c_str());
  lua_error(L);
}

// luaL_error finds no position inside a hook, so the place comes from the hook's own record. Once
// the budget is spent every later look raises again.
void count_hook(lua_State* L, lua_Debug* ar) {
  LuaContext& ctx = context(L);
  ctx.instructions_left -= hook_interval;
  if (ctx.instructions_left > 0 && ctx.spent.empty()) return;
  char place[sizeof ctx.refused_at] = "";
  if (lua_getinfo(L, "Sl", ar) != 0) {
    std::snprintf(place, sizeof place, "%s:%d: ", ar->short_src, ar->currentline);
  }
  raise_spent(L, place);
}

}  // namespace

void note_memory_spent(lua_State* L) {
  LuaContext& ctx = context(L);
  if (!ctx.spent.empty()) return;
  ctx.spent = fmt::format("{}more than {} MiB of memory for all scripts together", ctx.refused_at,
                          ctx.limits.memory_bytes >> 20);
}

namespace {

int keep_traceback(lua_State* L) {
  const std::string message = error_text(L, 1);
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

LuaState::LuaState(const Limits& limits) : context_(std::make_unique<LuaContext>()) {
  context_->limits = limits;
  L_ = lua_newstate(allocate, context_.get());
  LSOS_ASSERT(L_ != nullptr);
  *static_cast<LuaContext**>(lua_getextraspace(L_)) = context_.get();
  context_->L = L_;
  try {
    run([](lua_State* L) {
      make_sandbox(L);
      make_api(L);
    });
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

std::optional<LuaFailure> load_text(lua_State* L, const std::string& source,
                                    const std::string& file) {
  const std::string chunk = "@" + file;
  if (luaL_loadbufferx(L, source.data(), source.size(), chunk.c_str(), "t") == LUA_OK) return {};
  LuaFailure failure{error_text(L, -1), ""};
  lua_pop(L, 1);
  return failure;
}

std::optional<LuaFailure> call_script(lua_State* L, int argument_count, int result_count) {
  LuaContext& ctx = context(L);
  ctx.instructions_left = ctx.limits.instructions;
  ctx.spent.clear();
  ctx.traceback.clear();
  ctx.refused_at[0] = '\0';

  const int handler = lua_gettop(L) - argument_count;
  lua_pushcfunction(L, keep_traceback);
  lua_insert(L, handler);
  lua_sethook(L, count_hook, LUA_MASKCOUNT, hook_interval);
  const int status = lua_pcall(L, argument_count, result_count, handler);
  lua_sethook(L, nullptr, 0, 0);
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
  ctx.instructions_left -= instructions;
  if (ctx.instructions_left > 0 && ctx.spent.empty()) return;
  char place[sizeof ctx.refused_at];
  note_place(L, place, sizeof place);
  raise_spent(L, place);
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
  if (lua_getstack(L, 1, &ar) == 0 || lua_getinfo(L, "Sl", &ar) == 0) return {};
  const std::string source = ar.source;
  return {source.starts_with('@') ? source.substr(1) : source, std::max(0, ar.currentline)};
}

void raise_error(lua_State* L, const std::string& message) {
  luaL_where(L, 1);
  const bool says_where = message.starts_with(lua_tostring(L, -1));  // a fault with its place
  lua_pushlstring(L, message.data(), message.size());
  if (!says_where) lua_concat(L, 2);
  lua_error(L);
  std::abort();  // lua_error does not return
}

void keep_internal_error(lua_State* L) { context(L).internal_error = std::current_exception(); }

}  // namespace lsos
