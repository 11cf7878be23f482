#include "access/gdal_access.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <string_view>
#include <vector>

#include "access/bounded_files.h"
#include "access/file_access.h"
#include "access/refusal.h"

namespace lsos {

namespace {

// Drivers that read files through GDAL's file systems, and those of what this program writes.
constexpr const char* file_drivers =
    "VRT;GTiff;COG;MEM;NITF;HFA;AIG;AAIGrid;DTED;PNG;JPEG;GIF;BMP;WEBP;PNM;JP2OpenJPEG;"
    "ISIS2;ISIS3;PDS;PDS4;VICAR;SRTMHGT;USGSDEM;GRASSASCIIGrid;ERS;ENVI;EHdr;GenBin;ISCE;"
    "ROI_PAC;RST;RRASTER;RMF;BT;GTX;LCP;Leveller;Terragen;GSAG;GSBG;GS7BG;SAGA;XYZ;HF2;"
    "ZMap;BYN;SIGDEM;NWT_GRD;ILWIS;PCIDSK;NGSGEOID;GRIB;netCDF;GPKG;CSV;XLSX;ODS;GeoJSON;"
    "ESRI Shapefile;GPX;Memory";

// Names such as GPKG:"FILE":TABLE are opened by a driver's own library, past GDAL's file systems.
std::string file_within(std::string_view name) {
  name.remove_prefix(name.find(':') + 1);
  if (name.starts_with('"')) {
    name.remove_prefix(1);
    return std::string(name.substr(0, name.find('"')));
  }
  return std::string(name.substr(0, name.find(':')));
}

// A driver that opens such names, and how it does it unbounded.
struct PrefixDriver {
  const char* name;
  GDALDataset* (*open)(GDALOpenInfo*) = nullptr;
};
std::array prefix_drivers{PrefixDriver{"GPKG"}, PrefixDriver{"netCDF"}};

template <std::size_t index>
GDALDataset* open_within_bounds(GDALOpenInfo* info) {
  const PrefixDriver& driver = prefix_drivers[index];
  const std::string prefix = std::string(driver.name) + ":";
  if (STARTS_WITH_CI(info->pszFilename, prefix.c_str())) {
    const std::string file = file_within(info->pszFilename);
    if (file.find("://") != std::string::npos) {
      refuse(refused_network(file));
      return nullptr;
    }
    if (!is_allowed(file)) {
      refuse(refused_file(file));
      return nullptr;
    }
  }
  return driver.open(info);
}

template <std::size_t index>
void bound_prefix_driver() {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(prefix_drivers[index].name);
  if (driver == nullptr) return;
  prefix_drivers[index].open = driver->pfnOpen;
  driver->pfnOpen = open_within_bounds<index>;
}

// A driver that calls a server, and how it knows what is meant for it, without any call.
struct ServiceDriver {
  const char* name;
  int (*identify)(GDALOpenInfo*) = nullptr;
};
std::array service_drivers{ServiceDriver{"WMS"}, ServiceDriver{"WMTS"}, ServiceDriver{"WCS"},
                           ServiceDriver{"OGCAPI"}, ServiceDriver{"HTTP"}};

template <std::size_t index>
GDALDataset* refuse_service(GDALOpenInfo* info) {
  const auto identify = service_drivers[index].identify;
  if (identify != nullptr && identify(info) > 0) refuse(refused_network(info->pszFilename));
  return nullptr;
}

template <std::size_t index>
void refuse_services() {
  if constexpr (index < service_drivers.size()) {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(service_drivers[index].name);
    if (driver != nullptr) {
      service_drivers[index].identify = driver->pfnIdentify;
      driver->pfnOpen = refuse_service<index>;
    }
    refuse_services<index + 1>();
  }
}

bool is_service(const char* driver) {
  return std::ranges::any_of(
      service_drivers, [&](const ServiceDriver& service) { return EQUAL(service.name, driver); });
}

void leave_out_other_drivers() {
  const CPLStringList kept(CSLTokenizeString2(file_drivers, ";", 0));
  GDALDriverManager& manager = *GetGDALDriverManager();
  std::vector<GDALDriver*> others;
  for (int i = 0; i < manager.GetDriverCount(); ++i) {
    GDALDriver* driver = manager.GetDriver(i);
    const char* name = driver->GetDescription();
    if (kept.FindString(name) < 0 && !is_service(name)) others.push_back(driver);
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
    GDALAllRegister();
    if (!is_access_restricted()) return;
    // A VRT may hold Python.
    CPLSetConfigOption("GDAL_VRT_ENABLE_PYTHON", "NO");
    leave_out_other_drivers();
    if (!has_network_access()) {
      OSRSetPROJEnableNetwork(FALSE);
      refuse_services<0>();
    }
    bound_prefix_driver<0>();
    bound_prefix_driver<1>();
    bound_file_systems();
  });
}

}  // namespace lsos
