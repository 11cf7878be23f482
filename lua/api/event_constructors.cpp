#include "lua/api/event_constructors.h"

#include <fmt/format.h>

#include <algorithm>

#include "lua/api/answer.h"
#include "lua/api/constructors.h"
#include "lua/runtime/sorted_keys.h"

namespace lsos {

namespace {

// Calls body(key) for each text key of the table at the top, in byte order, with the key's value at
// the top.
template <class F>
void for_each_text_key(TableReader& t, const char* table_name, F&& body) {
  lua_State* L = t.L();
  push_sorted_keys(L, -1);
  for (lua_Integer i = 1; lua_rawgeti(L, -1, i) != LUA_TNIL; ++i, lua_pop(L, 1)) {
    if (lua_type(L, -1) != LUA_TSTRING) {
      t.fault(fmt::format("{}: entries have names, found [{}]", table_name, lua_tonumber(L, -1)));
      continue;
    }
    const std::string key = text_at(L, -1);
    if (!t.check_name(table_name, key)) continue;
    lua_pushvalue(L, -1);
    lua_rawget(L, -4);
    body(key);
    lua_pop(L, 1);
  }
  lua_pop(L, 2);
}

bool is_table_or_fault(TableReader& t, const char* key, const char* wanted) {
  if (lua_istable(t.L(), -1)) return true;
  if (!lua_isnil(t.L(), -1)) {
    t.fault(fmt::format("{}: {} is wanted, found {}", key, wanted, describe(t.L(), -1)));
  }
  lua_pop(t.L(), 1);
  return false;
}

// A key of a dimensional value ends in its SI unit; a key of a dimensionless one must not.
void check_suffix(TableReader& t, const std::string& key, const FieldDeclaration& field) {
  std::string suffix;
  if (field.unit != nullptr && !field.unit->suffix.empty()) suffix = field.unit->suffix;
  const bool is_time = field.kind == FieldKind::utc || field.kind == FieldKind::moment;
  if (is_time) suffix = "s";
  if (!suffix.empty() && !key.ends_with("_" + suffix)) {
    t.fault(fmt::format("params: '{}' must end in '_{}', as its value is in {}", key, suffix,
                        is_time ? "s" : si_unit_of("x_" + suffix)));
  }
  const std::string claimed = si_unit_of(key);
  if (suffix.empty() && !claimed.empty() && field.kind == FieldKind::number) {
    t.fault(fmt::format("params: '{}' ends like a value in {}, but its unit is '{}'", key, claimed,
                        field.unit->symbol));
  }
}

void read_params(TableReader& t, EventDeclaration& event) {
  if (!t.take(optional, "params", "table of fields",
              "Script key = lsos.number {...} or another field."))
    return;
  if (!is_table_or_fault(t, "params", "a table")) return;
  for_each_text_key(t, "params", [&](const std::string& key) {
    const ConstructedValue* made = to_constructed(t.L(), -1);
    const auto* field = made == nullptr ? nullptr : std::any_cast<FieldDeclaration>(&made->value);
    if (field == nullptr) {
      t.fault(fmt::format("params: {}: lsos.number {{...}} or another field is wanted, found {}",
                          key, describe(t.L(), -1)));
      return;
    }
    check_suffix(t, key, *field);
    const auto same_name = [&](const FieldDeclaration& other) { return other.name == field->name; };
    if (std::ranges::any_of(event.fields, same_name)) {
      t.fault(fmt::format("params: '{}' is the name of two fields", field->name));
    }
    if (std::ranges::any_of(common_event_fields(), same_name) ||
        std::ranges::any_of(event_identity_fields(), same_name)) {
      t.fault(fmt::format("params: '{}' is a field that every event has", field->name));
    }
    const auto same_role = std::ranges::find(event.fields, field->role, &FieldDeclaration::role);
    if (field->role != NumberRole::none && same_role != event.fields.end()) {
      t.fault(fmt::format("params: '{}' and '{}' have the same role; one of them is allowed to",
                          same_role->name, field->name));
    }
    event.fields.push_back(*field);
    event.fields.back().key = key;
  });
  for (const FieldDeclaration& field : event.fields) {
    const auto is_named = [&](const FieldDeclaration& other) {
      return other.key == field.amount_of && other.names == NameOf::resource;
    };
    if (field.amount_of.empty() || std::ranges::any_of(event.fields, is_named)) continue;
    t.fault(
        fmt::format("params: {}: amount_of = '{}': no text of this event has that key and "
                    "names = 'resource'",
                    field.key, field.amount_of));
  }
  lua_pop(t.L(), 1);
}

void read_geometry(TableReader& t, EventDeclaration& event) {
  static const std::vector<std::string> names{"none", "point", "line", "polygon"};
  if (!t.take(optional, "geometry", "text or list of texts",
              "'none', 'point', 'line', 'polygon' or several (default { 'none', 'point' })."))
    return;
  const auto add = [&] {
    const std::string name =
        lua_type(t.L(), -1) == LUA_TSTRING ? lua_tostring(t.L(), -1) : describe(t.L(), -1);
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) {
      t.fault(fmt::format("geometry: 'none', 'point', 'line' or 'polygon' is wanted, found '{}'{}",
                          name, did_you_mean(name, names)));
    } else {
      event.geometries.push_back(static_cast<GeometryKind>(found - names.begin()));
    }
  };
  if (lua_istable(t.L(), -1)) {
    for (lua_Integer i = 1; lua_rawgeti(t.L(), -1, i) != LUA_TNIL; ++i, lua_pop(t.L(), 1)) add();
    lua_pop(t.L(), 1);
    if (lua_rawlen(t.L(), -1) == 0) {
      t.fault("geometry: the list is empty; an event without one has geometry = 'none'");
    }
  } else if (!lua_isnil(t.L(), -1)) {
    add();
  } else {
    event.geometries = {GeometryKind::none, GeometryKind::point};
  }
  lua_pop(t.L(), 1);
}

// Copies the functions of the phases to the table at `functions`.
void read_phases(TableReader& t, EventDeclaration& event, int functions) {
  if (!t.take(required, "phases", "table",
              "Phase name = function(ev, rover) or lsos.sub_event {...}."))
    return;
  if (!is_table_or_fault(t, "phases", "a table")) return;
  lua_State* L = t.L();
  lua_newtable(L);
  lua_pushvalue(L, -1);
  lua_setfield(L, functions, "phases");
  lua_insert(L, -2);  // new table below the phases
  const int copy = lua_gettop(L) - 1;
  for_each_text_key(t, "phases", [&](const std::string& name) {
    const ConstructedValue* made = to_constructed(L, -1);
    if (made != nullptr && made->kind == sub_event_kind) {
      const auto& sub = std::any_cast<const SubEvent&>(made->value);
      event.phases.push_back({name, sub.event, sub.next, made->place.line});
      lua_getiuservalue(L, -1, 1);
      lua_setfield(L, copy, name.c_str());
    } else if (lua_isfunction(L, -1)) {
      event.phases.push_back({name, "", "", definition_line(L)});
      lua_pushvalue(L, -1);
      lua_setfield(L, copy, name.c_str());
    } else {
      t.fault(fmt::format("phases: {}: a function or lsos.sub_event {{...}} is wanted, found {}",
                          name, describe(L, -1)));
    }
  });
  lua_pushnil(L);
  if (lua_next(L, -2) == 0) {
    t.fault("phases: at least one is needed");
  } else {
    lua_pop(L, 2);
  }
  lua_pop(L, 2);
}

void check_phases(TableReader& t, EventDeclaration& event) {
  std::vector<std::string> names;
  for (const EventDeclaration::Phase& phase : event.phases) names.push_back(phase.name);
  if (names.empty()) return;  // already reported
  if (event.start_phase.empty() && names.size() == 1) event.start_phase = names.front();
  if (event.start_phase.empty()) return t.fault("'start' is missing: which phase comes first?");
  const auto check = [&](const std::string& what, const std::string& name) {
    if (std::ranges::find(names, name) != names.end()) return;
    t.fault(fmt::format("{} = '{}': there is no such phase{}; phases are {}", what, name,
                        did_you_mean(name, names), fmt::join(names, ", ")));
  };
  check("start", event.start_phase);
  for (const EventDeclaration::Phase& phase : event.phases) {
    if (!phase.next.empty()) check(fmt::format("phases: {}: next", phase.name), phase.next);
  }
  std::stable_partition(
      event.phases.begin(), event.phases.end(),
      [&](const EventDeclaration::Phase& phase) { return phase.name == event.start_phase; });
}

// Copies an optional function to the table at `functions`.
void read_function(TableReader& t, const char* key, const char* type, const char* doc,
                   int functions) {
  if (!t.take(optional, key, type, doc)) return;
  if (!lua_isnil(t.L(), -1) && !lua_isfunction(t.L(), -1)) {
    t.fault(fmt::format("{}: a function is wanted, found {}", key, describe(t.L(), -1)));
  }
  lua_setfield(t.L(), functions, key);
}

void read_open_ended(TableReader& t, EventDeclaration& event, int functions) {
  if (!t.take(optional, "open_ended", "boolean or function(params)",
              "Whether it ends only by something that no field says, as the Sun or another rover: "
              "MaxDuration is then 366 d by default (default: whether it neither drives nor has a "
              "duration or time among its params)."))
    return;
  lua_State* L = t.L();
  if (lua_isboolean(L, -1)) {
    event.is_open_ended = lua_toboolean(L, -1) != 0;
  } else if (!lua_isnil(L, -1) && !lua_isfunction(L, -1)) {
    t.fault(
        fmt::format("open_ended: true, false or a function is wanted, found {}", describe(L, -1)));
  }
  if (lua_isfunction(L, -1)) {
    lua_setfield(L, functions, "open_ended");
  } else {
    lua_pop(L, 1);
  }
}

// Reads the keys of the params that name what the event deploys, stows or needs deployed.
void read_equipment(TableReader& t, EventDeclaration& event) {
  const auto read = [&](const char* name, std::string& key, const char* doc) {
    t.text(optional, name, key, doc);
    const auto is_equipment = [&](const FieldDeclaration& field) {
      return field.key == key &&
             (field.names == NameOf::panel || field.names == NameOf::stowable_panel ||
              field.names == NameOf::turning_panel || field.names == NameOf::antenna);
    };
    if (key.empty() || std::ranges::any_of(event.fields, is_equipment)) return;
    t.fault(fmt::format("{} = '{}': no text of params has that key and names a panel or an antenna",
                        name, key));
  };
  read("deploys", event.deploys,
       "Key of the text that names the panel or antenna that it deploys, so that a plan is checked "
       "for what is up already.");
  read("stows", event.stows, "The same of what it stows.");
  read("needs_deployed", event.needs_deployed,
       "The same of a panel that must be deployed when it starts.");
}

void read_at(TableReader& t, EventDeclaration& event) {
  t.text(optional, "at", event.at,
         "Key of the lsos.moment at which it takes effect. An event of a plan that gives it needs "
         "no turn: it begins then whatever the rover does, and must end in that exchange.");
  const auto is_moment = [&](const FieldDeclaration& field) {
    return field.key == event.at && field.kind == FieldKind::moment;
  };
  if (event.at.empty() || std::ranges::any_of(event.fields, is_moment)) return;
  t.fault(fmt::format("at = '{}': no lsos.moment of params has that key", event.at));
}

void read_event(TableReader& t, EventDeclaration& event, int functions) {
  std::string schema;
  t.api_version();
  t.text(optional, "schema", schema, "The file's name, for readers; nothing else is allowed.");
  t.text(required, "doc", event.doc, "One sentence that a mission planner understands.");
  constexpr std::pair<const char*, Activity> kinds[] = {
      {"driving", Activity::driving}, {"waiting", Activity::waiting},
      {"energy", Activity::energy},   {"communication", Activity::communication},
      {"crew", Activity::crew},       {"science", Activity::science}};
  t.word(optional, "kind", kinds, event.activity,
         "What it mostly is: 'driving', 'waiting', 'energy', 'communication', 'crew' or 'science'. "
         "Events of a kind share a colour in plots (default: a colour of its own).");
  read_params(t, event);
  read_at(t, event);
  read_geometry(t, event);
  t.boolean(optional, "drives", event.drives,
            "A Point in the plan means: drive there (default false).");
  t.boolean(optional, "goes_on_without_power", event.goes_on_without_power,
            "It starts and goes on also when the battery is empty (default false).");
  t.text(optional, "start", event.start_phase, "The first phase; may be left out if there is one.");
  read_phases(t, event, functions);
  read_function(
      t, "check", "function(params, rover)",
      "Called for each event of a plan before anything runs: what is wrong with its "
      "parameters together, as a text, or nil; and what to warn of, as a second text. "
      "rover is what is known of the event's: `id`, `type`, `length_m`, `initial_charge`, "
      "`crew`, `configuration`, `battery_capacity_j`, `charge_power_max_w`, `generator_w`, "
      "`height_min_m`, `height_max_m`, `has_posture_control` (on limbs), `slope_max_rad`, "
      "`panels` (each with "
      "`name`, "
      "`turns`, "
      "`is_stowable` and limits such as `elevation_min_rad`); nil where faults of the plan "
      "leave it open.",
      functions);
  read_function(t, "route", "function(params)",
                "For an event that plans its routes: gives what rover:plan_path will be told, so "
                "that they are planned and checked before the run.",
                functions);
  read_function(t, "breaks", "function(params)",
                "For an event that breaks or repairs something: gives what rover:break_part will "
                "be told, so that a plan is checked for what the rover has.",
                functions);
  read_function(t, "uses", "function(params)",
                "For an event that takes of the rover's resources: how much it will, as { oxygen = "
                "0.4 }, so that a plan is checked for what is left of each. Names that the rover "
                "does not carry are passed over.",
                functions);
  read_function(t, "fills", "function(params)",
                "For an event that restocks: by how much at most it fills up the rover's "
                "resources, as { oxygen = 10 }; math.huge: to what there was at the start.",
                functions);
  read_function(t, "on_abort", "function(ev, rover)",
                "Called once when the event is ended from outside. A text that it answers says how "
                "far the event had come, and stands in its reason.",
                functions);
  read_open_ended(t, event, functions);
  read_equipment(t, event);
  read_function(t, "awaits_sunlight", "function(params)",
                "Whether it waits for sunlight on the rover's panels: a plan is then checked for "
                "panels that are stowed and for a Sun that is below the horizon.",
                functions);
  t.finish();
  if (!schema.empty() && schema != event.name) {
    t.fault(fmt::format("schema = '{}': must be '{}', the name of the file", schema, event.name));
  }
}

int make_event(lua_State* L) {
  TableReader t = constructor_reader(L);
  EventDeclaration event;
  event.place = t.place();
  event.name = script_name(event.place.file);
  lua_newtable(L);
  const int functions = lua_gettop(L);
  read_event(t, event, functions);
  check_phases(t, event);
  push_constructed(L, {event_kind, t.place(), std::move(event)});
  lua_pushvalue(L, functions);
  lua_setiuservalue(L, -2, 1);
  return 1;
}

void read_sub_event(TableReader& t, SubEvent& sub, int functions) {
  t.text(required, "event", sub.event, "Name of the event that this phase is.");
  if (t.take(optional, "params", "table or function(ev, rover)",
             "Its parameters by script key, or a function that gives them.")) {
    if (!lua_isnil(t.L(), -1) && !lua_isfunction(t.L(), -1) && !lua_istable(t.L(), -1)) {
      t.fault(
          fmt::format("params: a table or a function is wanted, found {}", describe(t.L(), -1)));
    }
    lua_setfield(t.L(), functions, "params");
  }
  if (t.take(optional, "geometry", "function(ev, rover)",
             "Gives its waypoints: a vec3 or a list of them (default: none).")) {
    if (!lua_isnil(t.L(), -1) && !lua_isfunction(t.L(), -1)) {
      t.fault(fmt::format("geometry: a function is wanted, found {}", describe(t.L(), -1)));
    }
    lua_setfield(t.L(), functions, "geometry");
  }
  if (t.take(optional, "next", "text or lsos.done", "The phase after it (default lsos.done).")) {
    const PhaseAnswer* answer = to_answer(t.L(), -1);
    if (lua_type(t.L(), -1) == LUA_TSTRING) {
      sub.next = lua_tostring(t.L(), -1);
    } else if (!lua_isnil(t.L(), -1) &&
               (answer == nullptr || !std::holds_alternative<Done>(*answer))) {
      t.fault(fmt::format("next: a phase's name or lsos.done is wanted, found {}",
                          describe(t.L(), -1)));
    }
    lua_pop(t.L(), 1);
  }
  t.finish();
}

int make_sub_event(lua_State* L) {
  TableReader t = constructor_reader(L);
  SubEvent sub;
  lua_newtable(L);
  const int functions = lua_gettop(L);
  read_sub_event(t, sub, functions);
  push_constructed(L, {sub_event_kind, t.place(), std::move(sub)});
  lua_pushvalue(L, functions);
  lua_setiuservalue(L, -2, 1);
  return 1;
}

}  // namespace

std::vector<Constructor> event_constructors() {
  return {{event_kind, guard<make_event>,
           [](TableReader& t) {
             EventDeclaration event;
             read_event(t, event, 0);
           },
           "What a script in events/ returns: one event type, named as its file."},
          {sub_event_kind, guard<make_sub_event>,
           [](TableReader& t) {
             SubEvent sub;
             read_sub_event(t, sub, 0);
           },
           "A phase that is another event."}};
}

}  // namespace lsos
