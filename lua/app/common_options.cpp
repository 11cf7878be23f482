#include "lua/app/common_options.h"

namespace lsos {

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

}  // namespace lsos
