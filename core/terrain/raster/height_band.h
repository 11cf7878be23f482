// A band of heights: its samples, which of them are missing, and what the others mean.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "terrain/raster/raster_blocks.h"

class GDALRasterBand;

namespace lsos {

// height = sample * scale + offset_m
struct HeightScale {
  double scale = 1;
  double offset_m = 0;
};

// Statistics of a band, as far as it was read.
struct SampleRange {
  std::int64_t count = 0;  // samples that are not missing
  double low = 0;          // lowest of those, as it is written
  double high = 0;
  double second_low = 0;       // the lowest above `low`
  std::int64_t zeros = 0;      // samples that are exactly 0
  double nearest_to_zero = 0;  // least magnitude of the others
  std::int64_t distinct = 0;   // distinct values among the first 10,000 samples
  bool is_in_whole_numbers = false;
  // Most samples equal the one read before them.
  bool is_flat_in_steps = false;
  bool is_whole = false;            // every sample was read
  bool has_unmasked_marks = false;  // GDAL would average a missing sample among them
};

class HeightBand {
 public:
  // `nodata`: the sample value that marks missing ones, in place of the file's and customary marks.
  // `seen`: what range() found in the same band.
  HeightBand(GDALRasterBand& band, const HeightScale& scale, std::optional<double> nodata,
             const SampleRange& seen = {});
  const SampleRange& seen() const { return seen_; }

  GDALRasterBand& band() const { return *band_; }
  const HeightScale& scale() const { return scale_; }
  std::optional<double> nodata() const { return nodata_; }
  std::optional<double> declared() const { return declared_; }
  // Bands whose 0 marks a sample of this one as missing: the file's mask and its alpha band.
  const std::vector<GDALRasterBand*>& masks() const { return masks_; }
  bool is_floating_point() const;
  // Whether overviews may be used: none can have averaged what only this class knows to be missing.
  bool can_use_overviews() const;
  // Overviews that may be used, with their levels, up to that level.
  std::vector<std::pair<GDALRasterBand*, int>> overviews(int level) const;

  // Samples as they are written, row by row; NaN where they are missing. On a level above 0 the
  // window counts 2^level columns and rows as one, represented by one sample: of the overview of
  // that size, else the one next to their middle.
  std::vector<double> samples(const RasterBlock& window, int level = 0) const;
  // Heights of those samples; NaN where they are missing or beyond the limit.
  std::vector<double> heights_m(const RasterBlock& window, double limit_m, int level = 0) const;
  // Reads all samples of a small raster and a spread of blocks of a large one.
  SampleRange range() const;

 private:
  void find_masks();
  bool is_missing(double sample) const;
  bool is_declared(double sample) const;
  bool may_hold_16_bit_marks() const;
  bool has_unmasked_marks(const RasterBlock& block) const;
  // Coarsest overview that may be used and is not beyond the level, and its own level.
  std::pair<GDALRasterBand*, int> overview(int level) const;

  GDALRasterBand* band_;
  HeightScale scale_;
  std::optional<double> nodata_;
  std::optional<double> declared_;  // by the file; `nodata_` replaces it
  bool has_nodata_mask_ = false;    // GDAL makes a mask of the file's nodata value
  std::vector<GDALRasterBand*> masks_;
  bool is_first_mask_gdals_ = false;
  bool is_isis_ = false;  // read by GDAL's driver of that format
  SampleRange seen_;
};

}  // namespace lsos
