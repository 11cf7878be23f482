#include "lua/app/common_options.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "access/file_access.h"
#include "base/error.h"
#include "lua/host/script_folders.h"

namespace lsos {

namespace {

std::vector<std::string> given_access;

// The folders that an environment variable names, with colons between them.
std::vector<std::string> listed_folders(const char* variable) {
  const char* text = std::getenv(variable);
  std::istringstream list(text == nullptr ? "" : text);
  std::vector<std::string> folders;
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.push_back(folder);
  }
  return folders;
}

}  // namespace

CommandOption add_threads(CommandOptions& command, int& threads, const char* what) {
  return command.add_option("--threads", threads, what).between(1, 256);
}

void add_style(CommandOptions& command, AnswerStyle& style) {
  command.add_flag(
      "--json", [&] { style = AnswerStyle::json; }, "JSON, as in a file or a pipe");
  command.add_flag(
      "--text", [&] { style = AnswerStyle::text; }, "A table, as on a terminal");
}

void add_ground(CommandOptions& command, TerrainOptions& terrain) {
  command.add_option("NAME", terrain.name, "A terrain script by name, or a raster").required();
  command.add_option("--beyond", terrain.beyond,
                     "The ground where that raster ends: a coarser raster, or a terrain script");
  command.add_option("--band", terrain.band, "Of the raster: a number from 1, or a description");
  command.add_option("--nodata", terrain.nodata, "The sample that stands for none");
  command.add_option("--unit", terrain.unit, "Of its samples: m, km, dm, cm, mm, ft, us-ft");
  command.add_flag(
      "--radius", [&] { terrain.is_radius = true; }, "Its samples are radii (as their size says)");
  command.add_flag(
      "--no-radius", [&] { terrain.is_radius = false; }, "Its samples are no radii");
  command.add_option("--crs", terrain.crs, "In place of the raster's own: IAU_2015:30135, ...");
  command.add_option("--planet", terrain.planet, "Of a script (its raster's, else Moon)");
  command.add_option("--site", terrain.site,
                     "LON,LAT where x, y and generated ground begin (the first --at, --from, or "
                     "the window's centre)");
  command.add_option("--seed", terrain.seed, "Of generated ground (0)").seed();
  command.add_option("--window", terrain.window,
                     "LON0,LAT0,LON1,LAT1 of the map (all of the finest raster)");
  command.add_option("--resolution", terrain.resolution_m,
                     "Cell size of the map, m (the finest raster's own grid)");
}

void add_access(CommandOptions& command, AccessOptions& access) {
  command
      .add_option("--allow-files", access.folders,
                  "A folder of rasters that the plan, or a VRT, may read beside its own")
      .repeated();
  command.add_flag("--allow-network", access.has_network, "Rasters may come from the network");
}

void restrict_to(const AccessOptions& access) {
  given_access.clear();
  for (const std::string& folder : access.folders) {
    given_access.insert(given_access.end(), {"--allow-files", folder});
  }
  if (access.has_network) given_access.emplace_back("--allow-network");
  restrict_access(access.has_network);
  Faults faults;
  const auto allow = [&](const std::string& option, const std::string& folder) {
    std::error_code absent;
    if (!std::filesystem::is_directory(folder, absent)) {
      faults.error({}, fmt::format("{}: there is no folder '{}'", option, folder));
    }
    allow_folder(folder);
  };
  for (const std::string& folder : access.folders) allow("--allow-files", folder);
  for (const std::string& folder : listed_folders("LSOS_ALLOW_FILES")) {
    allow("LSOS_ALLOW_FILES", folder);
  }
  faults.throw_if_errors();
  for (const char* variable : {"LSOS_PATH", "LSOS_REFERENCE_DATA"}) {
    for (const std::string& folder : listed_folders(variable)) allow_folder(folder);
  }
  allow_folder(shipped_scripts());
}

const std::vector<std::string>& access_words() { return given_access; }

}  // namespace lsos
