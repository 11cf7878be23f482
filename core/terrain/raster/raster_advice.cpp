#include "terrain/raster/raster_advice.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "terrain/grid/cell_sides.h"
#include "terrain/raster/gdal_call.h"
#include "terrain/raster/raster_body.h"
#include "terrain/raster/raster_name.h"
#include "terrain/raster/raster_open.h"

namespace lsos {

namespace {

// At four bytes each, 400 MB are read for a map of the whole raster.
constexpr double most_cells_without_overviews = 1e8;

// The smoothest plains of Moon and Mars rise and fall by more than this share of their width, and
// none of 150 km and more by less than 30 m.
constexpr double smoothest_share = 2e-4, smoothest_m = 30;
// A smaller raster made by hand may well be as level. There heights in km are those much farther
// from 0 than from each other, or with many distinct values, as measured ones have.
constexpr double wide_m = 20e3, narrowest_m = 500, far_times = 3;
constexpr std::int64_t many_distinct = 200;

constexpr std::string_view unmasked_marks =
    "-32768 or -32767, which mark missing samples, with heights";

// Advice that makes usable overviews of those that may have averaged marks.
std::string overview_remedy(const HeightBand& heights, const std::string& file) {
  if (!heights.masks().empty() || heights.nodata()) return "";
  if (const auto declared = heights.declared()) {
    return fmt::format("; if {0} alone marks missing samples, say nodata = {0} ({1})", *declared,
                       option_of_raster("nodata"));
  }
  return fmt::format("; declare first what marks them: gdal_edit.py -a_nodata -32768 {}", file);
}

// Words of a name, in lower case: "height", "slope" of "Height_Slope-2".
std::set<std::string> words_of(const std::string& name) {
  std::set<std::string> words;
  std::string word;
  for (const char c : name + "_") {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!word.empty()) {
      words.insert(std::exchange(word, ""));
    }
  }
  return words;
}

// Whether heights may be in km: ground reaches as far, and they are not whole numbers, of which so
// little rise would leave one or two.
bool may_be_km(const HeightBand& heights, double farthest, const Body& body) {
  constexpr double m_per_km = 1000;
  if (farthest * m_per_km > ground_limit_m(body)) return false;
  return heights.is_floating_point() || heights.scale().scale != 1;
}

}  // namespace

std::string overview_advice(const HeightBand& heights, const std::string& file) {
  const GdalSilence silence;
  GDALRasterBand& band = heights.band();
  const double cells = static_cast<double>(band.GetXSize()) * band.GetYSize();
  if (cells <= most_cells_without_overviews) return {};
  const bool is_right = heights.can_use_overviews();
  if (band.GetOverviewCount() > 0) {
    if (is_right) return {};
    return fmt::format(
        "raster '{}' has {} x {} cells, and a look from afar reads all of it: its overviews are "
        "not used, for they may have averaged {}{}",
        file, band.GetXSize(), band.GetYSize(), unmasked_marks, overview_remedy(heights, file));
  }
  return fmt::format(
      "raster '{}' has {} x {} cells and no overviews, so that a look from afar reads all of it; "
      "make them once with: gdaladdo -r average {} 2 4 8 16{}",
      file, band.GetXSize(), band.GetYSize(), file, is_right ? "" : overview_remedy(heights, file));
}

std::string unit_advice(const Raster& raster, const RasterSurface& surface, const HeightGrid& grid,
                        const Body& body) {
  HeightBand const& heights = raster.band();
  if (names_unit(heights.band(), surface)) return {};
  const CellSides sides = cell_sides(grid, body, centre(grid.extent()));
  const double across_m =
      std::max(raster.columns() * sides.along_row_m, raster.rows() * sides.along_column_m);
  const SampleRange& range = heights.seen();
  if (!(across_m >= narrowest_m) || range.count == 0) return {};
  const auto height = [&](double sample) {
    return sample * heights.scale().scale + heights.scale().offset_m;
  };
  const auto [low, high] = std::minmax({height(range.low), height(range.high)});
  const double rise = high - low;
  if (rise <= 0) return {};
  if (rise >= std::min(smoothest_m, smoothest_share * across_m)) return {};
  const bool is_far = std::min(std::abs(low), std::abs(high)) > far_times * rise && low * high > 0;
  const bool is_measured = range.distinct >= many_distinct;
  if (across_m < wide_m && !is_far && !is_measured) return {};
  if (!may_be_km(heights, std::max(std::abs(low), std::abs(high)), body)) return {};
  return fmt::format(
      "raster '{}' holds heights of {:.6g} to {:.6g} over {:.3g} km and names no unit: are they "
      "km? "
      "They are taken as metres; say the unit ({})",
      surface.file, low, high, across_m / 1000, option_of_raster("unit"));
}

std::string extreme_advice(const Raster& raster, const RasterSurface& surface, const Body& body) {
  if (!surface.unit.empty()) return {};
  const HeightBand& heights = raster.band();
  const SampleRange& range = heights.seen();
  if (range.count == 0) return {};
  const auto height_m = [&](double sample) {
    return sample * heights.scale().scale + heights.scale().offset_m;
  };
  const auto [low_m, high_m] = std::minmax({height_m(range.low), height_m(range.high)});
  // Rims and reference spheres differ a little from map to map.
  constexpr double room_m = 1000;
  if (low_m >= body.lowest_ground_m - room_m && high_m <= body.highest_ground_m + room_m) return {};
  return fmt::format(
      "raster '{}' holds heights of {:.0f} to {:.0f} m, where {} has {:.0f} to {:.0f} m: has its "
      "scale been lost, or are they above another reference? Say the unit ({}), or set the scale "
      "with "
      "gdal_edit.py -scale",
      surface.file, low_m, high_m, body.name, body.lowest_ground_m, body.highest_ground_m,
      option_of_raster("unit"));
}

std::string quantisation_advice(const Raster& raster, const RasterSurface& surface,
                                const HeightGrid& grid, const Body& body) {
  // A step of that share of a cell is a slope of 6 degrees, which is not there.
  constexpr double steepest_step = 0.1;
  constexpr std::int64_t made_by_hand = 12;  // distinct heights of such a raster, at most
  const HeightBand& heights = raster.band();
  const SampleRange& range = heights.seen();
  if (range.distinct <= made_by_hand || !range.is_in_whole_numbers) return {};
  if (!picture_advice(raster, surface).empty()) return {};
  const CellSides sides = cell_sides(grid, body, centre(grid.extent()));
  const double cell_m = std::min(sides.along_row_m, sides.along_column_m);
  const double step_m = std::abs(heights.scale().scale);
  if (!(step_m > steepest_step * cell_m)) return {};
  if (!range.is_flat_in_steps) return {};
  return fmt::format(
      "raster '{}' holds heights in steps of {:.3g} m on cells of {:.3g} m: ground between two "
      "steps is level, and each step a wall of {:.3g} m; was it saved as whole numbers?",
      surface.file, step_m, cell_m, step_m);
}

std::string picture_advice(const Raster& raster, const RasterSurface& surface) {
  const HeightBand& heights = raster.band();
  const bool is_scaled = heights.scale().scale != 1 || heights.scale().offset_m != 0;
  if (heights.band().GetRasterDataType() != GDT_Byte || is_scaled) return {};
  if (names_unit(heights.band(), surface)) return {};
  return fmt::format(
      "raster '{}' has samples of 8 bits, 0 to 255, and names no unit: is it a hillshade, a map of "
      "slopes or a picture? They are taken as heights in metres; say the unit if they are ({})",
      surface.file, option_of_raster("unit"));
}

std::string zero_advice(const Raster& raster, const RasterSurface& surface) {
  // Ground does not jump so far from one sample to the next.
  constexpr double leap_m = 50;
  const HeightBand& heights = raster.band();
  const SampleRange& range = heights.seen();
  if (range.zeros == 0 || range.zeros == range.count || heights.nodata() == 0) return {};
  if (heights.scale().offset_m != 0) return {};
  if (range.low == 0 && range.second_low == range.high) return {};  // made by hand: two heights
  if (!(range.nearest_to_zero * heights.scale().scale > leap_m)) return {};
  const double percent = 100 * static_cast<double>(range.zeros) / static_cast<double>(range.count);
  return fmt::format(
      "raster '{}': {} % of its samples are exactly 0, and all others at least {:.0f} from it: "
      "does 0 mark missing samples? They are taken as heights; say the mark ({})",
      surface.file, percent < 1 ? fmt::format("{:.2g}", percent) : fmt::format("{:.0f}", percent),
      range.nearest_to_zero, option_of_raster("nodata"));
}

std::string name_advice(const Raster& raster, const RasterSurface& surface) {
  static const std::set<std::string> others{
      "slope",       "slopes", "aspect", "hillshade", "albedo",  "abundance",    "roughness",
      "temperature", "error",  "errors", "quality",   "azimuth", "illumination", "count"};
  static const std::set<std::string> heights{"height", "heights", "elevation", "dem",
                                             "dtm",    "dsm",     "topo",      "topography"};
  if (names_unit(raster.band().band(), surface)) return {};
  const std::string band = raster.band().band().GetDescription();
  // A user who has chosen a band knows the file, but not always what the band holds.
  const std::string file =
      surface.is_band_given ? "" : std::filesystem::path(surface.file).stem().string();
  for (const std::string& name : {band, file}) {
    const std::set<std::string> words = words_of(name);
    const auto is_one_of = [&](const std::set<std::string>& known) {
      return std::ranges::any_of(words, [&](const auto& word) { return known.contains(word); });
    };
    if (is_one_of(heights)) return {};
    if (!is_one_of(others)) continue;
    return fmt::format(
        "raster '{}': {} is called '{}', and its samples are taken as heights in metres: is it a "
        "map of something else? Say the band or the unit if it is not ({}, {})",
        surface.file, name == band ? fmt::format("band {}", raster.band().band().GetBand()) : "it",
        name, option_of_raster("band"), option_of_raster("unit"));
  }
  return {};
}

std::string band_advice(const Raster& raster, const RasterSurface& surface) {
  GDALRasterBand& band = raster.band().band();
  GDALDataset* dataset = band.GetDataset();
  if (surface.is_band_given || dataset == nullptr || *band.GetDescription() != '\0') return {};
  int others = 0;
  for (int k = 1; k <= dataset->GetRasterCount(); ++k) {
    const bool is_mask = dataset->GetRasterBand(k)->GetColorInterpretation() == GCI_AlphaBand;
    others += k != band.GetBand() && !is_mask;
  }
  if (others == 0) return {};
  return fmt::format(
      "raster '{}' has {} more band{}, and nothing says which are heights: band {} is "
      "taken; say the band ({})",
      surface.file, others, others == 1 ? "" : "s", band.GetBand(), option_of_raster("band"));
}

std::string sliver_text(const RasterSurface& surface, const HeightGrid& grid, const Body& body,
                        const Geodetic& place) {
  const auto at = grid.coordinates(place);
  if (!at) return {};
  const CellSides sides = cell_sides(grid, body, *at);
  const double width_m = std::min(sides.along_row_m, sides.along_column_m);
  const double length_m = std::max(sides.along_row_m, sides.along_column_m);
  if (!std::isfinite(length_m) || length_m <= sliver_aspect * width_m) return {};
  return fmt::format(
      "the cells of raster '{}' are slivers there, {:.3g} m wide and {:.0f} m long; cells of at "
      "most {} times their width make ground to drive on, as in longitude and latitude up to 87 "
      "degrees: a polar map is wanted, as gdalwarp -t_srs {} makes",
      surface.file, width_m, length_m, sliver_aspect,
      place.lat_rad > 0 ? body.north_polar_crs : body.south_polar_crs);
}

std::string coarse_text(const RasterSurface& surface, double cell_m) {
  if (!(cell_m > drivable_cell_max_m)) return {};
  return fmt::format(
      "the ground is known there by cells of {} alone (raster '{}'): slopes, craters and rocks "
      "smaller than that are not in it, and drives seem easier than they are; a finer raster, or "
      "lsos.detail in a terrain script, has them",
      cell_m < 1000 ? fmt::format("{:.0f} m", cell_m) : fmt::format("{:.1f} km", cell_m / 1000),
      surface.file);
}

}  // namespace lsos
