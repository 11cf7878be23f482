// Scripts given as text, in a temporary folder, and a rover that only records commands.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "lua/host/catalog.h"
#include "lua/host/host.h"
#include "lua/host/script_folders.h"
#include "mission/rover/rover_power.h"

namespace lsos {

class RecordingRover : public RoverPort {
 public:
  RoverView rover;
  DriveState driving = {};
  std::vector<std::string> calls;  // "brake", "follow 2 points", "note NAME JSON"
  Path3 path;
  FollowSettings settings;
  RouteSettings route;
  PlannedRoute planned;
  RoverPower energy{{}, 1, {}};
  bool antenna_moves = true;  // whether deploying an antenna has an effect

  const RoverView& view() const override { return rover; }
  DriveState drive_state() const override { return driving; }
  void follow(const Path3& path_S_m, const FollowSettings& with) override {
    path = path_S_m;
    settings = with;
    calls.push_back("follow " + std::to_string(path.size()) + " points");
  }
  void follow_rover(const PursuitSettings& with) override {
    calls.push_back("follow rover " + with.leader_id + " at " + std::to_string(with.distance_m));
  }
  RoverPower& power() override { return energy; }
  Deployment deploy_antenna(const std::string& antenna, bool up,
                            std::optional<double> duration_s) override {
    calls.push_back((up ? "deploy '" : "stow '") + antenna + "'");
    return {duration_s.value_or(60), antenna_moves};
  }
  PlannedRoute plan_path(const Path3& waypoints_S_m, std::int64_t first,
                         const RouteSettings& with) override {
    route = with;
    calls.push_back("plan from " + std::to_string(first) + " of " +
                    std::to_string(waypoints_S_m.size()));
    return planned;
  }
  std::optional<GroundView> ground_at(const Vec3& p_S_m) const override {
    return GroundView{{p_S_m.x(), p_S_m.y(), 7}, 107, 0.1, "ApolloNominal"};
  }
  SkyView sky() const override { return {1, 0.5, not_modelled, not_modelled}; }
  Vec3 ahead_S_m(double distance_m) const override {
    return rover.p_S_m + distance_m * Vec3::UnitY();
  }
  std::map<std::string, Vec3> others;
  std::map<std::string, PairSight> sights;
  std::optional<Vec3> place_of_S_m(const std::string& id) const override {
    const auto found = others.find(id);
    return found == others.end() ? std::nullopt : std::optional(found->second);
  }
  std::optional<PairSight> sight_of(const std::string& id) const override {
    const auto found = sights.find(id);
    return found == sights.end() ? std::nullopt : std::optional(found->second);
  }
  double set_posture(const PostureRequest& request) override {
    calls.push_back("posture " + request.stance.value_or("as it is"));
    return request.duration_s.value_or(30);
  }
  void break_part(const Breakage& breakage) override {
    calls.push_back((breakage.is_repair ? "repair " : "break ") + breakage.what);
  }
  void brake() override { calls.push_back("brake"); }
  void note(const std::string& name, const std::string& fields_json) override {
    calls.push_back("note " + name + " " + fields_json);
  }
  void warn(const std::string& text) override { calls.push_back("warn " + text); }
};

// A folder with scripts that is removed with the object.
class ScriptDirectory {
 public:
  ScriptDirectory() {
    static std::atomic<int> count = 0;
    path_ = std::filesystem::path(::testing::TempDir()) /
            ("lsos_lua_" + std::to_string(::getpid()) + "_" + std::to_string(++count));
    std::filesystem::create_directories(path_);
  }
  ~ScriptDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScriptDirectory(const ScriptDirectory&) = delete;
  ScriptDirectory& operator=(const ScriptDirectory&) = delete;

  // write("events/Route.lua", text)
  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((path_ / file).parent_path());
    std::ofstream(path_ / file, std::ios::binary) << text;
  }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

inline std::string errors_of(const Catalog& catalog, ScriptKind kind, const std::string& name) {
  std::string text;
  for (const Fault& fault : catalog.faults_of(kind, name)) text += to_string(fault) + "\n";
  return text;
}

// One event with phases given as text, and the host that runs it.
class EventRun {
 public:
  // `body` is the Lua text before `return lsos.event {...}`; `event` is the text in its braces,
  // besides api, doc and start = 'go'.
  EventRun(const std::string& body, const std::string& event, const EventArguments& arguments = {},
           const Limits& limits = {}) {
    directory.write("events/Probe.lua", "local lsos = require 'lsos'\n" + body +
                                            "\nreturn lsos.event { api = 1, doc = 'A probe.', "
                                            "start = 'go', " +
                                            event + " }\n");
    catalog = std::make_unique<Catalog>(
        std::vector<ScriptFolder>{{directory.path(), ""}, {LSOS_SOURCE_DIR, "shipped"}});
    const std::string errors = errors_of(*catalog, ScriptKind::event, "Probe");
    if (!errors.empty()) throw std::runtime_error(errors);
    host = std::make_unique<LuaHost>(*catalog, limits);
    instance = host->begin("Probe", arguments);
    context.label = "probe 1";
    context.rover_id = "A";
    context.sequence = 10;
    context.seed = 7;
  }

  // Makes an event whose phase `go` has this text as its body.
  static std::unique_ptr<EventRun> of_phase(const std::string& text,
                                            const EventArguments& arguments = {},
                                            const Limits& limits = {}) {
    return std::make_unique<EventRun>("local function go(ev, rover)\n" + text + "\nend",
                                      "geometry = { 'none', 'point', 'line' }, "
                                      "phases = { go = go }",
                                      arguments, limits);
  }

  PhaseAnswer run(const std::string& phase = "go") {
    return host->run_phase(instance, phase, context);
  }
  // Message of the ScriptError that the phase must throw.
  std::string error(const std::string& phase = "go") {
    try {
      run(phase);
    } catch (const ScriptError& failure) {
      return failure.what();
    }
    return "no error";
  }
  // Saves the event, discards its host and restores it in a new one, as torture mode does.
  void recreate(const EventArguments& arguments = {}) {
    const std::string bytes = host->save(instance);
    host = std::make_unique<LuaHost>(*catalog);
    instance = host->begin("Probe", arguments);
    host->restore(instance, bytes);
  }

  ScriptDirectory directory;
  std::unique_ptr<Catalog> catalog;
  std::unique_ptr<LuaHost> host;
  ScriptInstance instance = 0;
  RecordingRover rover;
  PhaseContext context{rover, {}, {}, {}, {}, 0, "", 0, ""};
};

}  // namespace lsos
