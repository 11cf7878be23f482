#include "access/gdal_access.h"

#include <cpl_conv.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>

#include <mutex>
#include <vector>

#include "access/bounded_files.h"
#include "access/bounded_projections.h"
#include "access/file_access.h"
#include "access/open_budget.h"
#include "access/refusal.h"
#include "access/service_drivers.h"
#include "base/console.h"

namespace lsos {

namespace {

// Drivers that read files through GDAL's file systems, and those of what this program writes.
constexpr const char* file_drivers =
    "VRT;GTiff;COG;MEM;NITF;HFA;AIG;AAIGrid;DTED;PNG;JPEG;GIF;BMP;WEBP;PNM;JP2OpenJPEG;"
    "ISIS2;ISIS3;PDS;PDS4;VICAR;SRTMHGT;USGSDEM;GRASSASCIIGrid;ERS;ENVI;EHdr;GenBin;ISCE;"
    "ROI_PAC;RST;RRASTER;RMF;BT;GTX;LCP;Leveller;Terragen;GSAG;GSBG;GS7BG;SAGA;XYZ;HF2;"
    "ZMap;BYN;SIGDEM;NWT_GRD;ILWIS;PCIDSK;NGSGEOID;GRIB;GPKG;CSV;XLSX;ODS;GeoJSON;"
    "ESRI Shapefile;GPX;Memory";

GDALDataset* (*open_geopackage)(GDALOpenInfo*) = nullptr;

// SQLite opens its files past GDAL's file systems, and others that a VRT's options attach. Plans
// and logs, which the program itself names, are vectors.
GDALDataset* open_vectors_alone(GDALOpenInfo* info) {
  if ((info->nOpenFlags & GDAL_OF_VECTOR) != 0) return open_geopackage(info);
  if (STARTS_WITH_CI(info->pszFilename, "GPKG:") ||
      EQUAL(CPLGetExtension(info->pszFilename), "gpkg")) {
    refuse(
        fmt::format("rasters in a GeoPackage are not read ('{}'); gdal_translate makes a GeoTIFF "
                    "of one",
                    info->pszFilename));
  }
  return nullptr;
}

GDALDataset* (*open_vrt)(GDALOpenInfo*) = nullptr;
int (*is_vrt)(GDALOpenInfo*) = nullptr;

// Whether an open file, which may lie deflated in an archive, has more bytes than that. It is read
// so far, as an archive may be wrong about its size.
bool has_more_bytes(VSILFILE* file, std::size_t bytes_max) {
  std::vector<char> block(std::size_t{1} << 20);
  std::size_t bytes = 0;
  while (bytes <= bytes_max) {
    const std::size_t count = VSIFReadL(block.data(), 1, block.size(), file);
    bytes += count;
    if (count < block.size()) break;
  }
  VSIFSeekL(file, 0, SEEK_SET);
  return bytes > bytes_max;
}

// The driver reads a VRT whole, whatever the file is called.
GDALDataset* open_vrt_in_budget(GDALOpenInfo* info) {
  constexpr std::size_t vrt_bytes_max = std::size_t{64} << 20;
  if (is_vrt(info) <= 0) return nullptr;
  if (info->fpL != nullptr) {
    VSIFSeekL(info->fpL, 0, SEEK_SET);
    if (has_more_bytes(info->fpL, vrt_bytes_max)) {
      refuse(fmt::format("the VRT '{}' is larger than {} MiB; gdal_translate makes a GeoTIFF of it",
                         info->pszFilename, vrt_bytes_max >> 20));
      return nullptr;
    }
  }
  if (spend_vrt()) return open_vrt(info);
  refuse(too_many_vrts(info->pszFilename));
  return nullptr;
}

void bound_other_ways() {
  GDALDriverManager& manager = *GetGDALDriverManager();
  if (GDALDriver* driver = manager.GetDriverByName("VRT")) {
    open_vrt = driver->pfnOpen;
    is_vrt = driver->pfnIdentify;
    driver->pfnOpen = open_vrt_in_budget;
  }
  if (GDALDriver* driver = manager.GetDriverByName("GPKG")) {
    open_geopackage = driver->pfnOpen;
    driver->pfnOpen = open_vectors_alone;
  }
  // Its names may hold an address in memory.
  if (GDALDriver* driver = manager.GetDriverByName("MEM")) driver->pfnOpen = nullptr;
}

// Answers what GDAL would fetch by itself, such as a CRS that is a URL.
CPLHTTPResult* refuse_fetch(const char* url, CSLConstList, GDALProgressFunc, void*,
                            CPLHTTPFetchWriteFunc, void*, void*) {
  refuse(refused_network(url));
  auto* result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  result->nStatus = -1;
  result->pszErrBuf = CPLStrdup(refused_network(url).c_str());
  return result;
}

// What GDAL says outside of a QuietErrors of ours, about files of the plan too.
void CPL_STDCALL tell_error(CPLErr severity, CPLErrorNum, const char* text) {
  if (severity != CE_None) print_message("GDAL: {}\n", text);
}

void leave_out_other_drivers() {
  const CPLStringList kept(CSLTokenizeString2(file_drivers, ";", 0));
  GDALDriverManager& manager = *GetGDALDriverManager();
  std::vector<GDALDriver*> others;
  for (int i = 0; i < manager.GetDriverCount(); ++i) {
    GDALDriver* driver = manager.GetDriver(i);
    const char* name = driver->GetDescription();
    if (kept.FindString(name) < 0 && !is_service_driver(name)) others.push_back(driver);
  }
  for (GDALDriver* driver : others) {
    manager.DeregisterDriver(driver);
    delete driver;
  }
}

}  // namespace

void register_drivers() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (is_access_restricted()) {
      bound_projections();
      CPLSetErrorHandler(tell_error);
    }
    GDALAllRegister();
    if (!is_access_restricted()) return;
    // A VRT may hold Python.
    CPLSetConfigOption("GDAL_VRT_ENABLE_PYTHON", "NO");
    leave_out_other_drivers();
    if (!has_network_access()) {
      OSRSetPROJEnableNetwork(FALSE);
      CPLHTTPSetFetchCallback(refuse_fetch, nullptr);
    }
    bound_service_drivers();
    // libcurl would send the user's names and passwords from ~/.netrc; who wants that, says so.
    if (CPLGetConfigOption("GDAL_HTTP_NETRC", nullptr) == nullptr) {
      CPLSetConfigOption("GDAL_HTTP_NETRC", "NO");
    }
    bound_other_ways();
    // GDAL's own tables.
    if (const char* table = CPLFindFile("gdal", "gdalvrt.xsd")) allow_folder(CPLGetPath(table));
    bound_file_systems();
  });
}

}  // namespace lsos
