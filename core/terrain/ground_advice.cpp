// Warnings about a terrain's rasters and detail.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "terrain/grid/grid_edge.h"
#include "terrain/ground_layers.h"

namespace lsos {

Geodetic GroundLayers::first_with_ground(std::size_t k, const Geodetic& edge) const {
  constexpr int steps = 16;
  const HeightGrid& grid = layers[k]->grid();
  const auto from = grid.coordinates(edge);
  if (!from) return edge;
  const auto middle = centre(grid.extent());
  for (int step = 0; step < steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    const auto place =
        grid.place({std::lerp(from->u, middle.u, share), std::lerp(from->v, middle.v, share)});
    if (place && Layer::Probe(*layers[k], LevelOfDetail{}).sample(*place)) return *place;
  }
  return edge;
}

std::string GroundLayers::datum_step_advice(std::size_t k) const {
  constexpr double least_m = 5, scatters = 3;
  constexpr std::size_t least_places = 12;
  const auto* upper = std::get_if<RasterSurface>(&spec.layers[k]);
  const auto* lower = std::get_if<RasterSurface>(&spec.layers[k + 1]);
  // Generated ground below a script's rasters is its author's, but not what a plan lays around.
  const bool is_beyond = spec.beyond && k + 1 == spec.beyond->first_layer;
  if (upper == nullptr || (lower == nullptr && !is_beyond)) return "";
  std::vector<double> steps_m;
  for (const Geodetic& edge : places_along_edge(layers[k]->grid(), -1)) {
    const auto place = first_with_ground(k, edge);
    const auto above = Layer::Probe(*layers[k], LevelOfDetail{}).sample(place);
    const auto below = Layer::Probe(*layers[k + 1], LevelOfDetail{}).sample(place);
    if (above && below) steps_m.push_back(above->height_m - below->height_m);
  }
  if (steps_m.size() < least_places) return "";
  const auto median = [](std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + values.size() / 2);
    return values[values.size() / 2];
  };
  const double step_m = median(steps_m);
  for (double& each_m : steps_m) each_m = std::abs(each_m - step_m);
  const double scatter_m = median(steps_m);
  if (std::abs(step_m) < std::max(least_m, scatters * scatter_m)) return "";
  return fmt::format(
      "raster '{}' lies {:.3g} m {} '{}' along its edge (the median; they scatter by {:.2g} m): "
      "{}? Where one goes over into the other the ground is "
      "a slope that is not there; {}",
      upper->file, std::abs(step_m), step_m < 0 ? "below" : "above",
      lower == nullptr ? spec.beyond->name : lower->file, scatter_m,
      lower == nullptr ? "is it ground of another place" : "are they heights above two references",
      lower == nullptr ? "light and sight beyond the raster are those of that slope"
                       : "bring both to one reference first");
}

std::string GroundLayers::detail_advice() const {
  const std::size_t first = first_with_detail();
  const auto* raster = std::get_if<RasterSurface>(&spec.layers[first]);
  const double cell_m = layers[first]->cell_m();
  if (!spec.detail || raster == nullptr || !(cell_m <= detail_cell_max_m)) return "";
  const auto none = [&](const char* what, double least_m) {
    if (least_m < DetailField::largest_over_raster(cell_m)) return std::string();
    return fmt::format(
        "detail adds no {} to raster '{}': what is as wide as its cells of {:.3g} m stands in "
        "it, "
        "and diameter_min_m is {:.3g}",
        what, raster->file, cell_m, least_m);
  };
  std::string text;
  if (const auto& craters = spec.detail->craters) text = none("craters", craters->diameter_min_m);
  if (const auto& rocks = spec.detail->rocks; rocks && text.empty()) {
    text = none("rocks", rocks->diameter_min_m);
  }
  return text;
}

std::vector<Fault> GroundLayers::advice() const {
  std::vector<Fault> faults;
  for (const auto& layer : layers) {
    for (const std::string& advice : layer->grid().advice()) {
      faults.push_back({Severity::warning, spec.place, advice});
    }
  }
  const auto add = [&](const std::string& advice) {
    if (!advice.empty()) faults.push_back({Severity::warning, spec.place, advice});
  };
  for (std::size_t k = 0; k + 1 < layers.size(); ++k) add(datum_step_advice(k));
  add(detail_advice());
  return faults;
}

}  // namespace lsos
