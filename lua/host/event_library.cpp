#include "lua/host/event_library.h"

#include <fmt/format.h>

#include <set>

#include "lua/api/event_constructors.h"
#include "lua/runtime/file_walk.h"
#include "lua/runtime/loader.h"

namespace lsos {

namespace {

using Events = std::map<std::string, EventScript>;

// Adds the events that `name` is composed of, at any depth, to `parts`.
void add_parts(const Events& events, const std::string& name, std::set<std::string>& parts) {
  const auto found = events.find(name);
  if (found == events.end()) return;
  for (const EventDeclaration::Phase& phase : found->second.declaration.phases) {
    if (!phase.sub_event.empty() && parts.insert(phase.sub_event).second) {
      add_parts(events, phase.sub_event, parts);
    }
  }
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

void check_event(const Events& events, const EventDeclaration& event, Faults& faults) {
  std::vector<std::string> names;
  for (const auto& [name, script] : events) names.push_back(name);
  for (const EventDeclaration::Phase& phase : event.phases) {
    if (phase.sub_event.empty() || events.contains(phase.sub_event)) continue;
    faults.error(event.place, fmt::format("event: phases: {}: no event '{}'{}", phase.name,
                                          phase.sub_event, did_you_mean(phase.sub_event, names)));
  }
  std::set<std::string> parts;
  add_parts(events, event.name, parts);
  if (parts.contains(event.name)) {
    faults.error(event.place,
                 fmt::format("event: '{}' contains itself through its sub-events", event.name));
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
    lua_getiuservalue(L, -1, 1);
    event.locals = record_locals(L, -1, event.declaration.place, faults);
    if (faults.has_errors()) return;
    event.functions = luaL_ref(L, LUA_REGISTRYINDEX);
    events_.insert_or_assign(event.declaration.name, std::move(event));
  });
}

void EventLibrary::check_sub_events(std::map<std::string, Faults>& faults) {
  // A removed event may be part of another one: repeat until nothing changes.
  for (bool is_changed = true; is_changed;) {
    std::vector<std::string> broken;
    for (const auto& [name, script] : events_) {
      Faults found;
      check_event(events_, script.declaration, found);
      if (!found.has_errors()) continue;
      faults[name].add(found.sorted());
      broken.push_back(name);
    }
    for (const std::string& name : broken) events_.erase(name);
    is_changed = !broken.empty();
  }
}

}  // namespace lsos
