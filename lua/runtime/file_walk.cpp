#include "lua/runtime/file_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "lua/runtime/read_only.h"
#include "lua/runtime/state.h"
#include "lua/runtime/vec3.h"

namespace lsos {

namespace {

// Each value is looked at after each call, so that many would make every phase slow.
constexpr std::size_t walked_values_max = 10'000;

// Tables of the engine that hold functions of an event: all of them, its phases, a phase that is
// another event.
constexpr int engine_deep = 3;

// Where the function at `index` begins.
Place value_place(lua_State* L, int index) {
  lua_Debug ar;
  lua_pushvalue(L, index);
  if (lua_getinfo(L, ">S", &ar) == 0) return {};
  const std::string_view source = ar.source;
  return {std::string(source.starts_with('@') ? source.substr(1) : source), ar.linedefined};
}

auto in_order(const Place& place) { return std::tie(place.file, place.line); }

// Replaces the view of a script of lib/ at the top by what it shows. False, and nothing is changed,
// for another view: what the program has shows nothing that can change.
bool enter_view(lua_State* L) {
  if (!push_shown_script(L, -1)) return false;
  lua_remove(L, -2);
  return true;
}

}  // namespace

FileLocals record_locals(lua_State* L, int index, const Place& place, Faults& faults) {
  FileLocals locals;
  FileWalk(L, locals).record(lua_absindex(L, index), place, faults);
  return locals;
}

void FileWalk::record(int functions, const Place& place, Faults& faults) {
  const int top = lua_gettop(L_);
  luaL_checkstack(L_, 24, nullptr);
  lua_newtable(L_);
  kept_ = lua_gettop(L_);
  lua_pushvalue(L_, functions);
  add_engine_table(engine_deep);
  lua_settop(L_, kept_);
  for (std::size_t node = 0; node < nodes_.size() && values_ <= walked_values_max; ++node) {
    if (nodes_[node].is_function) {
      visit_function(node);
    } else {
      visit_table(node);
    }
    lua_settop(L_, kept_);
  }
  if (values_ > walked_values_max) {
    faults.error(place, fmt::format("event: its functions reach more than {} values in locals of "
                                    "the file; all are looked at after each call, as only ev.state "
                                    "may change",
                                    walked_values_max));
  } else {
    name_nodes();
    add_hole_fault(faults);
  }
  into_.kept_ = luaL_ref(L_, LUA_REGISTRYINDEX);
  lua_settop(L_, top);
}

lua_Integer FileWalk::keep() {
  lua_rawseti(L_, kept_, ++kept_count_);
  return kept_count_;
}

std::size_t FileWalk::add() {
  const bool is_table = lua_istable(L_, -1);
  const bool is_part = (is_table && (!is_view(L_, -1) || enter_view(L_))) || lua_isfunction(L_, -1);
  if (!is_part) {
    lua_pop(L_, 1);
    return none;
  }
  const auto [known, is_new] = known_.try_emplace(lua_topointer(L_, -1), nodes_.size());
  if (!is_new) {
    lua_pop(L_, 1);
    return known->second;
  }
  ++values_;
  if (is_table) into_.addresses_.insert(known->first);
  nodes_.push_back({keep(), !is_table});
  return known->second;
}

void FileWalk::add_engine_table(int deep) {
  const int table = lua_gettop(L_);
  for (lua_pushnil(L_); lua_next(L_, table) != 0;) {
    if (deep > 1 && lua_istable(L_, -1)) {
      add_engine_table(deep - 1);
      lua_pop(L_, 1);
    } else {
      add();
    }
  }
}

void FileWalk::visit_function(std::size_t node) {
  lua_rawgeti(L_, kept_, nodes_[node].at);
  const int function = lua_gettop(L_);
  const bool is_iterator = lua_iscfunction(L_, function) != 0;
  const Place place = value_place(L_, function);
  for (int n = 1; const char* name = lua_getupvalue(L_, function, n); ++n) {
    const auto [known, is_new] =
        locals_by_id_.try_emplace(lua_upvalueid(L_, function, n), locals_.size());
    if (!is_new) {
      Local& local = locals_[known->second];
      if (in_order(place) < in_order(local.place)) local.place = place;
      lua_pop(L_, 1);
      continue;
    }
    ++values_;
    const ExactValue exact = exact_value(L_, -1);
    lua_pushvalue(L_, -1);
    into_.variables_.push_back({name, is_iterator, n, nodes_[node].at, keep(), exact});
    iterators_.push_back(is_iterator ? node : none);
    const std::size_t held = add();
    if (is_iterator && held != none) nodes_[node].parts.push_back(held);
    locals_.push_back({name, place, is_iterator ? none : held});
  }
}

void FileWalk::visit_table(std::size_t node) {
  lua_rawgeti(L_, kept_, nodes_[node].at);
  const int table = lua_gettop(L_);
  FileLocals::Table known{"", nodes_[node].at, into_.entries_.size()};
  // What follows the table in the kept table is its copy and its metatable, so its place is anew.
  lua_pushvalue(L_, table);
  known.at = keep();
  lua_newtable(L_);
  const int copy = lua_gettop(L_);
  lua_pushvalue(L_, copy);
  keep();
  if (lua_getmetatable(L_, table) == 0) lua_pushnil(L_);
  known.metatable = exact_value(L_, -1);
  const bool is_own = lua_istable(L_, -1) && !is_vec3(L_, table) && !is_metatable_of_view(L_, -1);
  lua_pushvalue(L_, -1);
  keep();
  const std::size_t metatable = is_own ? add() : none;
  if (metatable != none) nodes_[node].parts.push_back(metatable);
  add_entries(node, table, copy);
  known.count = into_.entries_.size() - known.first;
  nodes_[node].table = into_.tables_.size();
  into_.tables_.push_back(std::move(known));
}

void FileWalk::add_entries(std::size_t node, int table, int copy) {
  const auto add_part = [&] {
    const std::size_t part = add();
    if (part != none) nodes_[node].parts.push_back(part);
  };
  lua_Integer numbers = 0, last = 0;
  for (lua_pushnil(L_); values_ <= walked_values_max && lua_next(L_, table) != 0;) {
    ++values_;
    into_.entries_.push_back({exact_value(L_, -2), exact_value(L_, -1)});
    lua_pushvalue(L_, -2);
    lua_pushvalue(L_, -2);
    lua_rawset(L_, copy);
    if (lua_isinteger(L_, -2) != 0 && lua_tointeger(L_, -2) > 0) {
      ++numbers;
      last = std::max(last, lua_tointeger(L_, -2));
    }
    add_part();
    lua_pushvalue(L_, -1);
    add_part();
  }
  if (values_ > walked_values_max || numbers == last) return;
  Hole hole{node, 1, last};
  for (; lua_rawgeti(L_, table, hole.absent) != LUA_TNIL; ++hole.absent) lua_pop(L_, 1);
  lua_pop(L_, 1);
  for (lua_pushnil(L_); lua_next(L_, table) != 0; lua_pop(L_, 1)) {
    const lua_Integer number = lua_isinteger(L_, -2) != 0 ? lua_tointeger(L_, -2) : 0;
    if (number > hole.absent) hole.found = std::min(hole.found, number);
  }
  holes_.push_back(hole);
}

// Names what is reached through a local by that local. The order of the walk may differ from run to
// run, as that of Lua's tables does; that of names does not.
void FileWalk::name_nodes() {
  std::ranges::stable_sort(locals_, [](const Local& a, const Local& b) {
    return std::tie(a.name, a.place.file, a.place.line) <
           std::tie(b.name, b.place.file, b.place.line);
  });
  std::vector<std::size_t> open;
  for (const Local& local : locals_) {
    if (local.holds != none) open.push_back(local.holds);
    while (!open.empty()) {
      Node& node = nodes_[open.back()];
      open.pop_back();
      if (!node.name.empty()) continue;
      node.name = local.name;
      node.place = local.place;
      if (node.table != none) into_.tables_[node.table].name = local.name;
      open.insert(open.end(), node.parts.begin(), node.parts.end());
    }
  }
  for (std::size_t i = 0; i < iterators_.size(); ++i) {
    if (iterators_[i] != none) into_.variables_[i].name = nodes_[iterators_[i]].name;
  }
}

// How long Lua says a list with holes to be depends on what was last read of it: reading would be
// enough to remember something.
void FileWalk::add_hole_fault(Faults& faults) {
  // What no local leads to is read by the engine alone.
  std::erase_if(holes_, [&](const Hole& hole) { return nodes_[hole.node].name.empty(); });
  if (holes_.empty()) return;
  const auto key = [&](const Hole& hole) {
    const Node& node = nodes_[hole.node];
    return std::tuple(node.place.file, node.place.line, node.name, hole.absent, hole.found);
  };
  const Hole& hole = *std::ranges::min_element(holes_, {}, key);
  const Node& node = nodes_[hole.node];
  faults.error(node.place,
               fmt::format("'{}', a local of the file that is used here: [{}] without [{}]; a list "
                           "begins at 1 and has no holes, as its length would depend on earlier "
                           "calls; use text keys otherwise",
                           node.name, hole.found, hole.absent));
}

}  // namespace lsos
