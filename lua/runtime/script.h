// A script file as read from disk, and the folders of scripts.
#pragma once

#include <string>

namespace lsos {

enum class ScriptKind { event, rover, terrain, soil, shared };  // shared: in lib/

struct Script {
  ScriptKind kind = ScriptKind::event;
  std::string name;    // "Route": the file's name without .lua
  std::string file;    // as shown to users and in messages: "events/Route.lua"
  std::string folder;  // its folder; base of relative names in it
  std::string source;
  std::string sha256;  // of the source
  std::string unread;  // why the source is not here: "is a folder"; "" where it is
  bool is_shipped = false;
};

// A folder of scripts, and the prefix of its files' names in messages: `shown`/events/Route.lua.
struct ScriptFolder {
  std::string path;
  std::string shown;  // "" for the shipped ones
};

}  // namespace lsos
