#include "mission/simulation.h"

#include <gmock/gmock.h>

#include "mock_host.h"
#include "unit/vehicle/test_rover.h"

namespace lsos {
namespace {

using std::chrono::milliseconds;
using test::MockHost;
using test::MockInstance;
using testing::HasSubstr;

double number(const MockInstance& instance, const std::string& key) {
  return std::get<double>(instance.arguments.params.at(key));
}

// Hold: sleeps `duration_s`. Drive: follows its line. Twice: two Holds, one after the other.
// Break: fails after `duration_s`. Leave: drives off and ends. Poll: stays for three calls. Spin:
// goes round for ever.
std::unique_ptr<ScriptHost> make_host() {
  auto host = std::make_unique<MockHost>();
  host->add("Hold", "begin", [](MockInstance& i, PhaseContext& c) -> PhaseAnswer {
    i.state = seconds(c.now) + number(i, "duration_s");
    return GoTo{"hold"};
  });
  host->add("Hold", "hold", [](MockInstance& i, PhaseContext& c) -> PhaseAnswer {
    if (seconds(c.now) >= i.state) return Done{};
    return SleepUntil{from_seconds(i.state)};
  });
  host->add("Break", "only", [](MockInstance& i, PhaseContext& c) -> PhaseAnswer {
    if (c.now - c.event_start >= from_seconds(number(i, "duration_s"))) return Fail{"it broke"};
    return SleepUntil{c.now + from_seconds(number(i, "duration_s"))};
  });
  host->add("Drive", "go", [](MockInstance& i, PhaseContext& c) -> PhaseAnswer {
    FollowSettings settings;
    if (i.arguments.params.contains("speed_mps")) settings.speed_mps = number(i, "speed_mps");
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
    const DriveState drive = c.rover.drive();
    if (drive.status == DriveState::Status::failed) return Fail{drive.reason};
    if (drive.status == DriveState::Status::arrived) return Done{};
    return Arrival{};
  });
  host->set_drives("Drive");
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
  return host;
}

class Mission {
 public:
  Mission() {
    setup_.plan.mission.planet = find_body("Moon");
    setup_.plan.mission.start_time = *parse_utc("2026-01-01").value;
    setup_.terrain.name = "Test";
    setup_.terrain.surface = PlaneSurface{};
    setup_.terrain.soil = test::soil();
    setup_.make_host = make_host;
    RoverSpec spec;
    spec.vehicle = test::rover(1.6);
    spec.vehicle.links.clear();
    spec.suspension = test::suspension();
    setup_.rover_specs["Test"] = spec;
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
  // `east_m` of the last rover's start.
  PlanEvent& drive(double east_m) {
    PlanEvent& driven = event("Drive");
    const Body& moon = *find_body("Moon");
    const SiteFrame site(moon, setup_.plan.rovers.back().start);
    driven.geometry = {GeometryKind::point, {site.geodetic({east_m, 0, 0})}, 1};
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

TEST(Simulation, runs_the_events_of_a_rover_one_after_another) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 5);
  mission.event("Hold", 2.05);
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[0].end, milliseconds(5000));
  EXPECT_EQ(events[1].ready, milliseconds(5000));
  // Wakes are rounded up to an exchange.
  EXPECT_EQ(events[1].end, milliseconds(7100));
  EXPECT_EQ(events[1].status, EventStatus::completed);
}

TEST(Simulation, leaps_over_quiet_time) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 14.0 * 86400);
  MockHost::calls = 0;
  mission.run();
  EXPECT_EQ(mission.exchanges, 1);
  EXPECT_EQ(MockHost::calls, 3);
  EXPECT_EQ(mission.simulation_->now(), std::chrono::hours(14 * 24));
}

TEST(Simulation, calls_a_phase_that_stays_at_each_exchange) {
  Mission mission;
  mission.rover("A");
  mission.event("Poll");
  EXPECT_EQ(mission.run()[0].end, milliseconds(200));
}

TEST(Simulation, an_event_may_be_made_of_others) {
  Mission mission;
  mission.rover("A");
  mission.event("Twice");
  EXPECT_EQ(mission.run()[0].end, milliseconds(20000));
}

TEST(Simulation, an_event_that_goes_round_without_time_passing_fails) {
  Mission mission;
  mission.rover("A");
  mission.event("Spin");
  const EventRow event = mission.run()[0];
  EXPECT_EQ(event.status, EventStatus::failed);
  EXPECT_THAT(event.reason, HasSubstr("without time passing"));
}

TEST(Simulation, a_failed_event_stops_its_rover_but_not_the_other) {
  Mission mission;
  mission.rover("A");
  mission.event("Break", 1);
  mission.event("Hold", 1);
  mission.rover("B");
  mission.event("Hold", 5);
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::failed);
  EXPECT_EQ(events[0].reason, "it broke");
  EXPECT_EQ(events[1].status, EventStatus::not_started);
  EXPECT_EQ(events[2].status, EventStatus::completed);
}

TEST(Simulation, on_failure_skips_aborts_and_goes_to_a_later_event) {
  Mission skip;
  skip.rover("A");
  skip.event("Break", 1).on_failure = OnFailure::skip;
  skip.event("Hold", 1);
  EXPECT_EQ(skip.run()[1].status, EventStatus::completed);

  Mission go_to;
  go_to.rover("A");
  PlanEvent& broken = go_to.event("Break", 1);
  broken.on_failure = OnFailure::go_to;
  broken.go_to_sequence = 3;
  go_to.event("Hold", 1);
  go_to.event("Hold", 1);
  const std::vector<EventRow> events = go_to.run();
  EXPECT_EQ(events[1].status, EventStatus::skipped);
  EXPECT_THAT(events[1].reason, HasSubstr("goes to 'Hold 3'"));
  EXPECT_EQ(events[2].status, EventStatus::completed);

  Mission abort;
  abort.rover("A");
  abort.event("Break", 1).on_failure = OnFailure::abort;
  abort.rover("B");
  abort.event("Hold", 100);
  abort.event("Hold", 100);
  const std::vector<EventRow> aborted = abort.run();
  EXPECT_EQ(aborted[1].status, EventStatus::incomplete);
  EXPECT_EQ(aborted[2].status, EventStatus::not_started);
  EXPECT_TRUE(aborted[2].is_prevented);
}

TEST(Simulation, a_timeout_fails_the_event_and_lets_its_script_clean_up) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 100).timeout = milliseconds(10000);
  MockHost::aborts = 0;
  const EventRow event = mission.run()[0];
  EXPECT_EQ(event.status, EventStatus::failed);
  EXPECT_EQ(event.end, milliseconds(10000));
  EXPECT_THAT(event.reason, HasSubstr("timed out after 10 s"));
  EXPECT_EQ(MockHost::aborts, 1);
}

TEST(Simulation, waits_for_the_events_of_another_rover_until_the_next_exchange) {
  // In either order of ids.
  for (const bool first : {true, false}) {
    Mission mission;
    mission.rover("A");
    mission.event("Hold", first ? 5 : 1).start_after = {};
    mission.rover("B");
    mission.event("Hold", first ? 1 : 5);
    mission.setup_.plan.events[first ? 1 : 0].start_after = {first ? PlanEvent::Reference{"A", 1}
                                                                   : PlanEvent::Reference{"B", 2}};
    const std::vector<EventRow> events = mission.run();
    EXPECT_EQ(events[first ? 1 : 0].start, milliseconds(5100));
    EXPECT_EQ(events[first ? 1 : 0].ready, milliseconds(0));
  }
}

TEST(Simulation, an_event_fails_when_what_it_waits_for_can_no_longer_run) {
  Mission mission;
  mission.rover("A");
  mission.event("Break", 1);
  mission.event("Hold", 1);
  mission.rover("B");
  mission.event("Hold", 1).start_after = {{"A", 2}};
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[2].status, EventStatus::failed);
  EXPECT_THAT(events[2].reason, HasSubstr("A/2"));
}

TEST(Simulation, starts_an_event_not_before_its_time) {
  Mission mission;
  mission.rover("A");
  PlanEvent& event = mission.event("Hold", 1);
  event.start_time = mission.setup_.plan.mission.start_time + milliseconds(60000);
  const EventRow row = mission.run()[0];
  EXPECT_EQ(row.start, milliseconds(60000));
  EXPECT_EQ(row.end, milliseconds(61000));
}

TEST(Simulation, a_disabled_event_is_passed_over_and_counts_as_ended) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 100).is_enabled = false;
  mission.event("Hold", 1);
  mission.rover("B");
  mission.event("Hold", 1).start_after = {{"A", 1}};
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::disabled);
  EXPECT_EQ(events[1].end, milliseconds(1000));
  EXPECT_EQ(events[2].start, milliseconds(100));
}

TEST(Simulation, max_duration_ends_the_run_as_incomplete) {
  Mission mission;
  mission.setup_.plan.mission.max_duration = milliseconds(30000);
  mission.rover("A");
  mission.event("Hold", 100);
  const EventRow event = mission.run()[0];
  EXPECT_EQ(event.status, EventStatus::incomplete);
  EXPECT_EQ(mission.simulation_->now(), milliseconds(30000));
}

TEST(Simulation, drives_a_rover_to_its_point) {
  Mission mission;
  mission.rover("A");
  mission.drive(20);
  const EventRow event = mission.run()[0];
  EXPECT_EQ(event.status, EventStatus::completed) << event.reason;
  EXPECT_NEAR(event.distance_m, 20, 0.5);
  EXPECT_NEAR(mission.simulation_->results()[0].distance_m, 20, 0.5);
}

TEST(Simulation, an_event_that_ends_at_its_timeout_has_not_taken_longer) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 60).timeout = milliseconds(60000);
  EXPECT_EQ(mission.run()[0].status, EventStatus::completed);
}

TEST(Simulation, brakes_at_the_end_of_an_event_that_left_its_rover_driving) {
  Mission mission;
  mission.rover("A");
  mission.drive(50).type = "Leave";
  mission.event("Hold", 30);
  const std::vector<EventRow> events = mission.run();
  EXPECT_EQ(events[0].status, EventStatus::completed);
  EXPECT_LT(mission.simulation_->results()[0].distance_m, 5);
}

TEST(Simulation, finds_at_once_that_one_of_several_awaited_events_can_no_longer_run) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 1000);
  mission.rover("B");
  mission.event("Break", 5);
  mission.event("Hold", 1);
  mission.rover("C");
  mission.event("Hold", 1).start_after = {{"A", 1}, {"B", 3}};
  const EventRow event = mission.run()[3];
  EXPECT_EQ(event.status, EventStatus::failed);
  EXPECT_EQ(event.end, milliseconds(5100));
}

TEST(Simulation, refuses_a_start_too_steep_to_stand_on) {
  Mission mission;
  mission.setup_.terrain.surface = PlaneSurface{0, 0.7, 0};
  mission.rover("A");
  mission.event("Hold", 1);
  try {
    mission.run();
    FAIL() << "the rover stands on 40 degrees";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("does not come to rest there: the ground slopes by 40 deg"));
  }
}

TEST(Simulation, warns_of_a_speed_that_the_rover_does_not_reach) {
  Mission mission;
  mission.rover("A");
  mission.drive(5).params["speed_mps"] = 50.0;
  mission.run();
  ASSERT_EQ(mission.simulation_->warnings().size(), 1u);
  EXPECT_THAT(mission.simulation_->warnings()[0], HasSubstr("asked to drive at 50 m/s"));
}

// Two rovers, driving and waiting for each other; a fingerprint of where everything ended.
std::string fingerprint(int threads, bool save_every_exchange) {
  Mission mission;
  mission.setup_.threads = threads;
  mission.setup_.save_every_exchange = save_every_exchange;
  mission.rover("A");
  mission.drive(15);
  mission.event("Twice");
  mission.rover("B");
  mission.event("Hold", 1).start_after = {{"A", 1}};
  mission.drive(-12);
  mission.run();
  return mission.simulation_->save();
}

TEST(Simulation, ends_in_the_same_bits_again_on_two_threads_and_in_torture) {
  const std::string once = fingerprint(1, false);
  EXPECT_EQ(fingerprint(1, false), once);
  EXPECT_EQ(fingerprint(2, false), once);
  EXPECT_EQ(fingerprint(1, true), once);
}

TEST(Simulation, goes_on_from_saved_state_to_the_same_end) {
  Mission mission;
  mission.rover("A");
  mission.drive(10);
  mission.event("Hold", 5);
  mission.run();
  const std::string end = mission.simulation_->save();

  Simulation first(mission.setup_);
  first.start();
  for (int i = 0; i < 57; ++i) first.advance();
  const std::string middle = first.save();
  Simulation second(mission.setup_);
  second.restore(middle);
  while (!second.is_finished()) second.advance();
  second.terminate();
  EXPECT_EQ(second.save(), end);
}

}  // namespace
}  // namespace lsos
