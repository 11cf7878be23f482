#include "lua/host/soil_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "lua/api/constructors.h"
#include "lua/api/terrain_constructors.h"
#include "lua/host/event_library.h"
#include "lua/runtime/loader.h"

namespace lsos {

namespace {

Soil soil_on_top(lua_State* L, const Script& script, Faults& faults) {
  Soil soil;
  const ConstructedValue* made = to_constructed(L, -1);
  if (made != nullptr && made->kind == soil_kind) {
    soil = std::any_cast<Soil>(made->value);
  } else if (made == nullptr && lua_istable(L, -1)) {
    TableReader reader(L, lua_gettop(L), soil_kind, {script.file, 0}, faults);
    read_soil(reader, soil);
    reader.finish();
  } else {
    faults.error({script.file, 0},
                 fmt::format("must return a soil, a table {{...}} or lsos.soil {{...}}, found {}",
                             describe(L, -1)));
  }
  lua_pop(L, 1);
  return soil;
}

}  // namespace

Soil read_soil_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError({file, 0}, "cannot be read");
  Script script;
  script.kind = ScriptKind::soil;
  script.name = std::filesystem::path(file).stem().string();
  script.file = file;
  script.source = {std::istreambuf_iterator<char>(in), {}};

  EventLibrary library;
  Faults faults;
  Soil soil;
  library.lua().run([&](lua_State* L) {
    if (run_script(L, script, faults)) soil = soil_on_top(L, script, faults);
  });
  faults.throw_if_errors();
  soil.name = script.name;
  return soil;
}

}  // namespace lsos
