#include "lua/runtime/loader.h"

#include <fmt/format.h>

#include <algorithm>

#include "lua/runtime/environment.h"
#include "lua/runtime/shared_script.h"
#include "lua/runtime/state.h"

namespace lsos {

namespace {

// A traceback of the main chunk alone adds nothing to the message's place and is dropped.
std::string useful_traceback(const std::string& traceback) {
  const auto is_chunk_only = std::ranges::count(traceback, '\n') <= 3;
  return is_chunk_only ? "" : "\n" + traceback;
}

void add_failure(const Script& script, const LuaFailure& failure, Faults& faults) {
  const auto [place, what] = split_place(failure.message, script.file);
  faults.error(place, what + useful_traceback(failure.traceback));
}

}  // namespace

bool run_script(lua_State* L, const Script& script, Faults& faults) {
  forget_shared_scripts(L);
  if (!script.unread.empty()) {
    faults.error({script.file, 0}, script.unread);
    return false;
  }
  const TextOwner owner(context(L).memory, ++context(L).scripts_loaded);
  if (const auto failure = load_text(L, script.source, script.file)) {
    add_failure(script, *failure, faults);
    return false;
  }
  push_environment(L);
  lua_setupvalue(L, -2, 1);  // _ENV
  Faults found;
  context(L).load_faults = &found;
  context(L).loading = &script;
  const auto failure = call_script(L, 0, 1);
  context(L).load_faults = nullptr;
  context(L).loading = nullptr;
  faults.add(found.sorted());
  if (failure) add_failure(script, *failure, faults);
  if (!failure && found.has_errors()) lua_pop(L, 1);
  return !failure && !found.has_errors();
}

const ConstructedValue* load_script(lua_State* L, const Script& script, const char* kind,
                                    Faults& faults) {
  if (!run_script(L, script, faults)) return nullptr;
  const ConstructedValue* made = to_constructed(L, -1);
  if (made != nullptr && made->kind == kind) return made;
  faults.error({script.file, 0},
               fmt::format("must return lsos.{} {{...}}, found {}", kind, describe(L, -1)));
  lua_pop(L, 1);
  return nullptr;
}

}  // namespace lsos
