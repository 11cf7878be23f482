#include "access/open_budget.h"

#include <fmt/format.h>

namespace lsos {

namespace {

// A mosaic of many thousand files is read within this, each with its companions.
constexpr int files_max = 1'000'000;
// VRTs within VRTs are read anew for each that names them.
constexpr int vrts_max = 1000;

struct Opened {
  int files = 0, vrts = 0;
};
thread_local Opened opened;

}  // namespace

void renew_open_budget() { opened = {}; }

bool spend_file() { return ++opened.files <= files_max; }

bool spend_vrt() { return ++opened.vrts <= vrts_max; }

std::string too_many_files() {
  return fmt::format("it makes GDAL open more than {} files at once", files_max);
}

std::string too_many_vrts(const std::string& name) {
  return fmt::format(
      "it opens more than {} VRTs at once, the last being '{}': VRTs that name each other many "
      "times over; gdal_translate makes one raster of them",
      vrts_max, name);
}

}  // namespace lsos
