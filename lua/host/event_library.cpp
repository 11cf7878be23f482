#include "lua/host/event_library.h"

#include <fmt/format.h>

#include <set>

#include "lua/api/event_constructors.h"
#include "lua/runtime/file_walk.h"
#include "lua/runtime/loader.h"

namespace lsos {

namespace {

using Events = std::map<std::string, EventScript>;

// The events that events are composed of, by number.
using Parts = std::vector<std::vector<std::size_t>>;

Parts parts_of(const Events& events) {
  std::map<std::string, std::size_t> numbers;
  for (const auto& [name, script] : events) numbers.emplace(name, numbers.size());
  Parts parts;
  for (const auto& [name, script] : events) {
    std::set<std::size_t> own;
    for (const EventDeclaration::Phase& phase : script.declaration.phases) {
      const auto part = numbers.find(phase.sub_event);
      if (part != numbers.end()) own.insert(part->second);
    }
    parts.emplace_back(own.begin(), own.end());
  }
  return parts;
}

// Whether the event is a part of itself, at any depth.
bool contains_itself(const Parts& parts, std::size_t event) {
  std::vector<bool> is_seen(parts.size(), false);
  for (std::vector<std::size_t> open{event}; !open.empty();) {
    const std::size_t at = open.back();
    open.pop_back();
    for (const std::size_t part : parts[at]) {
      if (part == event) return true;
      if (is_seen[part]) continue;
      is_seen[part] = true;
      open.push_back(part);
    }
  }
  return false;
}

std::set<std::string> events_within_themselves(const Events& events) {
  std::set<std::string> found;
  const Parts parts = parts_of(events);
  std::size_t number = 0;
  for (const auto& [name, script] : events) {
    if (contains_itself(parts, number++)) found.insert(name);
  }
  return found;
}

// A script that commands panels or antennas contains one of these words.
bool may_deploy(const Script& script, const LuaContext& context) {
  const auto says = [](const std::string& source) {
    return source.find("deploy") != std::string::npos || source.find("stow") != std::string::npos;
  };
  return says(script.source) || (context.scripts != nullptr &&
                                 std::ranges::any_of(*context.scripts, [&](const Script& other) {
                                   return other.kind == ScriptKind::shared &&
                                          context.required.contains(other.name) &&
                                          says(other.source);
                                 }));
}

void check_parts(const Events& events, const EventDeclaration& event, Faults& faults) {
  for (const EventDeclaration::Phase& phase : event.phases) {
    if (phase.sub_event.empty() || events.contains(phase.sub_event)) continue;
    std::vector<std::string> names;
    for (const auto& [name, script] : events) names.push_back(name);
    faults.error(event.place, fmt::format("event: phases: {}: no event '{}'{}", phase.name,
                                          phase.sub_event, did_you_mean(phase.sub_event, names)));
  }
}

}  // namespace

void EventLibrary::load(const Script& script, Faults& faults) {
  lua_.run([&](lua_State* L) {
    const ConstructedValue* made = load_script(L, script, event_kind, faults);
    if (made == nullptr) return;
    EventScript event;
    event.declaration = std::any_cast<const EventDeclaration&>(made->value);
    event.declaration.may_deploy_unsaid = may_deploy(script, lua_.context());
    event.file = script.file;
    event.number = lua_.context().scripts_loaded;
    lua_getiuservalue(L, -1, 1);
    event.locals = record_locals(L, -1, event.declaration.place, faults);
    if (faults.has_errors()) return;
    event.functions = luaL_ref(L, LUA_REGISTRYINDEX);
    events_.insert_or_assign(event.declaration.name, std::move(event));
  });
}

void EventLibrary::remove(const std::string& name) {
  const auto event = events_.find(name);
  if (event == events_.end()) return;
  const int functions = event->second.functions;
  lua_.run([&](lua_State* L) { luaL_unref(L, LUA_REGISTRYINDEX, functions); });
  events_.erase(event);
}

void EventLibrary::run(const EventScript& event, const std::function<void(lua_State*)>& body) {
  const TextOwner owner(lua_.context().memory, event.number);
  lua_.run(body);
}

void EventLibrary::check_sub_events(std::map<std::string, Faults>& faults) {
  const std::set<std::string> within_themselves = events_within_themselves(events_);
  std::map<std::string, std::set<std::string>> users;  // events, by a part of theirs
  std::set<std::string> unchecked;
  for (const auto& [name, script] : events_) {
    unchecked.insert(name);
    for (const EventDeclaration::Phase& phase : script.declaration.phases) {
      users[phase.sub_event].insert(name);
    }
  }
  // A removed event may be part of others, which then are broken too.
  while (!unchecked.empty()) {
    std::vector<std::string> broken;
    for (const std::string& name : unchecked) {
      const auto event = events_.find(name);
      if (event == events_.end()) continue;
      const EventDeclaration& declaration = event->second.declaration;
      Faults found;
      check_parts(events_, declaration, found);
      if (within_themselves.contains(name)) {
        found.error(declaration.place,
                    fmt::format("event: '{}' contains itself through its sub-events", name));
      }
      if (!found.has_errors()) continue;
      faults[name].add(found.sorted());
      broken.push_back(name);
    }
    unchecked.clear();
    for (const std::string& name : broken) {
      events_.erase(name);
      unchecked.insert(users[name].begin(), users[name].end());
    }
  }
}

}  // namespace lsos
