// Constructors such as lsos.wheel {...}: functions that read a table into a C++ value while a
// script loads.
#pragma once

#include <fmt/format.h>

#include <lua.hpp>
#include <set>
#include <string>
#include <vector>

#include "lua/runtime/reader.h"
#include "lua/runtime/state.h"

namespace lsos {

// A constructor as it is registered and documented.
struct Constructor {
  const char* name;
  lua_CFunction function;  // its upvalue 1 is the name
  void (*list_keys)(TableReader&);
  const char* doc;
};

std::vector<Constructor> field_constructors();
std::vector<Constructor> event_constructors();
std::vector<Constructor> rover_constructors();
// Parts of rover_constructors().
std::vector<Constructor> suspension_constructors();
std::vector<Constructor> power_constructors();
std::vector<Constructor> asset_constructors();
std::vector<Constructor> terrain_constructors();
std::vector<Constructor> study_constructors();

// The name of the constructor that runs, and a reader of its one argument.
TableReader constructor_reader(lua_State* L);

// Keeps a copy of the table at `index` as the user value of the object at the top, which was made
// from it. lsos.derive builds a changed object from this copy.
void keep_keys(lua_State* L, int index);

// "Route" for "events/Route.lua": scripts are named by their files.
std::string script_name(const std::string& file);

template <class T, void (*read)(TableReader&, T&)>
int construct(lua_State* L) {
  TableReader t = constructor_reader(L);
  T value;
  read(t, value);
  t.finish();
  push_constructed(L, {t.what(), t.place(), std::move(value)});
  keep_keys(L, 1);
  return 1;
}

template <class T, void (*read)(TableReader&, T&)>
Constructor constructor(const char* name, const char* doc) {
  return {name, guard<construct<T, read>>,
          [](TableReader& t) {
            T value;
            read(t, value);
          },
          doc};
}

// Adds a fault for each name that two entries share.
template <class T>
void check_unique_names(TableReader& t, const char* key, const std::vector<T>& all) {
  std::set<std::string> names;
  for (const T& one : all) {
    if (!names.insert(one.name).second) {
      t.fault(fmt::format("{}: '{}' is the name of two", key, one.name));
    }
  }
}

}  // namespace lsos
