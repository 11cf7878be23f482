// The layers that ground is made of, from fine to coarse.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "terrain/grid/cell_sides.h"
#include "terrain/layer.h"
#include "terrain/soil_map.h"

namespace lsos {

// Larger cells get no detail: what lies in them does not concern wheels.
inline constexpr double detail_cell_max_m = 1000;

struct GroundLayers {
  // Throws InputError as Ground() does.
  GroundLayers(const TerrainSpec& terrain, const SiteFrame& site, std::uint64_t seed_of_plan);

  std::size_t first_with_detail() const;
  // Refuses a terrain beyond that has no ground along the edge of this terrain's coarsest layer.
  void check_beyond();
  CellSides middle_sides(const HeightGrid& grid) const;
  LayerPlace place_of(std::size_t layer) const;
  // Layer that most of the ground at the place is made of; nullopt without ground.
  std::optional<std::size_t> main_layer(const Geodetic& place) const;

  // Warnings about rasters and detail, as Ground has them.
  std::vector<Fault> advice() const;
  // First place with ground on the line from an edge to the middle of a layer, whose corners may be
  // empty; the edge where there is none.
  Geodetic first_with_ground(std::size_t k, const Geodetic& edge) const;
  // Warns of a raster that lies above or below the layer around it by more than their heights
  // scatter, as with heights of two datums: the blend would be a slope that is not there.
  std::string datum_step_advice(std::size_t k) const;
  // Warns of craters or rocks all larger than may be added to the finest raster that gets detail.
  std::string detail_advice() const;
  // Adds the script values, and metadata and samples of rasters, that make the layers at their
  // site.
  void add_layers_to(Sha256& hash) const;
  // Digest of all that the layers are a function of: with equal ones, layers are the same but for
  // the tiles that they hold.
  std::string layers_key() const;
  bool has_rasters() const;

  TerrainSpec spec;
  std::uint64_t seed;
  SitePlane plane;
  SoilMap soils;
  std::vector<std::shared_ptr<Layer>> layers;  // may be those of other ground
};

}  // namespace lsos
