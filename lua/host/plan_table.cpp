#include "lua/host/plan_table.h"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "lua/runtime/constructed_value.h"
#include "lua/runtime/reader.h"
#include "lua/runtime/sorted_keys.h"
#include "lua/runtime/vec3.h"
#include "planet/body.h"

namespace lsos {

namespace {

constexpr const char* usual_start = "2026-07-01T00:00:00Z";

// Text of a field's value; absent where the value cannot be a field.
std::optional<std::string> field_text(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) != 0 ? "true" : "false";
    case LUA_TNUMBER:
      return lua_isinteger(L, index) != 0 ? fmt::format("{}", lua_tointeger(L, index))
                                          : fmt::format("{}", lua_tonumber(L, index));
    case LUA_TSTRING:
      return lua_tostring(L, index);
    default:
      return {};
  }
}

// Metres east and north of the site's origin.
std::optional<Vec3> point_at(lua_State* L, int index) {
  if (auto p = to_vec3(L, index)) return p;
  if (!lua_istable(L, index)) return {};
  index = lua_absindex(L, index);
  Vec3 p_m = Vec3::Zero();
  for (int k = 0; k < 2; ++k) {
    const bool is_number = lua_rawgeti(L, index, k + 1) == LUA_TNUMBER;
    if (is_number) p_m[k] = lua_tonumber(L, -1);
    lua_pop(L, 1);
    if (!is_number) return {};
  }
  return p_m;
}

std::string coordinates(const SiteFrame& site, const Vec3& p_S_m) {
  const Geodetic at = site.geodetic(p_S_m);
  // The precision of the KML file that is written from the plan, so that both are the same plan to
  // the bit.
  return fmt::format("{:.9f},{:.9f}", lon_deg(at), lat_deg(at));
}

// Restores the height of the Lua stack on leaving the scope.
class StackGuard {
 public:
  explicit StackGuard(lua_State* L) : L_(L), top_(lua_gettop(L)) {}
  ~StackGuard() { lua_settop(L_, top_); }
  StackGuard(const StackGuard&) = delete;
  StackGuard& operator=(const StackGuard&) = delete;

 private:
  lua_State* L_;
  int top_;
};

// Reads one table of a plan and the tables in it.
class PlanTableReader {
 public:
  PlanTableReader(lua_State* L, const Place& place, Faults& faults)
      : L_(L), place_(place), faults_(faults) {}

  void read_plan(int index, PlanTable& plan) {
    TableReader t(L_, index, "lsos.sim", place_, faults_);
    std::string planet = "Moon";
    t.text(optional, "planet", planet, "'Moon', 'Mars' or 'Earth' ('Moon').");
    std::string terrain = "Flat";
    t.text(optional, "terrain", terrain, "A terrain script by name, or a raster ('Flat').");
    std::string beyond;
    t.text(optional, "terrain_beyond", beyond,
           "The ground where the terrain's raster ends: a terrain script by name, or a raster.");
    t.text(optional, "soil", plan.soil, "Of the ground, in place of the terrain's own.");
    std::string start = usual_start;
    t.text(optional, "start", start, "UTC ('2026-07-01T00:00:00Z').");
    std::int64_t seed = 0;
    t.integer(optional, "seed", seed, not_negative, "Of all random numbers (0).");
    std::optional<double> log_interval_s, parked_log_interval_s, max_duration_s;
    t.number(optional, "log_interval_s", log_interval_s, positive, "Between samples (2).");
    t.number(optional, "parked_log_interval_s", parked_log_interval_s, positive, "While parked.");
    t.number(optional, "max_duration_s", max_duration_s, positive, "The mission's end (a day).");
    std::optional<std::string> on_failure;
    t.text(optional, "on_failure", on_failure, "Of all events that say nothing of their own.");
    std::vector<double> site{0, 0};
    t.numbers(optional, "site", site, any_number,
              "{ lon_deg, lat_deg } of east 0, north 0 (0, 0).");
    const Body* body = find_body(planet);
    const bool is_place = site.size() == 2 && std::abs(site[0]) <= 360 && std::abs(site[1]) <= 90;
    if (!is_place) {
      t.fault("site: { lon_deg, lat_deg } is wanted, -360..360 and -90..90");
      site = {0, 0};
    }
    const SiteFrame frame(body == nullptr ? *find_body("Moon") : *body,
                          geodetic_from_degrees(site[0], site[1]));

    SourcePlacemark& mission = add(plan.source, "MissionInfo", "mission");
    set(mission, "Planet", planet);
    set(mission, "Terrain", terrain);
    if (!beyond.empty()) set(mission, "TerrainBeyond", beyond);
    set(mission, "StartTime", start);
    set(mission, "Seed", fmt::format("{}", seed));
    if (log_interval_s) set(mission, "LogInterval", fmt::format("{}", *log_interval_s));
    if (parked_log_interval_s) {
      set(mission, "ParkedLogInterval", fmt::format("{}", *parked_log_interval_s));
    }
    // An interactive mission without an end is a mistake in it, which should show within seconds.
    constexpr double longest_s = 86'400;
    set(mission, "MaxDuration", fmt::format("{}", max_duration_s.value_or(longest_s)));
    if (on_failure) set(mission, "OnFailure", *on_failure);
    for_each_named(t, required, "rovers", "Id = { type = 'SEV', at = {0, 0}, events = {...} }",
                   [&](const std::string& id) { read_rover(id, frame, plan.source); });
    for_each_named(t, optional, "assets", "Id = { type = 'Habitat', at = {0, 0} }",
                   [&](const std::string& id) { read_asset(id, frame, plan.source); });
    t.finish();
  }

  void read_event(int index, const SiteFrame& site, SourcePlacemark& placemark) {
    index = lua_absindex(L_, index);
    const StackGuard kept(L_);
    if (!lua_istable(L_, index) || lua_rawgeti(L_, index, 1) != LUA_TSTRING) {
      return fault("an event is a table that begins with its type: { 'Pause', Duration = 60 }");
    }
    const std::string type = lua_tostring(L_, -1);
    lua_pop(L_, 1);
    placemark.data = {{"#" + type, type, {}, place_.line}};
    placemark.line = place_.line;
    push_sorted_keys(L_, index);
    for (lua_Integer i = 1; lua_rawgeti(L_, -1, i) != LUA_TNIL; ++i, lua_pop(L_, 1)) {
      if (lua_type(L_, -1) == LUA_TNUMBER) {
        if (lua_tonumber(L_, -1) != 1) fault(fmt::format("{}: a list has no place here", type));
        continue;
      }
      const std::string key = lua_tostring(L_, -1);
      lua_pushvalue(L_, -1);
      lua_rawget(L_, index);
      read_entry(type, key, site, placemark);
      lua_pop(L_, 1);
    }
    read_holes(type, index, site, placemark);
  }

 private:
  // Reads the entry `key` of an event, whose value is at the top.
  void read_entry(const std::string& type, const std::string& key, const SiteFrame& site,
                  SourcePlacemark& placemark) {
    const StackGuard kept(L_);
    if (key == "holes") return;  // read with the polygon
    if (key == "path" || key == "at" || key == "polygon") {
      SourceGeometry geometry{key == "at"     ? "Point"
                              : key == "path" ? "LineString"
                                              : "Polygon",
                              "", place_.line};
      if (key == "at") {
        const auto p_m = point_at(L_, -1);
        if (!p_m) return fault(fmt::format("{}: at: {{ east_m, north_m }} is wanted", type));
        geometry.coordinates = coordinates(site, *p_m);
      } else {
        const auto places = read_places(type, key, key == "path" ? 2 : 3, site);
        if (!places) return;
        geometry.coordinates = *places;
      }
      placemark.geometries.push_back(geometry);
      return;
    }
    const auto text = field_text(L_, -1);
    if (!text) {
      return fault(fmt::format("{}: {}: a number, text or boolean is wanted, found {}", type, key,
                               describe(L_, -1)));
    }
    if (key == "label") {
      placemark.name = *text;
    } else if (key == "sequence") {
      set(placemark, "Sequence", *text);
    } else {
      set(placemark, key, *text);
    }
  }

  // Coordinates of the list of places at the top; absent after a fault.
  std::optional<std::string> read_places(const std::string& type, const std::string& key, int least,
                                         const SiteFrame& site) {
    if (!lua_istable(L_, -1)) {
      fault(fmt::format("{}: {}: a list of {{ east_m, north_m }} is wanted, found {}", type, key,
                        describe(L_, -1)));
      return {};
    }
    std::string text;
    int count = 0;
    for (lua_Integer k = 1; lua_rawgeti(L_, -1, k) != LUA_TNIL; ++k, lua_pop(L_, 1)) {
      const auto p_m = point_at(L_, -1);
      if (!p_m) {
        fault(fmt::format("{}: {}[{}]: {{ east_m, north_m }} is wanted", type, key, k));
        continue;
      }
      text += coordinates(site, *p_m) + " ";
      ++count;
    }
    lua_pop(L_, 1);
    if (count >= least) return text;
    fault(fmt::format("{}: {}: {} places; {} or more are wanted: {{ {{ east_m, north_m }}, ... }}",
                      type, key, count, least));
    return {};
  }

  // The holes of the event's table, for its polygon.
  void read_holes(const std::string& type, int event, const SiteFrame& site,
                  SourcePlacemark& placemark) {
    const StackGuard kept(L_);
    lua_pushstring(L_, "holes");
    if (lua_rawget(L_, event) == LUA_TNIL) return;
    if (placemark.geometries.empty() || placemark.geometries.front().kind != "Polygon") {
      return fault(fmt::format("{}: holes: they are of a polygon, and there is none", type));
    }
    if (!lua_istable(L_, -1)) {
      return fault(
          fmt::format("{}: holes: a list of lists of {{ east_m, north_m }} is wanted, "
                      "found {}",
                      type, describe(L_, -1)));
    }
    for (lua_Integer k = 1; lua_rawgeti(L_, -1, k) != LUA_TNIL; ++k, lua_pop(L_, 1)) {
      const auto places = read_places(type, fmt::format("holes[{}]", k), 3, site);
      if (places) placemark.geometries.front().holes.push_back({*places, place_.line});
    }
  }

  void read_rover(const std::string& id, const SiteFrame& site, KmlSource& source) {
    TableReader t(L_, -1, "rover " + id, place_, faults_);
    SourcePlacemark& rover = add(source, "Rover", id);
    std::string type;
    t.text(required, "type", type, "Its script in rovers/.");
    set(rover, "RoverId", id);
    set(rover, "RoverType", type);
    std::optional<std::string> configuration;
    t.text(optional, "config", configuration, "An initial configuration of its script.");
    if (configuration) set(rover, "RoverConfig", *configuration);
    std::optional<std::string> variant;
    t.text(optional, "variant", variant, "Changes to the numbers of its script.");
    if (variant) set(rover, "Variant", *variant);
    std::optional<double> heading_deg, charge;
    t.number(optional, "heading_deg", heading_deg, any_number, "Clockwise from true north.");
    if (heading_deg) set(rover, "Heading", fmt::format("{}", *heading_deg));
    t.number(optional, "charge", charge, fraction, "Of its battery at the start (1).");
    if (charge) set(rover, "InitialCharge", fmt::format("{}", *charge));
    std::optional<std::string> on_failure;
    t.text(optional, "on_failure", on_failure, "Of its events that say nothing of their own.");
    if (on_failure) set(rover, "OnFailure", *on_failure);
    read_point(t, rover, site);
    if (!t.take(optional, "events", "list of events", "{ 'Pause', Duration = 60 }, ...")) return;
    if (lua_istable(L_, -1)) {
      read_events(id, site, source);
    } else if (!lua_isnil(L_, -1)) {
      t.fault(fmt::format("events: a list is wanted, found {}", describe(L_, -1)));
    }
    lua_pop(L_, 1);
    t.finish();
  }

  // Reads the events in the list at the top.
  void read_events(const std::string& rover_id, const SiteFrame& site, KmlSource& source) {
    const StackGuard kept(L_);
    const int list = lua_gettop(L_);
    push_sorted_keys(L_, list);
    for (lua_Integer k = 1; lua_rawgeti(L_, -1, k) != LUA_TNIL; ++k, lua_pop(L_, 1)) {
      if (lua_isinteger(L_, -1) == 0 || lua_tointeger(L_, -1) != k) {
        return fault(
            fmt::format("rover {}: events: a list without gaps is wanted: {{ {{ 'Pause', "
                        "Duration = 60 }}, ... }}",
                        rover_id));
      }
      lua_rawgeti(L_, list, k);
      SourcePlacemark event;
      read_event(-1, site, event);
      lua_pop(L_, 1);
      if (event.data.empty()) continue;
      set(event, "RoverId", rover_id);
      const auto& fields = event.data.front().fields;
      if (std::ranges::find(fields, "Sequence", &SourceField::name) == fields.end()) {
        set(event, "Sequence", fmt::format("{}", 10 * k));
      }
      source.placemarks.push_back(std::move(event));
    }
  }

  void read_asset(const std::string& id, const SiteFrame& site, KmlSource& source) {
    TableReader t(L_, -1, "asset " + id, place_, faults_);
    SourcePlacemark& asset = add(source, "Asset", id);
    std::string type;
    t.text(required, "type", type, "Its script in rovers/.");
    set(asset, "AssetId", id);
    set(asset, "AssetType", type);
    std::optional<double> height_m;
    t.number(optional, "height_m", height_m, not_negative, "Of its antenna above ground.");
    if (height_m) set(asset, "Height", fmt::format("{}", *height_m));
    read_point(t, asset, site);
    t.finish();
  }

  void read_point(TableReader& t, SourcePlacemark& placemark, const SiteFrame& site) {
    Vec3 p_m = Vec3::Zero();
    if (t.take(optional, "at", "{ east_m, north_m }", "On the site ({ 0, 0 }).")) {
      if (!lua_isnil(L_, -1)) {
        const auto found = point_at(L_, -1);
        if (!found) t.fault("at: { east_m, north_m } is wanted");
        p_m = found.value_or(p_m);
      }
      lua_pop(L_, 1);
    }
    placemark.geometries.push_back({"Point", coordinates(site, p_m), place_.line});
  }

  // Calls read(name) for each entry of the table of tables at `key`, in byte order, with the entry
  // at the top.
  template <class Read>
  void for_each_named(TableReader& t, Need need, const char* key, const char* doc,
                      const Read& read) {
    if (!t.take(need, key, "table", doc)) return;
    if (lua_istable(L_, -1)) {
      const int table = lua_gettop(L_);
      push_sorted_keys(L_, table);
      if (need == required && lua_rawlen(L_, -1) == 0) {
        t.fault(fmt::format("{} is empty; at least one is wanted: {}", key, doc));
      }
      for (lua_Integer i = 1; lua_rawgeti(L_, -1, i) != LUA_TNIL; ++i, lua_pop(L_, 1)) {
        if (lua_type(L_, -1) != LUA_TSTRING) {
          t.fault(fmt::format("{}: entries have names: {}", key, doc));
          continue;
        }
        const std::string id = lua_tostring(L_, -1);
        lua_pushvalue(L_, -1);
        lua_rawget(L_, table);
        if (lua_istable(L_, -1)) {
          read(id);
        } else {
          t.fault(fmt::format("{}: {}: a table is wanted, found {}", key, id, describe(L_, -1)));
        }
        lua_pop(L_, 1);
      }
      lua_pop(L_, 2);
    } else if (!lua_isnil(L_, -1)) {
      t.fault(fmt::format("{}: a table is wanted, found {}", key, describe(L_, -1)));
    }
    lua_pop(L_, 1);
  }

  SourcePlacemark& add(KmlSource& source, const std::string& schema, const std::string& name) {
    SourcePlacemark& placemark = source.placemarks.emplace_back();
    placemark.name = name;
    placemark.line = place_.line;
    placemark.data = {{"#" + schema, schema, {}, place_.line}};
    return placemark;
  }
  void set(SourcePlacemark& placemark, const std::string& name, const std::string& text) {
    placemark.data.front().fields.push_back({name, text, place_.line});
  }
  void fault(const std::string& what) { faults_.error(place_, what); }

  lua_State* L_;
  Place place_;
  Faults& faults_;
};

}  // namespace

PlanTable read_plan_table(lua_State* L, int index, const Place& place) {
  PlanTable plan;
  plan.source.file = place.file;
  Faults faults;
  PlanTableReader(L, place, faults).read_plan(lua_absindex(L, index), plan);
  faults.throw_if_errors();
  return plan;
}

SourcePlacemark read_event_table(lua_State* L, int index, const SiteFrame& site,
                                 const Place& place) {
  SourcePlacemark placemark;
  placemark.file = place.file;
  Faults faults;
  PlanTableReader(L, place, faults).read_event(index, site, placemark);
  faults.throw_if_errors();
  return placemark;
}

}  // namespace lsos
