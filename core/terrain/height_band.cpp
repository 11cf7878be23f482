#include "terrain/height_band.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <cmath>
#include <limits>
#include <string_view>

#include "base/error.h"
#include "terrain/gdal_call.h"

namespace lsos {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// The lowest ground of the Moon is 9.1 km below its sphere (Smith et al. 2017); nothing lower is
// ever written as -32767 or -32768 by chance.
constexpr double lowest_ground_m = -9500;

void fetch(GDALRasterBand& from, const RasterBlock& at, int level, void* to, GDALDataType type) {
  const GdalSilence silence;
  if (from.RasterIO(GF_Read, at.column << level, at.row << level, at.columns << level,
                    at.rows << level, to, at.columns, at.rows, type, 0, 0, nullptr) != CE_None) {
    throw InputError({from.GetDataset()->GetDescription(), 0},
                     fmt::format("cannot be read: {}", GdalSilence::message()));
  }
}

}  // namespace

// Marks of missing samples that files often do not declare: -3.4e38 (also ISIS's special values,
// all of them below -3.4e38), and -32768 and -32767 of 16-bit formats (SRTM, DTED, PDS). As
// 16-bit samples these are always marks; as wider ones only where they would be impossible heights.
bool HeightBand::is_missing(double sample) const {
  if (!std::isfinite(sample) || sample <= -3e38) return true;
  // Of ISIS's five special values in 16 bits GDAL declares one.
  if (is_isis_ && band_->GetRasterDataType() == GDT_Int16 && sample <= -32764) return true;
  if (nodata_) {
    return sample == *nodata_ || (band_->GetRasterDataType() == GDT_Float32 &&
                                  sample == static_cast<double>(static_cast<float>(*nodata_)));
  }
  if (sample != -32768 && sample != -32767) return false;
  return band_->GetRasterDataType() == GDT_Int16 || sample * scale_.scale < lowest_ground_m;
}

HeightBand::HeightBand(GDALRasterBand& band, const HeightScale& scale, std::optional<double> nodata)
    : band_(&band), scale_(scale), nodata_(nodata) {
  GDALDataset* dataset = band.GetDataset();
  GDALDriver* driver = dataset != nullptr ? dataset->GetDriver() : nullptr;
  is_isis_ = driver != nullptr && std::string_view(driver->GetDescription()).starts_with("ISIS");
}

bool HeightBand::is_floating_point() const {
  return GDALDataTypeIsFloating(band_->GetRasterDataType()) != 0;
}

std::vector<double> HeightBand::samples(const RasterBlock& window, int level) const {
  std::vector<double> samples(static_cast<std::size_t>(window.columns) * window.rows);
  fetch(*band_, window, level, samples.data(), GDT_Float64);
  const int flags = band_->GetMaskFlags();
  const bool is_mask_wanted =
      (flags & GMF_ALL_VALID) == 0 && ((flags & GMF_NODATA) == 0 || !nodata_);
  std::vector<GByte> mask;
  if (is_mask_wanted) {
    mask.resize(samples.size());
    fetch(*band_->GetMaskBand(), window, level, mask.data(), GDT_Byte);
  }
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if ((is_mask_wanted && mask[k] == 0) || is_missing(samples[k])) samples[k] = missing;
  }
  return samples;
}

std::vector<double> HeightBand::heights_m(const RasterBlock& window, double limit_m,
                                          int level) const {
  std::vector<double> heights_m = samples(window, level);
  for (double& value : heights_m) {
    value = value * scale_.scale + scale_.offset_m;
    if (std::abs(value) > limit_m) value = missing;
  }
  return heights_m;
}

SampleRange HeightBand::range() const {
  // As long as one reading of a megabyte takes; what a spread of blocks does not show is seen by
  // heights_m().
  constexpr std::int64_t most_cells = std::int64_t{1} << 20;
  SampleRange range;
  range.low = range.second_low = std::numeric_limits<double>::infinity();
  range.high = -range.low;
  std::int64_t seen = 0;
  for (const RasterBlock& block : spread_blocks(*band_, most_cells).blocks) {
    seen += std::int64_t{block.columns} * block.rows;
    for (const double sample : samples(block)) {
      if (std::isnan(sample)) continue;
      ++range.count;
      range.high = std::max(range.high, sample);
      if (sample < range.low) {
        range.second_low = range.low;
        range.low = sample;
      } else if (sample > range.low) {
        range.second_low = std::min(range.second_low, sample);
      }
    }
  }
  range.is_whole = seen == std::int64_t{band_->GetXSize()} * band_->GetYSize();
  return range;
}

}  // namespace lsos
