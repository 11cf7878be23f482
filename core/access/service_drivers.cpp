#include "access/service_drivers.h"

#include <cpl_minixml.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "access/file_access.h"
#include "access/refusal.h"

namespace lsos {

namespace {

// A driver that calls a server, and how it knows what is meant for it, without any call.
struct ServiceDriver {
  const char* name;
  int (*identify)(GDALOpenInfo*) = nullptr;
  GDALDataset* (*open)(GDALOpenInfo*) = nullptr;
};
constexpr std::size_t described = 0;  // WMS
std::array service_drivers{ServiceDriver{"WMS"}, ServiceDriver{"WMTS"}, ServiceDriver{"WCS"},
                           ServiceDriver{"OGCAPI"}, ServiceDriver{"HTTP"}};

bool is_wanted(const ServiceDriver& driver, GDALOpenInfo* info) {
  return driver.identify != nullptr && driver.identify(info) > 0;
}

template <std::size_t index>
GDALDataset* refuse_service(GDALOpenInfo* info) {
  if (!is_wanted(service_drivers[index], info)) return nullptr;
  refuse(has_network_access()
             ? fmt::format("'{}' is a service that describes itself, which may name files of this "
                           "machine; a description of type GDAL_WMS is opened",
                           info->pszFilename)
             : refused_network(info->pszFilename));
  return nullptr;
}

struct DestroyXml {
  void operator()(CPLXMLNode* node) const { CPLDestroyXMLNode(node); }
};
using Xml = std::unique_ptr<CPLXMLNode, DestroyXml>;

// The description that a name stands for, or is; "" when it is too long for one.
std::string description_of(const char* name) {
  constexpr std::size_t bytes_max = std::size_t{1} << 20;
  if (*name == '<') return name;
  const std::unique_ptr<VSILFILE, decltype(&VSIFCloseL)> file(VSIFOpenL(name, "rb"), &VSIFCloseL);
  if (file == nullptr) return "";
  std::string text(bytes_max, '\0');
  text.resize(VSIFReadL(text.data(), 1, text.size(), file.get()));
  return text.size() < bytes_max ? text : "";
}

bool is_web_address(std::string_view address) {
  const std::string text(address.substr(0, 8));
  return STARTS_WITH_CI(text.c_str(), "http://") || STARTS_WITH_CI(text.c_str(), "https://");
}

bool is_element_or_attribute(const CPLXMLNode* node) {
  return node->eType == CXT_Element || node->eType == CXT_Attribute;
}

// All that the driver could take for the value of an element or attribute.
std::string text_of(const CPLXMLNode* node) {
  std::string text;
  for (const CPLXMLNode* child = node->psChild; child != nullptr; child = child->psNext) {
    if (child->eType == CXT_Text) text += child->pszValue;
  }
  return CPLString(text).Trim();
}

// Whether each address in the description is one of the web, and it names no folder: that of a
// cache is written into and cleared. GDAL takes an attribute for an element of that name, in any
// case; they may lie at any depth.
bool has_web_addresses_alone(const CPLXMLNode* node) {
  for (; node != nullptr; node = node->psNext) {
    if (is_element_or_attribute(node)) {
      if (STARTS_WITH_CI(node->pszValue, "Server") && !is_web_address(text_of(node))) return false;
      if (EQUAL(node->pszValue, "Path") || EQUAL(node->pszValue, "CachePath")) return false;
    }
    if (!has_web_addresses_alone(node->psChild)) return false;
  }
  return true;
}

// Kinds that ask the named server for tiles; others ask it where the tiles are.
bool is_tile_service(const char* kind) {
  constexpr std::array kinds{"WMS", "TMS", "TileService", "AGS", "VirtualEarth", "WorldWind"};
  return std::ranges::any_of(kinds, [&](const char* known) { return EQUAL(kind, known); });
}

// A service of that description alone: a name could stand for another one when it is read again.
GDALDataset* open_described(GDALOpenInfo* info) {
  const ServiceDriver& driver = service_drivers[described];
  if (!is_wanted(driver, info)) return nullptr;
  std::string description = description_of(info->pszFilename);
  // What stands before it, such as a declaration of XML, the driver does not take in a text.
  description.erase(0, std::min(description.find("<GDAL_WMS"), description.size()));
  const Xml xml(description.empty() ? nullptr : CPLParseXMLString(description.c_str()));
  const char* kind = xml == nullptr ? "" : CPLGetXMLValue(xml.get(), "=GDAL_WMS.Service.name", "");
  if (!is_tile_service(kind) || !has_web_addresses_alone(xml.get())) {
    refuse(
        fmt::format("'{}' names a service that is not opened: a description of type GDAL_WMS is "
                    "wanted, of a service WMS or TMS, with a ServerUrl that begins with "
                    "http:// or https://, and no Path of a cache",
                    info->pszFilename));
    return nullptr;
  }
  GDALOpenInfo of_description(description.c_str(), info->nOpenFlags);
  return driver.open(&of_description);
}

template <std::size_t index>
void bound_driver() {
  if constexpr (index < service_drivers.size()) {
    ServiceDriver& service = service_drivers[index];
    if (GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(service.name)) {
      service.identify = driver->pfnIdentify;
      service.open = driver->pfnOpen;
      const bool is_file_driver = EQUAL(service.name, "HTTP");  // a file of the web, by its address
      if (!has_network_access()) {
        driver->pfnOpen = refuse_service<index>;
      } else if (index == described) {
        driver->pfnOpen = open_described;
      } else if (!is_file_driver) {
        driver->pfnOpen = refuse_service<index>;
      }
    }
    bound_driver<index + 1>();
  }
}

}  // namespace

bool is_service_driver(const char* name) {
  return std::ranges::any_of(
      service_drivers, [&](const ServiceDriver& service) { return EQUAL(service.name, name); });
}

void bound_service_drivers() { bound_driver<0>(); }

}  // namespace lsos
