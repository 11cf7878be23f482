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

// What a band holds, as far as was looked.
struct SampleRange {
  std::int64_t count = 0;  // samples that are not missing
  double low = 0;          // of those, as they are written
  double high = 0;
  double second_low = 0;       // the lowest above `low`
  std::int64_t zeros = 0;      // samples that are exactly 0
  double nearest_to_zero = 0;  // least size of the others
  std::int64_t different = 0;  // heights, of the first 10,000 samples
  bool is_in_whole_numbers = false;
  // Most samples are the same as the one before them in their row.
  bool is_flat_in_steps = false;
  bool is_whole = false;         // every sample was looked at
  bool has_loose_marks = false;  // a missing sample among them that GDAL would average
};

class HeightBand {
 public:
  // `nodata`: the sample that stands for none, in place of what the file and custom say. `seen`:
  // what range() found in the same band.
  HeightBand(GDALRasterBand& band, const HeightScale& scale, std::optional<double> nodata,
             const SampleRange& seen = {});
  const SampleRange& seen() const { return seen_; }

  GDALRasterBand& band() const { return *band_; }
  const HeightScale& scale() const { return scale_; }
  std::optional<double> nodata() const { return nodata_; }
  std::optional<double> declared() const { return declared_; }
  // Bands of which a 0 says that a sample of this one is missing: the file's mask and its alpha
  // band.
  const std::vector<GDALRasterBand*>& masks() const { return masks_; }
  bool is_floating_point() const;
  // Overviews may be used: none can have averaged what only we know to be missing.
  bool is_averaged_right() const;
  // Those that may be used, with their levels, up to that level.
  std::vector<std::pair<GDALRasterBand*, int>> overviews(int level) const;

  // Samples as they are written, row by row; NaN where they are missing. On a level above 0 the
  // window counts 2^level columns and rows as one, for which one sample stands: of the overview
  // with as many, else the one next to their middle.
  std::vector<double> samples(const RasterBlock& window, int level = 0) const;
  // Their heights. Heights beyond the limit are missing too.
  std::vector<double> heights_m(const RasterBlock& window, double limit_m, int level = 0) const;
  // Looks at all samples of a small raster and at a spread of blocks of a large one.
  SampleRange range() const;

 private:
  void find_masks();
  bool is_missing(double sample) const;
  bool is_declared(double sample) const;
  bool may_hold_16_bit_marks() const;
  bool has_loose_marks(const RasterBlock& block) const;
  // The coarsest overview that may be used and is not beyond the level, and its own level.
  std::pair<GDALRasterBand*, int> overview(int level) const;

  GDALRasterBand* band_;
  HeightScale scale_;
  std::optional<double> nodata_;
  std::optional<double> declared_;  // by the file, in place of which `nodata_` counts
  bool has_nodata_mask_ = false;    // which GDAL makes of the file's
  std::vector<GDALRasterBand*> masks_;
  bool is_first_mask_gdals_ = false;
  bool is_isis_ = false;  // read by GDAL's driver of that format
  SampleRange seen_;
};

}  // namespace lsos
