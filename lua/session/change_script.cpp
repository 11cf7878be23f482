#include "lua/session/change_script.h"

#include <memory>

#include "base/bounded_file.h"
#include "base/console.h"
#include "base/error.h"
#include "lua/runtime/environment.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/loader.h"
#include "lua/runtime/module.h"
#include "lua/runtime/state.h"
#include "lua/session/session_api.h"
#include "lua/session/sim_sessions.h"

namespace lsos {

void run_change_script(SessionParts& parts, const std::string& file) {
  const std::string source = read_named_file(file);
  const auto say = [](const std::string& line) { print_message("{}\n", line); };
  LuaState lua(make_session_api, session_limits());
  SimSessions sessions(parts.folder->path(), say);
  const ScriptInstance number = sessions.adopt(std::make_unique<SimSession>(std::move(parts)));
  lua.context().interactive_rovers = &sessions;
  std::string failure_text;
  lua.run([&](lua_State* L) {
    auto failure = load_text(L, source, file);
    if (!failure) {
      push_open_environment(L);
      push_lsos_module(L);
      lua_setfield(L, -2, "lsos");
      push_handle(L, sim_handle_type(), number);
      lua_setfield(L, -2, "sim");
      lua_setupvalue(L, -2, 1);  // _ENV
      failure = call_script(L, 0, 0);
    }
    if (failure) failure_text = failure->message;
  });
  lua.context().interactive_rovers = nullptr;
  parts = sessions.release(number)->release();
  if (!failure_text.empty()) throw InputError({}, failure_text);
}

}  // namespace lsos
