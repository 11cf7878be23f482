// Time of scripts: a phase call, and a plan of many rovers and events until it can start.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "lua/host/host.h"
#include "lua/host/mission_reader.h"
#include "mission/model/machine.h"
#include "mission/rover/rover_power.h"

namespace {

namespace fs = std::filesystem;

// A folder in the folder for temporary files, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(fs::temp_directory_path() / fmt::format("lsos-bench-{}", ::getpid())) {
    fs::create_directories(path_ / "events");
  }
  ~TemporaryFolder() { fs::remove_all(path_); }
  std::string write(const std::string& file, const std::string& text) const {
    std::ofstream(path_ / file) << text;
    return (path_ / file).string();
  }
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

// A rover that stands and ignores commands.
class StandingRover : public lsos::RoverPort {
 public:
  const lsos::RoverView& view() const override { return view_; }
  lsos::DriveState drive_state() const override { return {}; }
  void follow(const lsos::Path3&, const lsos::FollowSettings&) override {}
  lsos::PlannedRoute plan_path(const lsos::Path3&, std::int64_t,
                               const lsos::RouteSettings&) override {
    return {};
  }
  lsos::Vec3 ahead_S_m(double) const override { return lsos::Vec3::Zero(); }
  std::optional<lsos::GroundView> ground_at(const lsos::Vec3&) const override { return {}; }
  lsos::SkyView sky() const override { return {}; }
  std::optional<lsos::Vec3> place_of_S_m(const std::string&) const override { return {}; }
  std::optional<lsos::PairSight> sight_of(const std::string&) const override { return {}; }
  void brake() override {}
  lsos::PowerPort& power() override { return power_; }
  double set_posture(const lsos::PostureRequest&) override { return 0; }
  lsos::Deployment deploy_antenna(const std::string&, bool, std::optional<double>) override {
    return {};
  }
  void follow_rover(const lsos::PursuitSettings&) override {}
  void break_part(const lsos::Breakage&) override {}
  void note(const std::string&, const std::string&) override {}
  void warn(const std::string&) override {}

 private:
  lsos::RoverView view_;
  lsos::RoverPower power_{{}, 1, {}};
};

// One call of a phase with this text, as the mission makes it.
void phase_call(benchmark::State& state, const std::string& text, const std::string& head = "") {
  const TemporaryFolder folder;
  folder.write("events/Probe.lua",
               "local lsos = require 'lsos'\n" + head + "\nlocal function go(ev, rover)\n" + text +
                   "\nend\nreturn lsos.event { api = 1, doc = 'A probe.', start = 'go', phases = { "
                   "go = go } }\n");
  const lsos::Catalog catalog(std::vector<lsos::ScriptFolder>{{folder.path(), ""}});
  lsos::LuaHost host(catalog);
  StandingRover rover;
  lsos::PhaseContext context{.rover = rover, .rover_id = "A", .sequence = 1, .label = "probe"};
  const lsos::ScriptInstance instance = host.begin("Probe", {});
  for (auto _ : state) benchmark::DoNotOptimize(host.run_phase(instance, "go", context));
}
BENCHMARK_CAPTURE(phase_call, stays, "");
BENCHMARK_CAPTURE(phase_call, sleeps, "return lsos.sleep(1)");
BENCHMARK_CAPTURE(phase_call, looks_and_counts,
                  "ev.state.n = (ev.state.n or 0) + 1\n"
                  "if rover.speed_mps > 1 then return lsos.done end");

BENCHMARK_CAPTURE(phase_call, has_ten_functions, "return f[1]() and nil",
                  "local f = {}\nfor k = 1, 10 do f[k] = function() return k end end");
BENCHMARK_CAPTURE(phase_call, has_a_hundred_numbers, "return t[1] > 1 and lsos.done or nil",
                  "local t = {}\nfor k = 1, 100 do t[k] = k end");

// For comparison: the same function body, called by bare Lua.
void bare_lua_call(benchmark::State& state) {
  lua_State* L = luaL_newstate();
  luaL_loadstring(L, "return function(ev, rover) end");
  lua_call(L, 0, 1);
  for (auto _ : state) {
    lua_pushvalue(L, -1);
    lua_pushnil(L);
    lua_pushnil(L);
    lua_pcall(L, 2, 0, 0);
  }
  lua_close(L);
}
BENCHMARK(bare_lua_call);

std::string placemark(const std::string& schema, const std::string& fields, double lon_deg) {
  return fmt::format(
      "<Placemark><ExtendedData><SchemaData schemaUrl=\"#{}\">{}</SchemaData></ExtendedData><Point>"
      "<coordinates>{:.6f},20</coordinates></Point></Placemark>\n",
      schema, fields, lon_deg);
}

std::string field(const char* name, const std::string& value) {
  return fmt::format("<SimpleData name=\"{}\">{}</SimpleData>", name, value);
}

// Rovers side by side, each with `events` events, routes and pauses alternately, some on a
// condition.
std::string plan(std::int64_t rovers, std::int64_t events) {
  std::string text =
      "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>\n"
      "<Placemark><ExtendedData><SchemaData schemaUrl=\"#MissionInfo\">" +
      field("Planet", "Moon") + field("StartTime", "2026-07-30T12:00:00Z") +
      field("Terrain", "Flat") + "</SchemaData></ExtendedData></Placemark>\n";
  for (std::int64_t r = 0; r < rovers; ++r) {
    const double lon_deg = 10 + 0.001 * static_cast<double>(r);
    const std::string id = field("RoverId", fmt::format("R{}", r));
    text += placemark("Rover", id + field("RoverType", "SEV"), lon_deg);
    for (std::int64_t e = 1; e <= events; ++e) {
      const std::string common = id + field("Sequence", std::to_string(e));
      text += e % 2 == 1
                  ? placemark("Route", common + field("StopWhen", "charge &lt; 0.3"), lon_deg)
                  : placemark("Pause", common + field("Duration", "10 min"), lon_deg);
    }
  }
  return text + "</Document></kml>\n";
}

// From the files to the synthesised machine: all that `lsos-host fsm` does before it prints,
// scripts included.
void read_check_and_synthesise(benchmark::State& state) {
  const TemporaryFolder folder;
  const std::string file = folder.write("plan.kml", plan(state.range(0), state.range(1)));
  for (auto _ : state) {
    const lsos::MissionFiles files = lsos::read_mission(file);
    files.faults.throw_if_errors();
    benchmark::DoNotOptimize(lsos::synthesise(files.plan, files.catalog->declarations()));
  }
}
BENCHMARK(read_check_and_synthesise)
    ->Args({1, 10})
    ->Args({10, 100})
    ->Args({100, 100})
    ->Unit(benchmark::kMillisecond);

}  // namespace
