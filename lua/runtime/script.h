// A script file as read from disk, and the folders they come from.
#pragma once

#include <string>

namespace lsos {

enum class ScriptKind { event, rover, terrain, soil };

struct Script {
  ScriptKind kind = ScriptKind::event;
  std::string name;    // "Route": the file's name without .lua
  std::string file;    // as shown to users and in messages: "events/Route.lua"
  std::string folder;  // where it lies; what it names relative to itself is found there
  std::string source;
  std::string sha256;  // of the source
};

// A folder of scripts, and what its files are called in messages: `shown`/events/Route.lua.
struct ScriptFolder {
  std::string path;
  std::string shown;  // "" for the shipped ones
};

}  // namespace lsos
