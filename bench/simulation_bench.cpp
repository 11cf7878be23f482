// Speed of the simulation: a rover that drives, a rover that stands, a plan that is read.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "lua/host/mission_reader.h"
#include "record/log.h"

namespace {

namespace fs = std::filesystem;

// A file in the folder for temporary files, removed at the end.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text)
      : path_(fs::temp_directory_path() / fmt::format("lsos-bench-{}-{}", ::getpid(), name)) {
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { fs::remove(path_); }
  std::string path() const { return path_; }

 private:
  fs::path path_;
};

std::string placemark(const std::string& schema,
                      const std::vector<std::pair<std::string, std::string>>& fields,
                      const std::string& geometry) {
  std::string text = fmt::format("<Placemark><ExtendedData><SchemaData schemaUrl=\"#{}\">", schema);
  for (const auto& [name, value] : fields) {
    text += fmt::format("<SimpleData name=\"{}\">{}</SimpleData>", name, value);
  }
  return text + "</SchemaData></ExtendedData>" + geometry + "</Placemark>\n";
}

std::string point(double lon_deg, double lat_deg) {
  return fmt::format("<Point><coordinates>{:.7f},{:.7f}</coordinates></Point>", lon_deg, lat_deg);
}

std::string mission(const std::string& terrain, const std::string& planet,
                    const std::string& placemarks) {
  return "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>\n" +
         placemark("MissionInfo",
                   {{"Planet", planet},
                    {"StartTime", "2026-07-30T12:00:00Z"},
                    {"Terrain", terrain},
                    {"ParkedLogInterval", "60 s"}},
                   "") +
         placemarks + "</Document></kml>\n";
}

std::string plan(const std::string& terrain, const std::string& events,
                 const std::string& planet = "Moon") {
  return mission(terrain, planet,
                 placemark("Rover", {{"RoverId", "A"}, {"RoverType", "SEV"}},
                           "<Point><coordinates>10,20</coordinates></Point>") +
                     events);
}

// Its counter is simulated seconds per second of wall time.
void simulate(benchmark::State& state, const std::string& text, double limit_s, bool is_logged,
              int threads = 1) {
  const TemporaryFile file("plan.kml", text);
  double sim_s = 0;
  for (auto _ : state) {
    state.PauseTiming();
    lsos::MissionFiles files = lsos::read_mission(file.path());
    files.faults.throw_if_errors();
    lsos::SimulationSetup setup = lsos::simulation_setup(files);
    setup.keeps_sight = is_logged;
    setup.threads = threads;
    lsos::Simulation simulation(std::move(setup));
    const std::string log_file = file.path() + ".gpkg";
    std::unique_ptr<lsos::LogWriter> log;
    if (is_logged) {
      log = std::make_unique<lsos::LogWriter>(log_file, "IAU_2015:30100",
                                              files.plan.mission.start_time);
      simulation.set_log(log.get());
    }
    state.ResumeTiming();
    simulation.start();
    while (!simulation.is_finished() && lsos::seconds(simulation.now()) < limit_s) {
      simulation.advance();
    }
    if (log) log->finish();
    state.PauseTiming();
    sim_s += lsos::seconds(simulation.now());
    log.reset();
    fs::remove(log_file);
    state.ResumeTiming();
  }
  state.counters["x_real_time"] = benchmark::Counter(sim_s, benchmark::Counter::kIsRate);
}

// One SEV: 12 wheels, steps of 5 ms, logged at 0.5 Hz.
void sev_drives(benchmark::State& state, const std::string& terrain) {
  simulate(
      state,
      plan(terrain, placemark("Route", {{"RoverId", "A"}, {"Sequence", "1"}}, point(10.05, 20))),
      120, true);
}
BENCHMARK_CAPTURE(sev_drives, flat, "Flat")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sev_drives, craters, "Craters")->Unit(benchmark::kMillisecond);

// ATHLETE: 42 joints, steps of 5 ms, with posture control, without light, sight and log.
void athlete_drives(benchmark::State& state, const std::string& terrain) {
  simulate(state,
           mission(terrain, "Moon",
                   placemark("Rover", {{"RoverId", "A"}, {"RoverType", "ATHLETE"}}, point(10, 20)) +
                       placemark("Route", {{"RoverId", "A"}, {"Sequence", "1"}}, point(10.05, 20))),
           120, false);
}
BENCHMARK_CAPTURE(athlete_drives, flat, "Flat")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(athlete_drives, craters, "Craters")->Unit(benchmark::kMillisecond);

// Three rovers side by side on as many threads as its argument says. Divide two of its times.
void three_rovers_drive(benchmark::State& state, const std::string& type) {
  std::string placemarks;
  double lat_deg = 20;
  for (const char* id : {"A", "B", "C"}) {
    lat_deg += 0.01;
    placemarks += placemark("Rover", {{"RoverId", id}, {"RoverType", type}}, point(10, lat_deg)) +
                  placemark("Route", {{"RoverId", id}, {"Sequence", "1"}}, point(10.05, lat_deg));
  }
  simulate(state, mission("Craters", "Moon", placemarks), 120, false,
           static_cast<int>(state.range(0)));
}
BENCHMARK_CAPTURE(three_rovers_drive, sev, "SEV")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(three_rovers_drive, athlete, "ATHLETE")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// What one checkpoint of three driving rovers costs: their state encoded, and written into a log
// with a commit. Once a minute of wall time this is share_of_a_minute of a run.
void checkpoint_of_three_rovers(benchmark::State& state) {
  std::string placemarks;
  double lat_deg = 20;
  for (const char* id : {"A", "B", "C"}) {
    lat_deg += 0.01;
    placemarks +=
        placemark("Rover", {{"RoverId", id}, {"RoverType", "ATHLETE"}}, point(10, lat_deg)) +
        placemark("Route", {{"RoverId", id}, {"Sequence", "1"}}, point(10.05, lat_deg));
  }
  const TemporaryFile file("plan.kml", mission("Craters", "Moon", placemarks));
  lsos::MissionFiles files = lsos::read_mission(file.path());
  files.faults.throw_if_errors();
  lsos::SimulationSetup setup = lsos::simulation_setup(files);
  lsos::Simulation simulation(std::move(setup));
  const std::string log_file = file.path() + ".gpkg";
  lsos::LogWriter log(log_file, "IAU_2015:30100", files.plan.mission.start_time);
  simulation.set_log(&log);
  simulation.start();
  while (lsos::seconds(simulation.now()) < 20) simulation.advance();
  std::size_t bytes = 0;
  for (auto _ : state) {
    lsos::Checkpoint checkpoint;
    checkpoint.time = simulation.now();
    checkpoint.state = simulation.save();
    bytes = checkpoint.state.size();
    log.write(checkpoint);
  }
  state.counters["bytes"] = static_cast<double>(bytes);
  state.counters["share_of_a_minute"] = benchmark::Counter(
      60, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  fs::remove(log_file);
}
BENCHMARK(checkpoint_of_three_rovers)->UseRealTime()->Unit(benchmark::kMillisecond);

// One panel and a battery; the Sun is observed each 354 s (Moon) or minute.
void sev_parked_for_a_day(benchmark::State& state, const std::string& planet,
                          const std::string& terrain, bool is_logged) {
  simulate(state,
           plan(terrain,
                placemark("Pause", {{"RoverId", "A"}, {"Sequence", "1"}, {"Duration", "1 d"}}, ""),
                planet),
           1e9, is_logged);
}
BENCHMARK_CAPTURE(sev_parked_for_a_day, moon_without_log, "Moon", "Flat", false)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sev_parked_for_a_day, moon, "Moon", "Flat", true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sev_parked_for_a_day, moon_craters, "Moon", "Craters", true)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sev_parked_for_a_day, mars, "Mars", "Flat", true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sev_parked_for_a_day, earth, "Earth", "Flat", true)
    ->Unit(benchmark::kMillisecond);

void read_plan_of_placemarks(benchmark::State& state) {
  std::string events;
  for (int i = 1; i <= state.range(0); ++i) {
    events += placemark("Pause",
                        {{"RoverId", "A"}, {"Sequence", std::to_string(i)}, {"Duration", "10 s"}},
                        point(10, 20));
  }
  const TemporaryFile file("large.kml", plan("Flat", events));
  const auto catalog = lsos::read_catalog("");
  for (auto _ : state) {
    lsos::Faults faults;
    benchmark::DoNotOptimize(lsos::read_plan(file.path(), catalog->declarations(), faults));
    faults.throw_if_errors();
  }
}
BENCHMARK(read_plan_of_placemarks)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

}  // namespace
