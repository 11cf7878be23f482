// A mission of mock events, put together in a test and run to its end.
#pragma once

#include "mission/simulation.h"
#include "mock_host.h"
#include "unit/vehicle/test_rover.h"

namespace lsos::test {

using std::chrono::milliseconds;

inline double number(const MockInstance& instance, const std::string& key) {
  return std::get<double>(instance.arguments.params.at(key));
}

// Hold: sleeps `duration_s`. Drive: follows its line. Twice: two Holds, one after the other. Break:
// fails after `duration_s`. Leave: drives off and ends. Poll: stays for three calls. Spin: loops
// for ever. Work: uses power for `duration_s`. Plan: follows a planned route. Twitch: locks a wheel
// and its steering.
inline std::unique_ptr<ScriptHost> make_host() {
  auto host = std::make_unique<MockHost>();
  host->add("Hold", "begin", [](MockInstance& i, PhaseContext& c) -> PhaseAnswer {
    i.state = seconds(c.now) + number(i, "duration_s");
    return GoTo{"hold"};
  });
  host->add("Hold", "hold", [](MockInstance& i, PhaseContext& c) -> PhaseAnswer {
    if (seconds(c.now) >= i.state) return Done{};
    return SleepUntil{from_seconds(i.state)};
  });
  host->set_goes_on_without_power("Hold");
  host->add("Work", "only", [](MockInstance& i, PhaseContext& c) -> PhaseAnswer {
    c.rover.power().set_work(number(i, "power_w"));
    const SimTime end = c.event_start + from_seconds(number(i, "duration_s"));
    if (c.now >= end) return Done{};
    return SleepUntil{end};
  });
  host->add("Break", "only", [](MockInstance& i, PhaseContext& c) -> PhaseAnswer {
    if (c.now - c.event_start >= from_seconds(number(i, "duration_s"))) return Fail{"it broke"};
    return SleepUntil{c.now + from_seconds(number(i, "duration_s"))};
  });
  host->add("Drive", "go", [](MockInstance& i, PhaseContext& c) -> PhaseAnswer {
    FollowSettings settings;
    if (i.arguments.params.contains("speed_mps")) settings.speed_mps = number(i, "speed_mps");
    if (i.arguments.params.contains("slope_max_rad")) {
      settings.slope_max_rad = number(i, "slope_max_rad");
    }
    c.rover.follow(i.arguments.geometry_S_m, settings);
    return GoTo{"arrive"};
  });
  host->add("Leave", "only", [](MockInstance& i, PhaseContext& c) -> PhaseAnswer {
    if (i.state > 0) return Done{};
    i.state = 1;
    c.rover.follow(i.arguments.geometry_S_m, {});
    return SleepUntil{c.now + milliseconds(2000)};
  });
  host->set_drives("Leave");
  host->add("Drive", "arrive", [](MockInstance&, PhaseContext& c) -> PhaseAnswer {
    const DriveState drive = c.rover.drive_state();
    if (drive.status == DriveState::Status::failed) return Fail{drive.reason};
    if (drive.status == DriveState::Status::arrived) return Done{};
    return Arrival{};
  });
  host->set_drives("Drive");
  host->add("Plan", "plan", [](MockInstance& i, PhaseContext& c) -> PhaseAnswer {
    const PlannedRoute way = c.rover.plan_path(i.arguments.geometry_S_m, 1, mock_route_settings());
    if (!way.is_found()) return Fail{way.reason};
    c.rover.follow(way.path_S_m, {});
    return GoTo{"arrive"};
  });
  host->add("Plan", "arrive", [](MockInstance&, PhaseContext& c) -> PhaseAnswer {
    const DriveState drive = c.rover.drive_state();
    if (drive.status == DriveState::Status::failed) return Fail{drive.reason};
    if (drive.status == DriveState::Status::arrived) return Done{};
    return Arrival{};
  });
  host->set_plans("Plan");
  const auto inner = [](const std::string& next) {
    return [next](MockInstance&, PhaseContext&) -> PhaseAnswer {
      return RunEvent{"Hold", {{{"duration_s", 10.0}}, {}}, next};
    };
  };
  host->add("Twice", "first", inner("second"));
  host->add("Twice", "second", inner(""));
  host->add("Poll", "poll", [](MockInstance& i, PhaseContext&) -> PhaseAnswer {
    if (++i.state >= 3) return Done{};
    return Stay{};
  });
  host->add("Spin", "a", [](MockInstance&, PhaseContext&) -> PhaseAnswer { return GoTo{"a"}; });
  host->set_place("Spin", "events/Spin.lua", 7);
  host->add("Twitch", "only", [](MockInstance&, PhaseContext& c) -> PhaseAnswer {
    c.rover.break_part({.what = "wheel", .part = "front_left_wheel_1", .share = {}});
    c.rover.break_part({.what = "steering", .part = "front_left_steering", .share = {}});
    return Done{};
  });
  return host;
}

class Mission {
 public:
  Mission() {
    setup_.plan.mission.planet = find_body("Moon");
    setup_.plan.mission.start_time = *parse_utc("2026-01-01").value;
    setup_.terrain.name = "Test";
    setup_.terrain.layers = {PlaneSurface{}};
    setup_.terrain.soil = test::soil();
    setup_.make_host = make_host;
    RoverSpec spec;
    spec.vehicle = test::rover(1.6);
    spec.vehicle.links.clear();
    spec.suspension = test::suspension();
    setup_.rover_models["Test"].spec = spec;
  }

  Mission& rover(const std::string& id) {
    PlanRover rover;
    rover.id = id;
    rover.type = "Test";
    rover.start = {0.1, 0.2 + 1e-5 * static_cast<double>(setup_.plan.rovers.size()), 0};
    setup_.plan.rovers.push_back(rover);
    return *this;
  }
  PlanEvent& event(const std::string& type, double duration_s = 0) {
    PlanEvent event;
    event.type = type;
    event.rover_id = setup_.plan.rovers.back().id;
    event.sequence = static_cast<std::int64_t>(setup_.plan.events.size()) + 1;
    event.label = type + " " + std::to_string(event.sequence);
    event.params["duration_s"] = duration_s;
    setup_.plan.events.push_back(event);
    return setup_.plan.events.back();
  }
  // The goal is `east_m` east of the last rover's start.
  PlanEvent& drive(double east_m) { return drive("Drive", east_m); }
  PlanEvent& drive(const std::string& type, double east_m) {
    PlanEvent& driven = event(type);
    const Body& moon = *find_body("Moon");
    const SiteFrame site(moon, setup_.plan.rovers.back().start);
    driven.geometry = {GeometryKind::point, {site.geodetic({east_m, 0, 0})}, {}, 1};
    return driven;
  }

  std::vector<EventRow> run() {
    simulation_ = std::make_unique<Simulation>(setup_);
    simulation_->start();
    while (!simulation_->is_finished()) {
      simulation_->advance();
      ++exchanges;
    }
    simulation_->terminate();
    return simulation_->events();
  }

  SimulationSetup setup_;
  std::unique_ptr<Simulation> simulation_;
  int exchanges = 0;
};

}  // namespace lsos::test
