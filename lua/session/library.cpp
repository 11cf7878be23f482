// Writes lua/library.d.lua: the registry as annotations for the Lua language server.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lua/runtime/handle.h"
#include "lua/session/reference.h"
#include "lua/session/scenario.h"
#include "lua/session/session_api.h"
#include "lua/session/sim_sessions.h"

namespace lsos {

namespace {

constexpr const char* head = R"(---@meta lsos
-- The lsos module for editors with the Lua language server, made from what is bound to Lua: point
-- `workspace.library` of its settings to this file's folder. A phase is
--   ---@param ev lsos.ev
--   ---@param rover lsos.rover

---@class vec3
---@field x number
---@field y number
---@field z number
---@field length fun(self: vec3): number
---@field dot fun(self: vec3, other: vec3): number
---@field cross fun(self: vec3, other: vec3): vec3
---@operator add(vec3): vec3
---@operator sub(vec3): vec3
---@operator mul(number): vec3
---@operator div(number): vec3
---@operator unm: vec3

---@class lsos.answer
---@class lsos.made
)";

// Type for the language server from the documentation's, such as "number, m, above 0".
std::string type_of(std::string text) {
  static const std::map<std::string, std::string> known{
      {"number", "number"},
      {"integer", "integer"},
      {"boolean", "boolean"},
      {"text", "string"},
      {"vec3", "vec3"},
      {"table", "table"},
      {"list of numbers", "number[]"},
      {"list of texts", "string[]"},
      {"list of vec3", "vec3[]"},
      {"list of tables", "table[]"},
      {"table of rover", "table<string, lsos.rover>"},
      {"list of rings", "vec3[][]"},
      {"ev.geometry", "lsos.ev.geometry"},
      {"rover.drive", "lsos.rover.drive"},
      {"rover.battery", "lsos.rover.battery?"},
      {"rover.panels", "lsos.rover.panels"},
      {"rover.antennas", "lsos.rover.antennas"}};
  text = text.substr(0, text.find(','));
  const auto found = known.find(text);
  if (found != known.end()) return found->second;
  if (text.starts_with("list of ")) return "table[]";
  return text.starts_with("table") ? "table" : "any";
}

std::string class_of(const HandleType& type) {
  const std::string is_a = *type.is_a == '\0' ? "" : fmt::format(": {}", type.is_a);
  std::string text = fmt::format("\n---{}\n---@class lsos.{}{}\n", type.doc, type.name, is_a);
  for (const HandleField& field : type.fields) {
    text += fmt::format("---@field {} {} {}\n", field.name, type_of(field.type), field.doc);
  }
  for (const HandleMethod& method : type.methods) {
    text += fmt::format("---@field {} {} {}\n", method.name, method.type, method.doc);
  }
  return text;
}

std::string keys_of(const Constructor& constructor) {
  std::vector<KeyDoc> keys;
  TableReader reader(keys);
  constructor.list_keys(reader);
  std::string text = fmt::format("\n---@class lsos.{}.keys\n", constructor.name);
  for (const KeyDoc& key : keys) {
    text += fmt::format("---@field {}{} {} {}\n", key.key, key.is_required ? "" : "?",
                        type_of(key.type), key.doc);
  }
  return text;
}

}  // namespace

std::string api_library() {
  std::string text = head;
  for (const HandleType* type : scripted_objects()) text += class_of(*type);
  std::string module = "\n---@class lsos\n";
  for (const ApiFunction& entry : all_functions()) {
    module += fmt::format("---@field {} {} {}\n", entry.name, entry.type, entry.doc);
  }
  for (const ApiConstant& entry : api_constants()) {
    module += fmt::format("---@field {} lsos.answer {}\n", entry.name, entry.doc);
  }
  for (const ApiSection& section : api_sections()) {
    for (const Constructor& entry : section.constructors) {
      text += keys_of(entry);
      module += fmt::format("---@field {} fun(keys: lsos.{}.keys): lsos.made {}\n", entry.name,
                            entry.name, entry.doc);
    }
  }
  return text + module + "local lsos = {}\n\nreturn lsos\n";
}

}  // namespace lsos
