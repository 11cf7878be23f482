#include "lua/host/host.h"

#include <fmt/format.h>

#include <map>

#include "base/utf8.h"
#include "lua/api/answer.h"
#include "lua/api/arguments.h"
#include "lua/api/breakage.h"
#include "lua/api/resources.h"
#include "lua/api/route.h"
#include "lua/api/rover_facts.h"
#include "lua/host/condition.h"
#include "lua/host/event_library.h"
#include "lua/host/phase_failure.h"
#include "lua/runtime/constructed_value.h"
#include "lua/runtime/handle.h"
#include "lua/runtime/value.h"

namespace lsos {

namespace {

constexpr std::string_view state_version = "ev.state 1";
constexpr std::size_t ending_bytes_max = 1000;  // of the text that on_abort returns

// Marks the phase call as running, for handles and lsos functions.
class CallScope {
 public:
  CallScope(LuaContext& context, const EventCall& call) : context_(context) {
    LSOS_ASSERT(context.call == nullptr);
    context.call = &call;
  }
  ~CallScope() { context_.call = nullptr; }
  CallScope(const CallScope&) = delete;
  CallScope& operator=(const CallScope&) = delete;

 private:
  LuaContext& context_;
};

}  // namespace

struct LuaHost::Impl {
  // An event that runs. `table` is a registry reference to { params, geometry, state, ev, rover }.
  struct Instance {
    const EventScript* script = nullptr;
    EventArguments arguments;
    std::optional<RandomStream> random;
    std::string last_phase;
    int table = LUA_NOREF;
  };

  EventLibrary library;
  Declarations declarations;
  std::map<ScriptInstance, Instance> instances;
  ScriptInstance last_id = 0;

  explicit Impl(const Limits& limits) : library(limits) {}

  Instance& at(ScriptInstance id) {
    const auto found = instances.find(id);
    LSOS_ASSERT(found != instances.end());
    return found->second;
  }

  // Pushes the instance's table; entries that need the phase's context are made at the first call.
  void push_table(lua_State* L, ScriptInstance id, Instance& instance, const EventCall& call) {
    lua_rawgeti(L, LUA_REGISTRYINDEX, instance.table);
    if (lua_getfield(L, -1, "ev") != LUA_TNIL) return lua_pop(L, 1);
    lua_pop(L, 1);
    push_params(L, instance.script->declaration, instance.arguments, call.phase.mission_start);
    lua_setfield(L, -2, "params");
    push_geometry(L, id);
    lua_setfield(L, -2, "geometry");
    push_handle(L, rover_handle_type(), id);
    lua_setfield(L, -2, "rover");
    push_handle(L, event_handle_type(), id);
    lua_pushvalue(L, -2);
    lua_setiuservalue(L, -2, 1);
    lua_setfield(L, -2, "ev");
  }

  // Calls the script function at the top with (ev, rover), pops it and leaves `results` values.
  // Throws EquipmentFault where the rover could not do what the script commanded, and
  // std::runtime_error where the script changed a local of its file.
  void call(lua_State* L, ScriptInstance id, Instance& instance, const EventCall& call,
            const std::string& where, int results) {
    push_table(L, id, instance, call);
    lua_getfield(L, -1, "ev");
    lua_getfield(L, -2, "rover");
    lua_remove(L, -3);
    const CallScope scope(library.lua().context(), call);
    const auto failure = call_script(L, 2, results);
    const std::string touched = instance.script->locals.restore(L);
    if (failure) {
      // A script may have caught this fault and then have failed for another reason.
      const std::optional<std::string>& fault = library.lua().context().equipment_fault;
      if (fault && failure->message.ends_with(*fault)) throw EquipmentFault(*fault);
      throw ScriptError(phase_failure(*failure, *instance.script, where, call.phase));
    }
    if (touched.empty()) return;
    throw std::runtime_error(
        fmt::format("it {}, which all events of the type would share and no mission saves; keep "
                    "what lasts in ev.state",
                    touched));
  }

  PhaseAnswer run_function(lua_State* L, ScriptInstance id, Instance& instance,
                           const EventCall& event_call, const std::string& where) {
    const int base = lua_gettop(L) - 1;
    call(L, id, instance, event_call, where, LUA_MULTRET);
    return read_answer(L, base, instance.script->declaration);
  }

  PhaseAnswer run_sub_event(lua_State* L, ScriptInstance id, Instance& instance,
                            const EventCall& event_call, const EventDeclaration::Phase& phase,
                            const std::string& where) {
    const EventDeclaration& child = library.events().at(phase.sub_event).declaration;
    RunEvent answer{phase.sub_event, {}, phase.next};
    const auto push_part = [&](const char* name) {
      if (lua_getfield(L, -1, name) == LUA_TFUNCTION) {
        call(L, id, instance, event_call, where, 1);
      }
    };
    push_part("params");
    answer.arguments.params = read_params(L, -1, child, event_call.phase.mission_start);
    lua_pop(L, 1);
    push_part("geometry");
    const CallScope scope(library.lua().context(), event_call);  // the geometry may be ev.geometry
    read_waypoints(L, -1, child, answer.arguments);
    return answer;
  }

  // Calls an optional function of an event with its parameters; `read` takes the result from the
  // top.
  template <class Read>
  void call_optional(const std::string& type, const char* function, const EventArguments& arguments,
                     Instant mission_start, const Read& read) {
    call_optional(
        type, function, arguments, mission_start, [](lua_State*) { return 0; }, 1, read);
  }
  // `push_more` pushes arguments behind the parameters and returns their number; `read` finds
  // `results` results at the top.
  template <class Push, class Read>
  void call_optional(const std::string& type, const char* function, const EventArguments& arguments,
                     Instant mission_start, const Push& push_more, int results, const Read& read) {
    const EventScript& script = library.events().at(type);
    library.run(script, [&](lua_State* L) {
      lua_rawgeti(L, LUA_REGISTRYINDEX, script.functions);
      if (lua_getfield(L, -1, function) != LUA_TFUNCTION) return;
      push_params(L, script.declaration, arguments, mission_start);
      const auto fail = [&](const std::string& what) {
        throw ScriptError(fmt::format("{}: {}: {}", script.file, function, what));
      };
      const int more = push_more(L);
      const auto failure = call_script(L, 1 + more, results);
      script.locals.restore(L);
      if (failure) fail(failure->message);
      try {
        read(L);
      } catch (const std::runtime_error& error) {
        fail(error.what());
      }
    });
  }

  std::string state_bytes(lua_State* L, Instance& instance) {
    Archive archive = Archive::writer();
    archive.tag(state_version)(instance.random);
    lua_rawgeti(L, LUA_REGISTRYINDEX, instance.table);
    lua_getfield(L, -1, "state");
    // What would come back different is read back at once, as a resumed mission has it.
    if (save_value(L, -1, "ev.state", archive, instance.script->locals)) {
      read_state(L, instance, archive.bytes());
    }
    return archive.bytes();
  }

  static void read_state(lua_State* L, Instance& instance, const std::string& bytes) {
    Archive archive = Archive::reader(bytes);
    archive.tag(state_version)(instance.random);
    lua_rawgeti(L, LUA_REGISTRYINDEX, instance.table);
    restore_value(L, archive);
    lua_setfield(L, -2, "state");
    if (!archive.is_exhausted()) throw Archive::Mismatch("saved ev.state is too long");
  }
};

LuaHost::LuaHost(const Catalog& catalog, const Limits& limits)
    : impl_(std::make_unique<Impl>(limits)) {
  impl_->declarations = catalog.declarations();
  Faults faults;
  impl_->library.lua().context().scripts = &catalog.scripts();
  for (const Script& script : catalog.scripts()) {
    if (script.kind != ScriptKind::event) continue;
    if (impl_->declarations.events.contains(script.name)) impl_->library.load(script, faults);
  }
  impl_->library.lua().context().scripts = nullptr;
  LSOS_ASSERT(!faults.has_errors());  // the catalog has loaded the same sources
}

LuaHost::~LuaHost() = default;

const Declarations& LuaHost::declarations() const { return impl_->declarations; }

LuaHost::CheckAnswer LuaHost::check(const std::string& type, const EventArguments& arguments,
                                    Instant mission_start, const PlanRover* rover,
                                    const RoverModel* model) {
  CheckAnswer answer;
  const auto push_rover = [&](lua_State* L) {
    if (rover == nullptr || model == nullptr) return 0;
    push_rover_facts(L, *rover, *model);
    return 1;
  };
  const auto text_at = [](lua_State* L, int index) -> std::string {
    if (lua_isnil(L, index)) return "";
    if (lua_type(L, index) == LUA_TSTRING) return lua_tostring(L, index);
    throw std::runtime_error(fmt::format("a text or nil is wanted, found {}", describe(L, index)));
  };
  impl_->call_optional(type, "check", arguments, mission_start, push_rover, 2, [&](lua_State* L) {
    answer = {text_at(L, -2), text_at(L, -1)};
  });
  return answer;
}

bool LuaHost::is_open_ended(const std::string& type, const EventArguments& arguments,
                            Instant mission_start) {
  const EventDeclaration& declaration = impl_->declarations.events.at(type);
  const bool has_time = std::ranges::any_of(declaration.fields, [](const FieldDeclaration& field) {
    return field.kind == FieldKind::duration || field.kind == FieldKind::utc ||
           field.kind == FieldKind::moment;
  });
  bool is_open = declaration.is_open_ended.value_or(!declaration.drives && !has_time);
  impl_->call_optional(type, "open_ended", arguments, mission_start,
                       [&](lua_State* L) { is_open = lua_toboolean(L, -1) != 0; });
  return is_open;
}

bool LuaHost::awaits_sunlight(const std::string& type, const EventArguments& arguments,
                              Instant mission_start) {
  bool awaits = false;
  impl_->call_optional(type, "awaits_sunlight", arguments, mission_start,
                       [&](lua_State* L) { awaits = lua_toboolean(L, -1) != 0; });
  return awaits;
}

std::string LuaHost::condition_fault(const std::string& text, const ConditionWorld& world) {
  std::string fault;
  impl_->library.lua().run([&](lua_State* L) { fault = lsos::condition_fault(L, text, world); });
  return fault;
}

std::string LuaHost::values_in(const std::string& condition, const SampleRow& row,
                               const RoverPort& rover) {
  return condition_values(condition, row, rover);
}

bool LuaHost::holds(const std::string& condition, const SampleRow& row, const RoverPort& rover) {
  bool holds = false;
  impl_->library.lua().run([&](lua_State* L) {
    try {
      holds = condition_holds(L, condition, row, rover);
    } catch (const std::runtime_error& error) {
      throw ScriptError(error.what());
    }
  });
  return holds;
}

std::optional<RouteSettings> LuaHost::route_settings(const std::string& type,
                                                     const EventArguments& arguments,
                                                     Instant mission_start) {
  std::optional<RouteSettings> settings;
  impl_->call_optional(type, "route", arguments, mission_start, [&](lua_State* L) {
    settings = check_route_options(L, -1, "route").settings;
  });
  return settings;
}

std::optional<Breakage> LuaHost::breakage(const std::string& type, const EventArguments& arguments,
                                          Instant mission_start) {
  std::optional<Breakage> breakage;
  impl_->call_optional(type, "breaks", arguments, mission_start,
                       [&](lua_State* L) { breakage = check_breakage(L, -1, "breaks"); });
  return breakage;
}

ResourceChange LuaHost::resource_change(const std::string& type, const EventArguments& arguments,
                                        Instant mission_start) {
  ResourceChange change;
  impl_->call_optional(type, "uses", arguments, mission_start,
                       [&](lua_State* L) { change.used = check_amounts(L, -1); });
  impl_->call_optional(type, "fills", arguments, mission_start,
                       [&](lua_State* L) { change.filled = check_amounts(L, -1); });
  return change;
}

ScriptInstance LuaHost::begin(const std::string& type, const EventArguments& arguments) {
  const auto found = impl_->library.events().find(type);
  LSOS_ASSERT(found != impl_->library.events().end());
  Impl::Instance instance;
  instance.script = &found->second;
  instance.arguments = arguments;
  impl_->library.run(found->second, [&](lua_State* L) {
    lua_newtable(L);
    lua_newtable(L);
    lua_setfield(L, -2, "state");
    instance.table = luaL_ref(L, LUA_REGISTRYINDEX);
  });
  impl_->instances.emplace(++impl_->last_id, std::move(instance));
  return impl_->last_id;
}

PhaseAnswer LuaHost::run_phase(ScriptInstance id, const std::string& phase_name,
                               PhaseContext& context) {
  Impl::Instance& instance = impl_->at(id);
  const EventScript& script = *instance.script;
  const std::string where = "phase " + phase_name;
  PhaseAnswer answer;
  impl_->library.run(script, [&](lua_State* L) {
    const EventCall call{script.declaration, instance.arguments, id, context, instance.random};
    try {
      lua_rawgeti(L, LUA_REGISTRYINDEX, script.functions);
      lua_getfield(L, -1, "phases");
      const EventDeclaration::Phase& phase = find_phase(script.declaration, phase_name);
      lua_getfield(L, -1, phase_name.c_str());
      answer = phase.sub_event.empty() ? impl_->run_function(L, id, instance, call, where)
                                       : impl_->run_sub_event(L, id, instance, call, phase, where);
      instance.last_phase = phase_name;
      impl_->state_bytes(L, instance);  // refuses, in this phase, what cannot be saved
    } catch (const ScriptError&) {
      throw;
    } catch (const EquipmentFault& fault) {
      answer = Fail{fault.what()};
    } catch (const std::runtime_error& error) {
      // The answer, ev.state or a sub-event's arguments are wrong: a fault of the phase as a whole.
      const int line = find_phase(script.declaration, phase_name).line;
      const Fault fault{Severity::error, {script.file, line}, error.what()};
      throw ScriptError(phase_failure({to_string(fault), ""}, script, where, context));
    }
  });
  return answer;
}

std::string LuaHost::run_abort(ScriptInstance id, PhaseContext& context) {
  Impl::Instance& instance = impl_->at(id);
  std::string state;
  impl_->library.run(*instance.script, [&](lua_State* L) {
    lua_rawgeti(L, LUA_REGISTRYINDEX, instance.script->functions);
    if (lua_getfield(L, -1, "on_abort") != LUA_TFUNCTION) return;
    const int line = definition_line(L);
    const EventCall call{instance.script->declaration, instance.arguments, id, context,
                         instance.random};
    try {
      impl_->call(L, id, instance, call, "on_abort", 1);
      if (lua_type(L, -1) == LUA_TSTRING) {
        state = beginning(error_text(L, -1), ending_bytes_max);
      } else if (!lua_isnil(L, -1)) {
        throw std::runtime_error(fmt::format("a text or nil is wanted, found {}", describe(L, -1)));
      }
    } catch (const ScriptError&) {
      throw;
    } catch (const std::runtime_error& error) {
      const Fault fault{Severity::error, {instance.script->file, line}, error.what()};
      throw ScriptError(
          phase_failure({to_string(fault), ""}, *instance.script, "on_abort", context));
    }
  });
  return state;
}

void LuaHost::end(ScriptInstance id) {
  const int table = impl_->at(id).table;
  impl_->library.lua().run([&](lua_State* L) { luaL_unref(L, LUA_REGISTRYINDEX, table); });
  impl_->instances.erase(id);
}

std::string LuaHost::save(ScriptInstance id) {
  Impl::Instance& instance = impl_->at(id);
  std::string bytes;
  impl_->library.run(*instance.script, [&](lua_State* L) {
    try {
      bytes = impl_->state_bytes(L, instance);
    } catch (const std::runtime_error& error) {
      throw ScriptError(fmt::format("{}: {} after phase {}: {}", instance.script->file,
                                    instance.script->declaration.name, instance.last_phase,
                                    error.what()));
    }
  });
  return bytes;
}

void LuaHost::restore(ScriptInstance id, const std::string& bytes) {
  Impl::Instance& instance = impl_->at(id);
  impl_->library.run(*instance.script, [&](lua_State* L) { Impl::read_state(L, instance, bytes); });
}

}  // namespace lsos
