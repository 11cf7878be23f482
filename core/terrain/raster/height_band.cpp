#include "terrain/raster/height_band.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>
#include <unordered_set>

#include "base/error.h"
#include "base/rounding.h"
#include "terrain/raster/gdal_call.h"

namespace lsos {

namespace {

// A sample of -32768 or -32767 that would lie lower than this marks a missing one: the lowest
// ground of the Moon is 9.1 km below its sphere (Smith et al. 2017).
constexpr double lowest_ground_m = -9500;

// Marks of missing samples in 16-bit formats (SRTM, DTED, PDS).
constexpr double marks_of_16_bits[] = {-32768, -32767};

bool is_mark_of_16_bits(double sample) {
  return std::ranges::find(marks_of_16_bits, sample) != std::end(marks_of_16_bits);
}

// Samples from here down mark missing ones. An average with one lies below any ground, so that
// heights_m() makes a hole of it too.
constexpr double far_below = -3e38;

void fetch(GDALRasterBand& from, const RasterBlock& at, void* to, GDALDataType type) {
  const GdalSilence silence;
  if (from.RasterIO(GF_Read, at.column, at.row, at.columns, at.rows, to, at.columns, at.rows, type,
                    0, 0, nullptr) != CE_None) {
    throw InputError({from.GetDataset()->GetDescription(), 0},
                     fmt::format("cannot be read: {}", GdalSilence::message()));
  }
}

// A mark is written in 64 bits, a sample perhaps in 32.
bool is_equal(GDALRasterBand& band, double sample, double mark) {
  const bool is_float = band.GetRasterDataType() == GDT_Float32;
  if (std::isnan(mark)) return std::isnan(sample);
  return sample == mark || (is_float && sample == double{static_cast<float>(mark)});
}

// Returns one of each square of 2^level samples. GDAL's own choice would depend on the window.
template <class Sample>
std::vector<Sample> subsampled(GDALRasterBand& from, const RasterBlock& window, int level,
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

// Tests the marks of missing samples that files declare and those that they often do not: -3.4e38
// (also ISIS's special values, all of them below -3.4e38), and -32768 and -32767. As 16-bit samples
// the latter are always marks; as wider ones only where they would be impossible heights.
bool HeightBand::is_missing(double sample) const {
  if (!std::isfinite(sample) || sample <= far_below) return true;
  // ISIS has five special values in 16 bits, of which GDAL declares one.
  if (is_isis_ && band_->GetRasterDataType() == GDT_Int16 && sample <= -32764) return true;
  if (nodata_ ? is_equal(*band_, sample, *nodata_) : is_declared(sample)) return true;
  if (nodata_ || !is_mark_of_16_bits(sample)) return false;
  return band_->GetRasterDataType() == GDT_Int16 || sample * scale_.scale < lowest_ground_m;
}

bool HeightBand::is_declared(double sample) const {
  return declared_ && is_equal(*band_, sample, *declared_);
}

HeightBand::HeightBand(GDALRasterBand& band, const HeightScale& scale, std::optional<double> nodata,
                       const SampleRange& seen)
    : band_(&band), scale_(scale), nodata_(nodata), seen_(seen) {
  GDALDataset* dataset = band.GetDataset();
  GDALDriver* driver = dataset != nullptr ? dataset->GetDriver() : nullptr;
  is_isis_ = driver != nullptr && std::string_view(driver->GetDescription()).starts_with("ISIS");
  int is_declared = FALSE;
  const double declared = band.GetNoDataValue(&is_declared);
  if (is_declared != 0) declared_ = declared;
  find_masks();
}

// GDAL has one mask for a band: the file's; else that of the nodata value; else an alpha band, and
// that only of whole numbers beside one other band or three.
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

// GDAL averages without the samples of its one mask: the file's, else that of the declared value.
bool HeightBand::can_use_overviews() const {
  const std::size_t left_out = is_first_mask_gdals_ ? 1 : 0;
  if (masks_.size() > left_out || seen_.has_unmasked_marks) return false;
  if (nodata_ && declared_ && *nodata_ != *declared_) return false;
  if (seen_.is_whole) return true;
  if (is_isis_ && band_->GetRasterDataType() == GDT_Int16) return false;
  if (is_first_mask_gdals_ && (nodata_ || declared_)) return false;
  if (nodata_) return declared_.has_value();
  // A file that declares one of the two marks missing samples with that one.
  if (declared_ && is_mark_of_16_bits(*declared_)) return true;
  return !may_hold_16_bit_marks();
}

bool HeightBand::may_hold_16_bit_marks() const {
  const GDALDataType type = band_->GetRasterDataType();
  if (GDALDataTypeIsSigned(type) == 0 || GDALGetDataTypeSizeBytes(type) < 2) return false;
  return std::ranges::any_of(marks_of_16_bits, [this](double mark) { return is_missing(mark); });
}

bool HeightBand::has_unmasked_marks(const RasterBlock& block) const {
  const auto samples = subsampled<double>(*band_, block, 0, GDT_Float64);
  std::vector<double> shown;
  if (is_first_mask_gdals_) shown = subsampled<double>(*masks_.front(), block, 0, GDT_Float64);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!is_missing(samples[k])) continue;
    if (is_first_mask_gdals_ ? shown[k] != 0 : !is_declared(samples[k])) return true;
  }
  return false;
}

bool HeightBand::is_floating_point() const {
  return GDALDataTypeIsFloating(band_->GetRasterDataType()) != 0;
}

std::vector<std::pair<GDALRasterBand*, int>> HeightBand::overviews(int level) const {
  std::vector<std::pair<GDALRasterBand*, int>> found;
  if (!can_use_overviews()) return found;
  const auto coarser = [](int size, int by) { return ((size - 1) >> by) + 1; };
  for (int k = 0; k < band_->GetOverviewCount(); ++k) {
    GDALRasterBand* band = band_->GetOverview(k);
    if (band == nullptr) continue;
    for (int of = found.empty() ? 1 : found.back().second + 1; of <= level; ++of) {
      const bool is_of_level = band->GetXSize() == coarser(band_->GetXSize(), of) &&
                               band->GetYSize() == coarser(band_->GetYSize(), of);
      if (!is_of_level) continue;
      found.emplace_back(band, of);
      break;
    }
  }
  return found;
}

std::pair<GDALRasterBand*, int> HeightBand::overview(int level) const {
  const auto found = overviews(level);
  return found.empty() ? std::pair{band_, 0} : found.back();
}

std::vector<double> HeightBand::samples(const RasterBlock& window, int level) const {
  const auto [from, done] = overview(level);
  std::vector<double> samples = subsampled<double>(*from, window, level - done, GDT_Float64);
  for (double& sample : samples) {
    if (is_missing(sample)) sample = missing;
  }
  const auto apply = [&, done = done](GDALRasterBand& mask) {
    const auto shown = subsampled<double>(mask, window, level - done, GDT_Float64);
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
  // Bounds the time to that of reading a megabyte; heights_m() detects what the spread of blocks
  // does not show.
  constexpr std::int64_t most_cells = std::int64_t{1} << 20;
  SampleRange range;
  range.low = range.second_low = std::numeric_limits<double>::infinity();
  range.high = -range.low;
  range.nearest_to_zero = range.low;
  constexpr std::int64_t compared = 10'000;
  std::unordered_set<double> distinct;
  std::int64_t seen = 0, repeated = 0;
  bool has_fractions = false;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (const RasterBlock& block : spread_blocks(*band_, most_cells).blocks) {
    seen += std::int64_t{block.columns} * block.rows;
    range.has_unmasked_marks = range.has_unmasked_marks || has_unmasked_marks(block);
    for (const double sample : samples(block)) {
      if (std::isnan(sample)) continue;
      ++range.count;
      if (range.count <= compared) distinct.insert(sample);
      has_fractions = has_fractions || sample != std::floor(sample);
      repeated += sample == before;
      before = sample;
      range.high = std::max(range.high, sample);
      range.zeros += sample == 0;
      if (sample != 0) range.nearest_to_zero = std::min(range.nearest_to_zero, std::abs(sample));
      if (sample < range.low) {
        range.second_low = range.low;
        range.low = sample;
      } else if (sample > range.low) {
        range.second_low = std::min(range.second_low, sample);
      }
    }
  }
  range.is_in_whole_numbers = range.count > 0 && !has_fractions;
  range.is_flat_in_steps = 2 * repeated > range.count;
  range.distinct = static_cast<std::int64_t>(distinct.size());
  range.is_whole = seen == std::int64_t{band_->GetXSize()} * band_->GetYSize();
  return range;
}

}  // namespace lsos
