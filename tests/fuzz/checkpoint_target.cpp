// What a checkpoint holds about a mission, and the state of an event script within it.
#include <lua.hpp>

#include "base/archive.h"
#include "base/error.h"
#include "fuzz/target.h"
#include "lua/api/api.h"
#include "lua/host/saved_mission.h"
#include "lua/runtime/state.h"
#include "lua/runtime/value.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lsos::test::Bytes bytes(data, size);
  const bool is_mission = bytes.byte() % 2 == 0;
  try {
    if (is_mission) {
      const lsos::SavedMission mission = lsos::saved_mission(bytes.rest());
      if (lsos::to_bytes(mission) != bytes.rest()) std::abort();
      lsos::differences(mission, "build", {{"renderer", "llvmpipe"}}, "out", false);
      return 0;
    }
    static lsos::LuaState lua(lsos::make_api);
    lua.run([&](lua_State* L) {
      lsos::Archive archive = lsos::Archive::reader(bytes.rest());
      lsos::restore_value(L, archive);
    });
  } catch (const lsos::Archive::Mismatch&) {
  }
  return 0;
}
