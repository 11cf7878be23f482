// Parses places and windows given in degrees as options of instruments.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "planet/body.h"
#include "terrain/raster/map_grid.h"

namespace lsos {

// The numbers in "1.5,-2,..."; a fault that names the option unless there are `count` of them.
std::optional<std::vector<double>> option_numbers(const std::string& option,
                                                  const std::string& text, std::size_t count,
                                                  const std::string& form, Faults& faults);

// The parts between the commas of "0,0.2", also empty ones.
std::vector<std::string> option_parts(const std::string& text);

// "LON,LAT": longitude -180..360, latitude -90..90.
std::optional<Geodetic> option_place(const std::string& option, const std::string& text,
                                     Faults& faults);

// "LON,LAT[,HEIGHT]": the height in m, or a length with a unit.
std::optional<Geodetic> option_site(const std::string& option, const std::string& text,
                                    Faults& faults);

// "LON0,LAT0,LON1,LAT1" of --window: west, south, east, north.
std::optional<MapWindow> option_window(const std::string& text, Faults& faults);

// Moon, Mars or Earth.
const Body* option_body(const std::string& option, const std::string& name, Faults& faults);

}  // namespace lsos
