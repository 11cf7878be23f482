// The program's commands. Each returns its exit code: 0 completed, 1 an event failed or is
// incomplete, 130/143 stopped by a signal; wrong input is thrown as InputError.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lsos {

// How an instrument answers: a table on a terminal and JSON elsewhere, or as it is asked to.
enum class AnswerStyle { by_output, json, text };

struct RunOptions {
  std::string plan;
  std::string folder;  // "": out/PLAN-NAME
  bool is_quiet = false;
  bool is_json = false;
  bool is_forced = false;  // replace an unfinished run
  bool has_report = true;  // report.html
  int threads = 1;
  std::optional<std::uint64_t> seed;  // instead of the plan's
  bool save_every_exchange = false;
};
int run_command(const RunOptions& options);
// Runs it again each time that the plan or a script changes, until a signal comes.
int watch_command(RunOptions options);

struct CheckOptions {
  std::string plan;
  std::optional<std::uint64_t> seed;
  bool is_json = false;
  bool is_verbose = false;
  bool is_quiet = false;
};
int check_command(const CheckOptions& options);

int fsm_command(const std::string& plan, bool is_json);

struct TestOptions {
  std::vector<std::string> paths{"tests/scenarios"};
  std::string filter;  // only scenarios with it in their name, or their file's
  std::string junit_file;
  std::string folder = "out/scenarios";  // of the logs of those that fail
  int threads = 2;
  bool is_json = false;
};
int test_command(const TestOptions& options);

// `plan_file`: "": none.
int repl_command(const std::string& plan_file);

// KML <Schema> elements, and a plan with one Placemark each, of these events or of all.
// As KML; or the names, types, docs and examples of the fields as JSON.
struct SchemaOptions {
  std::vector<std::string> names;  // events; none: all
  bool is_json = false;
  std::string file;             // .kml or .gpkg; "": KML on standard output
  std::string planet = "Moon";  // of a GeoPackage
};
int schema_command(const SchemaOptions& options);
// A script that works to begin from, and a scenario that tests it; or a plan. Says in JSON or for
// people which files it wrote.
struct NewOptions {
  std::string what;  // event, rover, terrain, scenario, plan
  std::string name;
  std::string from;  // a rover type; of a terrain a raster; "": SEV, or synthetic ground
  std::string planet, terrain, site;  // of a plan; "": Moon, Craters, 0,0
  bool is_json = false;
};
int new_command(const NewOptions& options);

struct ListOptions {
  std::string what;  // events, rovers, terrains, soils
  std::string name;  // "": all
  bool is_json = false;
};
int list_command(const ListOptions& options);

struct RigOptions {
  std::string soil;  // a name, or a file
  double radius_m = 0, width_m = 0, load_n = 0;
  double grouser_height_m = 0;
  int grouser_count = 0;
  double interface_friction_ratio = 0.8;
  std::optional<double> stiffness_npm;  // absent: the load flattens the wheel by 1 % of its radius
  double gravity_mps2 = 9.80665;
  std::vector<double> slips;
  double slip_angle_deg = 0;
  AnswerStyle style = AnswerStyle::by_output;
};
int rig_command(const RigOptions& options);

struct TerrainOptions {
  std::string name;    // of a terrain script, or a raster
  std::string beyond;  // the same, where that one ends; "": none
  // Of a raster alone; a script says its own.
  std::string band;  // its number or description
  std::optional<double> nodata;
  std::string unit;
  std::optional<bool> is_radius;
  std::string crs;

  std::string planet;           // of a script without a raster; "": Moon
  std::string site;             // "LON,LAT"; "": the first of `at`, or the window's centre
  std::uint64_t seed = 0;       // of generated ground
  std::vector<std::string> at;  // "LON,LAT"
  std::string export_file;
  std::string window;  // "LON0,LAT0,LON1,LAT1"
  std::optional<double> resolution_m;
  bool is_hillshade = false;
  AnswerStyle style = AnswerStyle::by_output;
};
int terrain_command(const TerrainOptions& options);

struct LightOptions {
  TerrainOptions terrain;  // of these name, raster, planet, site, seed, window, resolution
  std::string at;          // UTC
  std::string file;        // OUT.tif
  int threads = 1;
};
int light_command(const LightOptions& options);

struct SightOptions {
  TerrainOptions terrain;          // of these name, raster, planet, site, seed, window, resolution
  std::string from;                // "LON,LAT,H", H above the ground
  std::vector<std::string> to;     // the same
  std::optional<double> height_m;  // of targets all over a map, above the ground
  std::string file;                // OUT.tif; "": no map
  bool is_flat = false;
  int threads = 1;
};
int sight_command(const SightOptions& options);

struct SunOptions {
  std::string planet;
  std::string site;             // "LON,LAT[,HEIGHT]"
  std::vector<std::string> at;  // UTC
  AnswerStyle style = AnswerStyle::by_output;
};
int sun_command(const SunOptions& options);

struct PictureOptions {
  std::string folder;  // of a run
  std::string at;      // UTC, or a time from the start; "": of a film
  std::string from;    // "": chase for a film, else sun
  std::string rover;   // "": the first
  std::string file;    // X.png, X.mp4
  int size_px = 0;     // 0: as the view has it
  bool is_movie = false;
  std::string every;  // of a film, "": some 250 pictures
  bool is_quiet = false;
  AnswerStyle style = AnswerStyle::by_output;
};
int picture_command(const PictureOptions& options);

struct ReportOptions {
  std::string folder;     // of a run
  std::string file;       // "": DIR/report.html, DIR/report.png
  std::string shadow_at;  // UTC, or a time from the start; "": the start
  bool has_pictures = true;
  bool is_figure = false;  // a PNG for a paper
  std::optional<int> dpi;
  int threads = 2;
  bool is_json = false;
};
int report_command(const ReportOptions& options);

struct CompareOptions {
  std::array<std::string, 2> folders;
  bool is_exact = false;  // value by value of the logs
  bool is_json = false;
};
int compare_command(const CompareOptions& options);

struct VerifyOptions {
  std::vector<std::string> folders;
  bool is_json = false;
};
// 1: a log is not the one that its summary was written of.
int verify_command(const VerifyOptions& options);

int overlay_command(const std::string& folder, bool is_packed, bool is_json);

}  // namespace lsos
