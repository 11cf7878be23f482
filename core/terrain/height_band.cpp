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
  const std::optional<double>& mark = nodata_ ? nodata_ : declared_;
  const bool is_float = band_->GetRasterDataType() == GDT_Float32;
  if (mark && (sample == *mark || (is_float && sample == double{static_cast<float>(*mark)}))) {
    return true;
  }
  if (nodata_) return false;
  if (sample != -32768 && sample != -32767) return false;
  return band_->GetRasterDataType() == GDT_Int16 || sample * scale_.scale < lowest_ground_m;
}

HeightBand::HeightBand(GDALRasterBand& band, const HeightScale& scale, std::optional<double> nodata)
    : band_(&band), scale_(scale), nodata_(nodata) {
  GDALDataset* dataset = band.GetDataset();
  GDALDriver* driver = dataset != nullptr ? dataset->GetDriver() : nullptr;
  is_isis_ = driver != nullptr && std::string_view(driver->GetDescription()).starts_with("ISIS");
  int is_declared = FALSE;
  const double declared = band.GetNoDataValue(&is_declared);
  if (is_declared != 0) declared_ = declared;
  find_masks();
}

// GDAL has one mask of a band: the file's; else of the nodata value; else an alpha band, and that
// only of whole numbers beside one other band or three.
void HeightBand::find_masks() {
  const int flags = band_->GetMaskFlags();
  const bool is_of_nodata = (flags & GMF_NODATA) != 0;
  has_nodata_mask_ = is_of_nodata && !nodata_;
  if ((flags & GMF_ALL_VALID) == 0 && !is_of_nodata) {
    masks_.push_back(band_->GetMaskBand());
    is_first_mask_gdals_ = true;
  }
  GDALDataset* dataset = band_->GetDataset();
  for (int k = 1; dataset != nullptr && k <= dataset->GetRasterCount(); ++k) {
    GDALRasterBand* other = dataset->GetRasterBand(k);
    const bool is_alpha = other != band_ && other->GetColorInterpretation() == GCI_AlphaBand;
    if (is_alpha && (flags & GMF_ALPHA) == 0) masks_.push_back(other);
  }
}

// GDAL averages without the samples that its one mask leaves out.
bool HeightBand::is_averaged_right() const {
  if (is_first_mask_gdals_) return masks_.size() == 1 && !nodata_ && !declared_;
  if (!masks_.empty()) return false;
  if (declared_) return !nodata_ || *nodata_ == *declared_;
  return band_->GetRasterDataType() != GDT_Int16 && !nodata_;
}

bool HeightBand::is_floating_point() const {
  return GDALDataTypeIsFloating(band_->GetRasterDataType()) != 0;
}

std::pair<GDALRasterBand*, int> HeightBand::overview(int level) const {
  std::pair<GDALRasterBand*, int> found{band_, 0};
  if (!is_averaged_right()) return found;
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
  for (double& sample : samples) {
    if (is_missing(sample)) sample = missing;
  }
  const auto apply = [&, done = done](GDALRasterBand& mask) {
    const auto shown = thinned<double>(mask, window, level - done, GDT_Float64);
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (shown[k] == 0) samples[k] = missing;
    }
  };
  if (has_nodata_mask_) apply(*from->GetMaskBand());
  for (GDALRasterBand* mask : masks_) apply(from == band_ ? *mask : *from->GetMaskBand());
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
