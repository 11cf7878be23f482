#include "terrain/raster/raster_open.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <regex>
#include <set>

#include "access/file_access.h"
#include "access/gdal_access.h"
#include "terrain/raster/gdal_call.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;

// Widest raster, so that whole numbers of columns and rows can be added.
constexpr int cells_across_max = 1'000'000'000;

void prepare_gdal() {
  register_drivers();
  static std::once_flag once;
  std::call_once(once, bound_block_cache);
}

// "; did you mean its label 'LDEM_4.LBL'?" for the samples of a product whose label lies beside.
std::string suggest_opening(const std::string& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return "";
  const fs::path path(file);
  for (const char* extension : {".lbl", ".LBL", ".xml", ".XML", ".hdr", ".HDR"}) {
    fs::path label = path;
    label.replace_extension(extension);
    if (label != path && fs::is_regular_file(label, ignored)) {
      return fmt::format("; did you mean its label '{}'?", label.string());
    }
  }
  for (const char* extension : {".nc", ".grd", ".h5", ".gpkg"}) {
    if (path.extension() == extension)
      return "; gdal_translate makes a GeoTIFF of it, which is read";
  }
  if (path.extension() == ".zip") {
    return fmt::format("; of an archive name the file inside: '/vsizip/{}/FILE'", file);
  }
  return "";
}

std::vector<std::string> subdatasets(GDALDataset& dataset) {
  std::vector<std::string> names;
  char** metadata = dataset.GetMetadata("SUBDATASETS");
  for (int number = 1;; ++number) {
    const std::string key = fmt::format("SUBDATASET_{}_NAME", number);
    const char* name = CSLFetchNameValue(metadata, key.c_str());
    if (name == nullptr) return names;
    names.emplace_back(name);
  }
}

// "1 'height', 2 'slope', 3"
std::string listed_bands(GDALDataset& dataset) {
  constexpr int shown_max = 12;
  std::string list;
  for (int number = 1; number <= dataset.GetRasterCount(); ++number) {
    if (number > shown_max) return list + ", ...";
    const std::string description = dataset.GetRasterBand(number)->GetDescription();
    list += fmt::format("{}{}", number == 1 ? "" : ", ", number);
    if (!description.empty()) list += fmt::format(" '{}'", description);
  }
  return list;
}

int number_of(GDALDataset& dataset, const std::string& description, const RasterName& name) {
  int found = 0;
  std::vector<std::string> known;
  for (int number = 1; number <= dataset.GetRasterCount(); ++number) {
    known.emplace_back(dataset.GetRasterBand(number)->GetDescription());
    if (known.back() != description) continue;
    if (found != 0) {
      name.refuse(fmt::format("describes bands {} and {} as '{}': give the number ({})", found,
                              number, description, option_of_raster("band")));
    }
    found = number;
  }
  if (found == 0) {
    name.refuse(fmt::format("has no band '{}': there is {}{}", description, listed_bands(dataset),
                            did_you_mean(description, known)));
  }
  return found;
}

bool is_colour(GDALColorInterp meaning) {
  static const std::set colours{GCI_PaletteIndex, GCI_RedBand, GCI_GreenBand, GCI_BlueBand,
                                GCI_AlphaBand};
  return colours.contains(meaning);
}

// Whether PROJ would read a file by its path, as of "+nadgrids=/FILE" or a WKT's PARAMETERFILE.
bool names_file(const std::string& crs) {
  static const std::regex by_path(R"re((grids=|PARAMETERFILE\["[^"]*",")[^" ]*[/\\])re",
                                  std::regex::icase);
  return std::regex_search(crs, by_path);
}

}  // namespace

std::unique_ptr<GDALDataset> open_raster(const RasterSurface& surface, const RasterName& name) {
  prepare_gdal();
  const GdalSilence silence;
  std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(
      surface.file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR));
  const std::string on_disk = file_on_disk(surface.file);
  if (dataset == nullptr && last_refusal().empty() && !is_allowed(on_disk)) {
    name.refuse(fmt::format("cannot be opened: {}", refused_file(on_disk)));
  }
  if (dataset == nullptr) {
    name.refuse(fmt::format("cannot be opened: {}{}", GdalSilence::message(),
                            suggest_opening(surface.file)));
  }
  if (const auto inside = subdatasets(*dataset); dataset->GetRasterCount() == 0 && !inside.empty())
    name.refuse(fmt::format("holds {} rasters; name one of them: '{}'", inside.size(),
                            fmt::join(inside, "', '")));
  if (dataset->GetRasterCount() == 0) name.refuse("holds no raster");
  if (dataset->GetRasterXSize() < 2 || dataset->GetRasterYSize() < 2) {
    name.refuse(fmt::format("has {} x {} cells; at least 2 x 2 are needed",
                            dataset->GetRasterXSize(), dataset->GetRasterYSize()));
  }
  if (std::max(dataset->GetRasterXSize(), dataset->GetRasterYSize()) > cells_across_max) {
    name.refuse(fmt::format("has {} x {} cells; {} x {} are the most", dataset->GetRasterXSize(),
                            dataset->GetRasterYSize(), cells_across_max, cells_across_max));
  }
  return dataset;
}

GDALRasterBand& chosen_band(GDALDataset& dataset, const RasterSurface& surface,
                            const RasterName& name) {
  const auto* description = std::get_if<std::string>(&surface.band);
  const int number =
      description != nullptr ? number_of(dataset, *description, name) : std::get<int>(surface.band);
  const int bands = dataset.GetRasterCount();
  if (number < 1 || number > bands) {
    name.refuse(
        fmt::format("has no band {}: 1..{} is allowed ({})", number, bands, listed_bands(dataset)));
  }
  GDALRasterBand& band = *dataset.GetRasterBand(number);
  if (GDALDataTypeIsComplex(band.GetRasterDataType())) {
    name.refuse("holds complex numbers; real ones are wanted");
  }
  if (!surface.has_classes && is_colour(band.GetColorInterpretation())) {
    name.refuse(fmt::format("is a picture: band {} holds its colours ({}), heights are wanted",
                            number, GDALGetColorInterpretationName(band.GetColorInterpretation())));
  }
  return band;
}

OGRSpatialReference crs_of(GDALDataset& dataset, const RasterSurface& surface,
                           const RasterName& name) {
  const GdalSilence silence;
  OGRSpatialReference crs;
  const std::string option = option_of_raster("crs");
  const auto refuse_file = [&] {
    name.refuse(
        fmt::format("has a coordinate reference system that reads a file of its own (a grid by its "
                    "path); grids by name, from PROJ's folders, are allowed ({})",
                    option));
  };
  if (is_access_restricted() && names_file(surface.crs)) refuse_file();
  if (!surface.crs.empty()) {
    // A text such as a URL or a path would be fetched.
    const CSLConstList limits = is_access_restricted() && !has_network_access()
                                    ? OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()
                                    : nullptr;
    if (crs.SetFromUserInput(surface.crs.c_str(), limits) != OGRERR_NONE) {
      if (limits != nullptr && surface.crs.find("://") != std::string::npos) {
        name.refuse("is said to be in a CRS that lies elsewhere: " + refused_network(surface.crs));
      }
      name.refuse(
          fmt::format("is said to be in the CRS '{}', which GDAL does not know: an "
                      "authority's code (IAU_2015:30135, EPSG:32610), WKT or a PROJ "
                      "string is allowed ({})",
                      surface.crs, option));
    }
  } else if (const OGRSpatialReference* found = dataset.GetSpatialRef(); found != nullptr) {
    crs = *found;
  }
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.IsEmpty()) {
    name.refuse(
        fmt::format("has no coordinate reference system; one is needed to know where it "
                    "lies: say it ({})",
                    option));
  }
  if (is_access_restricted() && names_file(wkt_of(crs))) refuse_file();
  if (crs.IsCompound()) crs.StripVertical();
  if (crs.IsLocal() || (!crs.IsProjected() && !crs.IsGeographic())) {
    name.refuse(
        fmt::format("has a coordinate reference system that is tied to no body; a "
                    "projected or geographic one is allowed ({})",
                    option));
  }
  return crs;
}

std::array<double, 6> geotransform_of(GDALDataset& dataset, const RasterName& name) {
  const GdalSilence silence;
  std::array<double, 6> geotransform{};
  std::array<double, 6> inverse{};
  if (dataset.GetGeoTransform(geotransform.data()) != CE_None ||
      !GDALInvGeoTransform(geotransform.data(), inverse.data())) {
    const bool has_other = dataset.GetGCPCount() > 0 || dataset.GetMetadata("RPC") != nullptr;
    name.refuse(fmt::format("has no geotransform; one is needed to know where it lies{}",
                            has_other ? ": rectify it first with gdalwarp" : ""));
  }
  return geotransform;
}

}  // namespace lsos
