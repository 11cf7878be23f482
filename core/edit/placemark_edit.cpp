#include "edit/placemark_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "edit/plan_thing.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

template <std::size_t size>
bool is_one_of(const std::array<std::string_view, size>& names, KmlElement element) {
  return std::ranges::find(names, local_name(element)) != names.end();
}

// Elements that say where a Placemark is.
constexpr std::array<std::string_view, 8> geometries{"Point",   "LineString",    "LinearRing",
                                                     "Polygon", "MultiGeometry", "Model",
                                                     "Track",   "MultiTrack"};
// What a new Placemark has of that which it is made like.
constexpr std::array<std::string_view, 12> kept{
    "name",         "visibility", "open",       "styleUrl",   "Style",   "StyleMap",
    "ExtendedData", "Point",      "LineString", "LinearRing", "Polygon", "MultiGeometry"};

std::vector<KmlElement> geometries_of(const PlanMark& mark) {
  std::vector<KmlElement> found = children(mark.element);
  std::erase_if(found, [](KmlElement each) { return !is_one_of(geometries, each); });
  return found;
}

// The tuple without its altitude.
std::string flat(const std::string& tuple) {
  return tuple.substr(0, std::min(tuple.find(',', tuple.find(',') + 1), tuple.size()));
}

// Those of `wanted`, each as it was written where it is the same place in the same order. A ring
// ends where it begins.
std::vector<std::string> new_tuples(const std::vector<std::string>& old, const std::string& wanted,
                                    bool is_ring) {
  std::vector<std::string> tuples = coordinate_tuples(wanted);
  if (is_ring && tuples.size() > 1 && !is_same_place(tuples.front(), tuples.back())) {
    tuples.push_back(tuples.front());
  }
  for (std::size_t i = 0; i < tuples.size(); ++i) {
    const bool stays = i < old.size() && is_same_place(old[i], tuples[i]);
    tuples[i] = stays ? old[i] : flat(tuples[i]);
  }
  return tuples;
}

// The blanks between the first two tuples.
std::string separator_of(const std::string& coordinates) {
  constexpr const char* blanks = " \t\r\n";
  const std::size_t begin = coordinates.find_first_of(blanks);
  if (begin == std::string::npos) return " ";
  const std::size_t end = coordinates.find_first_not_of(blanks, begin);
  const bool is_between = end != std::string::npos && coordinates[end] != ',' && begin > 0 &&
                          coordinates[begin - 1] != ',';
  return is_between ? coordinates.substr(begin, end - begin) : " ";
}

void set_coordinates(KmlElement element, const std::string& wanted, bool is_ring) {
  const std::string old = text_of(element);
  set_text(element, fmt::format("{}", fmt::join(new_tuples(coordinate_tuples(old), wanted, is_ring),
                                                separator_of(old))));
}

void add_ring(KmlDom& dom, KmlElement polygon, const char* name, const std::string& wanted) {
  const KmlElement ring = dom.add(dom.add(polygon, name, ""), "LinearRing", "");
  set_coordinates(dom.add(ring, "coordinates", ""), wanted, true);
}

void add_geometry(KmlDom& dom, KmlElement placemark, const SourceGeometry& wanted) {
  const KmlElement geometry = dom.add(placemark, wanted.kind.c_str(), "");
  if (wanted.kind == "Polygon") {
    add_ring(dom, geometry, "outerBoundaryIs", wanted.coordinates);
    for (const SourceGeometry::Ring& hole : wanted.holes) {
      add_ring(dom, geometry, "innerBoundaryIs", hole.coordinates);
    }
    return;
  }
  if (wanted.kind == "LineString") dom.add(geometry, "tessellate", "1");
  set_coordinates(dom.add(geometry, "coordinates", ""), wanted.coordinates, false);
}

// The <SchemaData> with the fields of the Placemark; nullptr where they stand in <Data>.
KmlElement schema_data(const PlanMark& mark) {
  if (mark.schema_url.empty()) return nullptr;
  for (const KmlElement part : children(mark.element)) {
    if (local_name(part) != "ExtendedData") continue;
    for (const KmlElement data : children(part)) {
      if (attribute(data, "schemaUrl") == mark.schema_url) return data;
    }
  }
  return nullptr;
}

bool has_field(const std::string& type, const std::string& name, const Declarations& declarations) {
  for (const auto& list : fields_of(type, declarations)) {
    if (std::ranges::find(list, name, &FieldDeclaration::name) != list.end()) return true;
  }
  return false;
}

// The id of the <Schema> of a type, which is declared beside that of another where it is not.
std::string schema_id(PlanDocument& document, const std::string& type,
                      const std::string& other_id) {
  KmlDom& dom = document.dom();
  KmlElement beside = nullptr;
  for (const KmlElement schema : dom.shared("Schema")) {
    const std::string id = attribute(schema, "id"), name = attribute(schema, "name");
    if (name == type || (name.empty() && id == type)) return id.empty() ? name : id;
    if (id == other_id) beside = schema;
  }
  if (beside == nullptr) return type;
  const KmlElement added = dom.copy_behind(beside, beside);
  for (const KmlElement field : children(added)) {
    const std::string name = attribute(field, "name");
    if (name != "Type" && !has_field(type, name, document.declarations())) dom.remove(field);
  }
  set_attribute(added, "id", type);
  set_attribute(added, "name", type);
  return type;
}

}  // namespace

void set_places(PlanDocument& document, const PlanMark& mark, const SourceGeometry& wanted) {
  const std::vector<KmlElement> old = geometries_of(mark);
  const std::vector<KmlElement> texts = coordinates_of(mark.element);
  const bool is_elsewhere = texts.empty() && (!old.empty() || child(mark.element, "Camera"));
  if (is_elsewhere) {
    throw InputError(mark.place,
                     fmt::format("{} {}: its place stands in no <coordinates> (but a Camera or a "
                                 "gx:Track), and is not changed; draw it again as a placemark or "
                                 "path",
                                 mark.type, quoted(document.name(mark))));
  }
  const bool is_same_form = old.size() == 1 && local_name(old.front()) == wanted.kind &&
                            texts.size() == 1 + wanted.holes.size();
  if (is_same_form) {
    set_coordinates(texts.front(), wanted.coordinates, wanted.kind == "Polygon");
    for (std::size_t i = 0; i < wanted.holes.size(); ++i) {
      set_coordinates(texts[i + 1], wanted.holes[i].coordinates, true);
    }
    return;
  }
  for (const KmlElement each : old) document.dom().remove(each);
  if (!wanted.kind.empty()) add_geometry(document.dom(), mark.element, wanted);
}

void move_point(PlanDocument& document, std::size_t index, const std::string& tuple) {
  const std::vector<KmlElement> texts = coordinates_of(document.dom().placemarks().at(index));
  if (texts.size() == 1) set_coordinates(texts.front(), tuple, false);
}

void set_type(PlanDocument& document, PlanMark& mark, const std::string& type) {
  const KmlElement data = schema_data(mark);
  const bool says_type = !document.field(mark, "Type").empty();
  if (says_type || data == nullptr) document.set_field(mark, "Type", type);
  mark.type = type;
  if (data == nullptr) return;
  const std::size_t hash = mark.schema_url.rfind('#');
  const std::string id =
      schema_id(document, type, mark.schema_url.substr(hash == std::string::npos ? 0 : hash + 1));
  mark.schema_url = mark.schema_url.substr(0, hash == std::string::npos ? 0 : hash) + "#" + id;
  set_attribute(data, "schemaUrl", mark.schema_url);
}

void keep_fields(PlanDocument& document, const PlanMark& mark,
                 const std::vector<std::string>& names) {
  const auto stays = [&](KmlElement field) {
    const std::string name = attribute(field, "name");
    return name == "Type" || std::ranges::count(names, name) > 0;
  };
  for (const KmlElement part : children(mark.element)) {
    if (local_name(part) != "ExtendedData") continue;
    for (const KmlElement data : children(part)) {
      const bool is_ours =
          local_name(data) == "SchemaData" &&
          (mark.schema_url.empty() || attribute(data, "schemaUrl") == mark.schema_url);
      if (!is_ours) {
        if (local_name(data) != "Data" || !stays(data)) document.dom().remove(data);
        continue;
      }
      for (const KmlElement field : children(data)) {
        if (!stays(field)) document.dom().remove(field);
      }
    }
  }
}

PlanMark copy_of_kind(PlanDocument& document, const PlanMark& like, KmlElement beside,
                      Beside side) {
  KmlDom& dom = document.dom();
  PlanMark copy = like;
  copy.element = side == Beside::behind ? dom.copy_behind(like.element, beside)
                                        : dom.copy_before(like.element, beside);
  for (const KmlElement each : children(copy.element)) {
    if (!is_one_of(kept, each)) dom.remove(each);
  }
  return copy;
}

}  // namespace lsos
