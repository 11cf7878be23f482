// What the samples of a raster mean: scale, unit, radii or heights; and whether that can be.
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>

#include "base/quantity_advice.h"
#include "terrain/raster/gdal_call.h"
#include "terrain/raster/length_unit.h"
#include "terrain/raster/raster_body.h"
#include "terrain/raster/raster_open.h"

namespace lsos {

namespace {

// Unit of the vertical part of the file's CRS; "" where it has none.
std::string vertical_unit(GDALDataset& dataset) {
  const OGRSpatialReference* crs = dataset.GetSpatialRef();
  if (crs == nullptr || !crs->IsCompound()) return "";
  const char* unit = nullptr;
  crs->GetTargetLinearUnits("COMPD_CS|VERT_CS", &unit);
  return unit != nullptr ? unit : "";
}

// Metres per unit of the band; nullopt where nothing states it.
std::optional<double> band_unit_m(GDALRasterBand& band, const RasterSurface& surface,
                                  const RasterName& name) {
  const std::string allowed = fmt::format(
      "{} are allowed ({})", fmt::join(length_unit_names(), ", "), option_of_raster("unit"));
  if (!surface.unit.empty()) {
    const auto unit = length_unit_m(surface.unit);
    if (!unit) {
      name.refuse(fmt::format("is said to be in '{}', which is no unit of length: {}{}",
                              surface.unit, allowed, unit_advice(surface.unit, "length")));
    }
    return unit;
  }
  const std::string own = band.GetUnitType();
  if (!is_no_unit(own)) {
    const auto unit = length_unit_m(own);
    if (!unit) {
      name.refuse(
          fmt::format("has a band {} in '{}', which is no unit of length: choose another "
                      "band, or say the unit: {}",
                      band.GetBand(), own, allowed));
    }
    return unit;
  }
  return length_unit_m(vertical_unit(*band.GetDataset()));
}

HeightScale scale_of(GDALRasterBand& band, const RasterSurface& surface, const Body& body,
                     const RasterName& name) {
  HeightScale result{band.GetScale(), band.GetOffset()};
  if (!std::isfinite(result.scale) || !std::isfinite(result.offset_m) || result.scale == 0) {
    name.refuse(
        fmt::format("has a scale of {} and an offset of {}; finite numbers and no scale "
                    "of 0 are allowed",
                    result.scale, result.offset_m));
  }
  double to_m = 1;
  if (const auto unit = band_unit_m(band, surface, name)) {
    to_m = *unit;
  } else if (is_radius_of(body, result.offset_m * 1000)) {
    to_m = 1000;  // LOLA's and MOLA's floating-point products: 1737.4 km
  }
  result.scale *= to_m;
  result.offset_m *= to_m;
  return result;
}

// Range of the samples' heights.
struct HeightRange {
  double low_m;
  double high_m;

  HeightRange(const SampleRange& range, const HeightScale& scale)
      : low_m(std::min(range.low * scale.scale, range.high * scale.scale) + scale.offset_m),
        high_m(std::max(range.low * scale.scale, range.high * scale.scale) + scale.offset_m) {}
  bool is_within(double centre_m, double limit_m) const {
    return low_m >= centre_m - limit_m && high_m <= centre_m + limit_m;
  }
};

// Whether samples are radii: said by the user, or shown by an offset or samples of the body's size.
bool are_radii(const RasterSurface& surface, const Body& body, const HeightScale& scale,
               const HeightRange& range) {
  if (surface.is_radius) return *surface.is_radius;
  return is_radius_of(body, scale.offset_m) ||
         range.is_within(body.equatorial_radius_m, ground_limit_m(body));
}

// Heights of a narrow band about 1737 are radii of the Moon in kilometres more often than not.
void refuse_unclear_unit(GDALRasterBand& band, const RasterSurface& surface, const Body& body,
                         const HeightRange& range, const RasterName& name) {
  if (surface.is_radius || band_unit_m(band, surface, name)) return;
  const double radius_km = body.equatorial_radius_m / 1000;
  if (radius_km < 1000 || !range.is_within(radius_km, ground_limit_m(body) / 1000)) return;
  name.refuse(
      fmt::format("holds {} to {} and names no unit: radii of {} in km, or heights in m? "
                  "Say the unit ({})",
                  range.low_m, range.high_m, body.name, option_of_raster("unit")));
}

void refuse_marks(const HeightBand& heights, const SampleRange& range, const RasterName& name) {
  if (heights.nodata()) return;
  // A mark lies far below everything else, so that no valley leads there.
  constexpr double gap = 1000;
  for (const double mark : {-9999.0, -99999.0}) {
    if (range.low != mark || range.second_low < mark + gap || !std::isfinite(range.second_low)) {
      continue;
    }
    name.refuse(
        fmt::format("holds {0} and else nothing below {1}, as if {0} marked missing "
                    "samples, which the file does not say: say nodata = {0}, or another "
                    "value if it is a height ({2})",
                    mark, range.second_low, option_of_raster("nodata")));
  }
}

void refuse_impossible(const SampleRange& range, const HeightRange& heights, const Body& body,
                       const RasterName& name) {
  const double limit_m = ground_limit_m(body);
  if (heights.is_within(0, limit_m)) return;
  name.refuse(fmt::format(
      "holds samples from {} to {}, heights of {} to {} m; no ground of {} is farther than {} m "
      "from its reference surface: say which sample is none ({}), the unit ({}), or whether they "
      "are radii ({})",
      range.low, range.high, heights.low_m, heights.high_m, body.name, limit_m,
      option_of_raster("nodata"), option_of_raster("unit"), option_of_raster("is_radius")));
}

}  // namespace

bool names_unit(GDALRasterBand& band, const RasterSurface& surface) {
  return !surface.unit.empty() || !is_no_unit(band.GetUnitType()) ||
         length_unit_m(vertical_unit(*band.GetDataset())).has_value();
}

HeightBand interpret_band(GDALRasterBand& band, const RasterSurface& surface, const Body& body,
                          const RasterName& name) {
  HeightScale scale = surface.has_classes ? HeightScale{} : scale_of(band, surface, body, name);
  HeightBand heights(band, scale, surface.nodata);
  SampleRange range;
  try {
    range = heights.range();
  } catch (const InputError& error) {
    name.refuse(error.faults().front().what);
  }
  if (range.count == 0 && range.is_whole) {
    name.refuse(fmt::format("holds no {}: all samples are missing",
                            surface.has_classes ? "classes" : "heights"));
  }
  if (range.count == 0 || surface.has_classes) return {band, scale, surface.nodata, range};
  refuse_marks(heights, range, name);
  refuse_unclear_unit(band, surface, body, {range, scale}, name);
  if (are_radii(surface, body, scale, {range, scale})) {
    scale.offset_m -= body.equatorial_radius_m;
  }
  refuse_impossible(range, {range, scale}, body, name);
  return {band, scale, surface.nodata, range};
}

}  // namespace lsos
