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

void fetch(GDALRasterBand& from, const RasterBlock& at, void* to, GDALDataType type) {
  const GdalSilence silence;
  if (from.RasterIO(GF_Read, at.column, at.row, at.columns, at.rows, to, at.columns, at.rows, type,
                    0, 0, nullptr) != CE_None) {
    throw InputError({from.GetDataset()->GetDescription(), 0},
                     fmt::format("cannot be read: {}", GdalSilence::message()));
  }
}

// One of each square of 2^level samples. GDAL's own choice would depend on the window.
template <class Sample>
std::vector<Sample> thinned(GDALRasterBand& from, const RasterBlock& window, int level,
                            GDALDataType type) {
  std::vector<Sample> samples(static_cast<std::size_t>(window.columns) * window.rows);
  if (level == 0) {
    fetch(from, window, samples.data(), type);
    return samples;
  }
  const int half = 1 << (level - 1);
  std::vector<Sample> row(static_cast<std::size_t>(window.columns) << level);
  for (int j = 0; j < window.rows; ++j) {
    const int number = ((window.row + j) << level) + half;
    fetch(from, {window.column << level, number, window.columns << level, 1}, row.data(), type);
    for (int i = 0; i < window.columns; ++i) {
      samples[static_cast<std::size_t>(j) * window.columns + i] =
          row[(static_cast<std::size_t>(i) << level) + half];
    }
  }
  return samples;
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

std::pair<GDALRasterBand*, int> HeightBand::overview(int level) const {
  int is_declared = FALSE;
  const double declared = band_->GetNoDataValue(&is_declared);
  const bool is_masked = (band_->GetMaskFlags() & GMF_ALL_VALID) == 0;
  const bool may_hold_marks = band_->GetRasterDataType() == GDT_Int16 || nodata_;
  const bool is_averaged_right =
      is_declared != 0 ? !nodata_ || *nodata_ == declared : is_masked || !may_hold_marks;
  std::pair<GDALRasterBand*, int> found{band_, 0};
  if (!is_averaged_right) return found;
  const auto coarser = [](int size, int by) { return ((size - 1) >> by) + 1; };
  for (int k = 0; k < band_->GetOverviewCount(); ++k) {
    GDALRasterBand* band = band_->GetOverview(k);
    if (band == nullptr) continue;
    for (int of = found.second + 1; of <= level; ++of) {
      const bool is_of_level = band->GetXSize() == coarser(band_->GetXSize(), of) &&
                               band->GetYSize() == coarser(band_->GetYSize(), of);
      if (is_of_level) found = {band, of};
    }
  }
  return found;
}

std::vector<double> HeightBand::samples(const RasterBlock& window, int level) const {
  const auto [from, done] = overview(level);
  std::vector<double> samples = thinned<double>(*from, window, level - done, GDT_Float64);
  const int flags = band_->GetMaskFlags();
  const bool is_mask_wanted =
      (flags & GMF_ALL_VALID) == 0 && ((flags & GMF_NODATA) == 0 || !nodata_);
  std::vector<GByte> mask;
  if (is_mask_wanted) mask = thinned<GByte>(*from->GetMaskBand(), window, level - done, GDT_Byte);
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
