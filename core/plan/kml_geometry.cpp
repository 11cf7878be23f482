#include "plan/kml_geometry.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace lsos {

using tinyxml2::XMLElement;

namespace {

// The only geometry in a MultiGeometry, which map tools write around any feature that could have
// several parts; nullptr when there are several, or none.
const XMLElement* only_member(const XMLElement& multi) {
  const XMLElement* only = nullptr;
  for (const auto* each = multi.FirstChildElement(); each; each = each->NextSiblingElement()) {
    if (!is_geometry(local_name(*each))) continue;
    if (only != nullptr) return nullptr;
    only = each;
  }
  return only;
}

// The holes of a Polygon. Some tools write all holes into one innerBoundaryIs.
std::vector<SourceGeometry::Ring> holes_of(const XMLElement& polygon) {
  std::vector<SourceGeometry::Ring> holes;
  for (const auto* each = polygon.FirstChildElement(); each; each = each->NextSiblingElement()) {
    if (local_name(*each) != "innerBoundaryIs") continue;
    for (const auto* ring = each->FirstChildElement(); ring; ring = ring->NextSiblingElement()) {
      if (local_name(*ring) != "LinearRing") continue;
      const XMLElement* coordinates = child(*ring, "coordinates");
      LinedText text =
          coordinates == nullptr ? LinedText{"", ring->GetLineNum()} : text_of(*coordinates);
      holes.push_back({std::move(text.text), text.line});
    }
  }
  return holes;
}

// The elements <gx:coord>lon lat alt</gx:coord> of a track as tuples lon,lat,alt.
LinedText coordinates_of_track(const XMLElement& track) {
  LinedText found{{}, track.GetLineNum()};
  for (const auto* each = track.FirstChildElement(); each; each = each->NextSiblingElement()) {
    if (local_name(*each) != "coord") continue;
    const LinedText text = text_of(*each);
    if (found.text.empty()) found.line = text.line;
    std::istringstream numbers(text.text);
    const char* gap = found.text.empty() ? "" : " ";
    for (std::string number; numbers >> number; gap = ",") found.text += gap + number;
  }
  return found;
}

}  // namespace

bool is_geometry(std::string_view name) {
  constexpr std::array<std::string_view, 8> names{"Point",   "LineString",    "LinearRing",
                                                  "Polygon", "MultiGeometry", "Model",
                                                  "Track",   "MultiTrack"};
  return std::ranges::find(names, name) != names.end();
}

bool is_empty_multi(const XMLElement& element) {
  if (local_name(element) != "MultiGeometry") return false;
  for (const auto* each = element.FirstChildElement(); each; each = each->NextSiblingElement()) {
    if (is_geometry(local_name(*each))) return false;
  }
  return true;
}

// The recursion depth is bounded by tinyxml2's limit on nested elements.
SourceGeometry read_kml_geometry(const XMLElement& element) {
  const std::string_view name = local_name(element);
  if (const XMLElement* only = name.starts_with("Multi") ? only_member(element) : nullptr) {
    return read_kml_geometry(*only);
  }
  SourceGeometry found;
  found.line = element.GetLineNum();
  found.kind = name == "LinearRing" || name == "Track" ? "LineString" : std::string(name);
  if (name == "MultiTrack") found.kind = "gx:MultiTrack";
  if (name == "Track") {
    LinedText text = coordinates_of_track(element);
    found.coordinates = std::move(text.text);
    found.line = text.line;
    return found;
  }
  const XMLElement* ring = nullptr;
  if (name == "Polygon") {
    const XMLElement* outline = child(element, "outerBoundaryIs");
    if (outline != nullptr) ring = child(*outline, "LinearRing");
    found.holes = holes_of(element);
  }
  if (found.kind != "Point" && found.kind != "LineString" && ring == nullptr) return found;
  if (const XMLElement* coordinates = child(ring == nullptr ? element : *ring, "coordinates")) {
    LinedText text = text_of(*coordinates);
    found.coordinates = std::move(text.text);
    found.line = text.line;
  }
  return found;
}

}  // namespace lsos
