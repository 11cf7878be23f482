// The ground as wheels feel it: a smooth height field (C1) over the curved body, asked for at
// points of the site frame. Equal to the finest raster at its cell centres, but for detail and
// where a coarser layer takes over.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vector.h"
#include "planet/site_frame.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos {

struct GroundSample {
  // Height of the asked point above the surface, measured along the local vertical; NaN where
  // there is no ground (outside the raster or on nodata).
  double gap_m = not_modelled;
  double elevation_m = not_modelled;  // of the surface below it, above the reference surface
  Vec3 normal_S = Vec3::UnitZ();      // unit, outward
  Vec3 up_S = Vec3::UnitZ();          // unit, the local vertical
  int soil = 0;                       // of Ground::soils()
  bool is_ground() const { return gap_m == gap_m; }
};

class Ground {
 public:
  // Throws InputError: raster cannot be opened, has no CRS, is on another body than the site.
  Ground(const TerrainSpec& spec, const SiteFrame& site, std::uint64_t seed);
  ~Ground();

  const SiteFrame& site() const;

  // Remembers the tile last used. One a thread; results never depend on it.
  class Probe {
   public:
    // `resolution_m`: as in elevation_m().
    explicit Probe(const Ground& ground, double resolution_m = 0);
    // The same with detail at the resolution itself: what is lower than some of it may be missing.
    static Probe rough(const Ground& ground, double resolution_m);
    // The same as with a resolution, but detail smaller than that goes on as far as its nodes show
    // it: for pictures, in which it must not end at an edge.
    static Probe fading(const Ground& ground, double resolution_m);
    ~Probe();
    Probe(Probe&&) noexcept;
    Probe& operator=(Probe&&) noexcept;
    GroundSample sample(const Vec3& p_S_m);

   private:
    struct Impl;
    explicit Probe(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
  };

  // Whether it ends somewhere; generated ground goes on.
  bool has_end() const;
  // Probes look ground up within 60 degrees of the site; beyond, there may well be some.
  bool reaches(const Vec3& p_S_m) const;
  // Of the surface at a place; nullopt where there is no ground. Slow; for set-up and logs.
  // A look with a resolution leaves out what is much smaller: each layer is taken at the coarsest
  // level whose cells are not above that, detail at a sixteenth of it. Maps of large areas would
  // wait for it and not show it.
  std::optional<double> elevation_m(const Geodetic& place, double resolution_m = 0) const;
  // The terrain's own comes first.
  const std::vector<Soil>& soils() const;
  // SHA-256 of what makes this ground: script values and raster bytes' metadata and samples.
  std::string hash() const;
  // Also tells apart large rasters that hash() may take for the same, by when they were changed.
  std::string stamp() const;
  // Why no rover can drive at a place though its heights are known: next to a pole, cells of a
  // raster in longitude and latitude are slivers; "" where they are not.
  std::string slivers(const Geodetic& place) const;
  // The ground there is that of the terrain beyond, or there is none.
  bool is_beyond(const Geodetic& place) const;
  // "" where the ground is known closely enough to drive on: see coarse_text, or with
  // detail upon it.
  std::string coarseness(const Geodetic& place) const;
  // Warnings about rasters that make it slow, or whose heights may be in another unit.
  std::vector<Fault> advice() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lsos
