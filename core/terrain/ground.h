// The ground that wheels roll on: a smooth height field (C1) over the curved body, sampled at
// points of the site frame. It equals the finest raster at its cell centres, except for detail and
// where a coarser layer takes over.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/vector.h"
#include "planet/site_frame.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos {

struct GroundSample {
  // Height of the sampled point above the surface, measured along the local vertical; NaN where
  // there is no ground (outside the raster or on nodata).
  double gap_m = not_modelled;
  double elevation_m = not_modelled;  // surface below the point, above the reference surface
  Vec3 normal_S = Vec3::UnitZ();      // unit, outward
  Vec3 up_S = Vec3::UnitZ();          // unit, the local vertical
  int soil = 0;                       // index into Ground::soils()
  bool is_ground() const { return gap_m == gap_m; }
};

class Ground {
 public:
  // Throws InputError: raster cannot be opened, has no CRS, is on another body than the site.
  Ground(const TerrainSpec& spec, const SiteFrame& site, std::uint64_t seed);
  ~Ground();

  const SiteFrame& site() const;

  // Samples the ground and caches the last tiles; results never depend on that. One per thread.
  class Probe {
   public:
    // `resolution_m`: as in elevation_m().
    explicit Probe(const Ground& ground, double resolution_m = 0);
    // The same with detail at the resolution itself: what is below some of it may be missing.
    static Probe with_sparse_detail(const Ground& ground, double resolution_m);
    // The same as with a resolution, but detail smaller than that is kept as long as its nodes show
    // it: for pictures, in which it must not end at an edge.
    static Probe with_fading_detail(const Ground& ground, double resolution_m);
    ~Probe();
    Probe(Probe&&) noexcept;
    Probe& operator=(Probe&&) noexcept;
    GroundSample sample(const Vec3& p_S_m);
    // Upper bound on the elevation that samples have over a convex region with these corners, such
    // that regions of about ten times the resolution need no samples where they are known to lie
    // low. Nullopt where the ground has holes or an end, and over regions much larger.
    std::optional<double> highest_m(std::span<const Vec3> corners_S_m);

   private:
    struct Impl;
    explicit Probe(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
  };

  // Whether the ground ends somewhere; generated ground does not.
  bool has_end() const;
  // Whether probes find ground at a point: within 60 degrees of the site. There may be some beyond.
  bool reaches(const Vec3& p_S_m) const;
  // Elevation of the surface at a place, m; nullopt without ground. Slow; for set-up and logs. A
  // resolution leaves out what is much smaller: each layer is sampled at the coarsest level whose
  // cells are not larger, detail at a sixteenth of it. Maps of large areas would wait for the rest
  // and not show it.
  std::optional<double> elevation_m(const Geodetic& place, double resolution_m = 0) const;
  // Soils of the ground; the terrain's own comes first.
  const std::vector<Soil>& soils() const;
  // SHA-256 of what makes this ground: script values, and metadata and samples of rasters.
  std::string hash() const;
  // Also distinguishes large rasters that hash() may take for the same, by their time of change.
  std::string stamp() const;
  // Rasters that have been written, replaced or removed since they were opened, sorted: what was
  // read of them may be partly old and partly new.
  std::vector<std::string> changed_files() const;
  // Reason why no rover can drive at a place although its heights are known: next to a pole, cells
  // of a raster in longitude and latitude are slivers; "" where they are not.
  std::string slivers(const Geodetic& place) const;
  // Whether the ground at a place is that of the terrain beyond, or missing.
  bool is_beyond(const Geodetic& place) const;
  // Reason why the ground at a place is known too coarsely to drive on, see coarse_text(); "" where
  // it is not, or has detail.
  std::string coarseness(const Geodetic& place) const;
  // Has grounds made from now on in this process, and in those forked from it, share the layers of
  // this one with the tiles that they hold, where theirs are the same. One at a time is shared, for
  // as long as the process lives; results do not depend on it. Returns false for ground with
  // rasters, since processes would share the place in an open file. Call it while no other thread
  // makes ground.
  bool share_layers() const;
  // Whether its layers are those of the ground that is shared.
  bool has_shared_layers() const;
  // Warnings about rasters that make the ground slow, or whose heights may be in another unit.
  std::vector<Fault> advice() const;

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace lsos
