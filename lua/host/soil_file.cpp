#include "lua/host/soil_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/bounded_file.h"
#include "lua/api/constructors.h"
#include "lua/api/terrain_constructors.h"
#include "lua/host/event_library.h"
#include "lua/runtime/loader.h"
#include "lua/runtime/source_budget.h"

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
  FileBounds bounds;
  bounds.bytes_max = source_bytes_max;
  Parsed<std::string> source = read_bounded(file, bounds);
  if (!source) throw InputError({file, 0}, source.why);
  Script script;
  script.kind = ScriptKind::soil;
  script.name = std::filesystem::path(file).stem().string();
  script.file = file;
  script.source = *std::move(source.value);

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
