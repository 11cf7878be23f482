#include "edit/plan_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/quantity.h"
#include "plan/classify.h"
#include "plan/kml_text.h"

namespace lsos {

namespace {

// Where the elements with a field's text are, in <SimpleData> and <Data>.
void add_fields(KmlElement extended, const PlanMark& mark, const std::string& name,
                std::vector<KmlElement>& found) {
  for (const KmlElement data : children(extended)) {
    if (local_name(data) == "SchemaData") {
      if (!mark.schema_url.empty() && attribute(data, "schemaUrl") != mark.schema_url) continue;
      for (const KmlElement field : children(data)) {
        if (local_name(field) == "SimpleData" && attribute(field, "name") == name) {
          found.push_back(field);
        }
      }
    } else if (local_name(data) == "Data" && attribute(data, "name") == name) {
      if (const KmlElement value = child(data, "value")) found.push_back(value);
    }
  }
}

std::string text_in(const SourceData& data, const std::string& name) {
  const auto field = std::ranges::find(data.fields, name, &SourceField::name);
  return field == data.fields.end() ? "" : field->text;
}

}  // namespace

PlanDocument::PlanDocument(const std::string& kml, const Plan& plan,
                           const Declarations& declarations)
    : plan_(plan), declarations_(declarations), dom_(kml_text(kml, plan.file).utf8, plan.file) {
  const KmlSource source = parse_kml(kml, plan.file);
  Faults known;  // the plan has no errors, and its warnings were told
  const Classified classified = classify(source, declarations, known);
  const std::vector<KmlElement> placemarks = dom_.placemarks();
  LSOS_ASSERT(placemarks.size() == source.placemarks.size());
  const auto mark = [&](const PlanPlacemark& ours) {
    const auto index = static_cast<std::size_t>(ours.placemark - source.placemarks.data());
    return PlanMark{placemarks[index],
                    ours.data.schema,
                    ours.data.schema_url,
                    {plan.file, ours.placemark->line}};
  };
  for (const PlanPlacemark& ours : classified.missions) mission_ = mark(ours);
  for (const PlanPlacemark& ours : classified.rovers) {
    rovers_[text_in(ours.data, "RoverId")] = mark(ours);
  }
  for (const PlanPlacemark& ours : classified.assets) {
    assets_[text_in(ours.data, "AssetId")] = mark(ours);
  }
  for (const PlanPlacemark& ours : classified.events) {
    const Parsed<std::int64_t> sequence = parse_integer(text_in(ours.data, "Sequence"));
    LSOS_ASSERT(sequence);
    events_[{text_in(ours.data, "RoverId"), *sequence.value}] = mark(ours);
  }
  LSOS_ASSERT(events_.size() == plan.events.size());
}

std::vector<KmlElement> PlanDocument::fields(const PlanMark& mark, const std::string& name) const {
  std::vector<KmlElement> found;
  for (const KmlElement part : children(mark.element)) {
    if (local_name(part) == "ExtendedData") add_fields(part, mark, name, found);
  }
  return found;
}

std::string PlanDocument::field(const PlanMark& mark, const std::string& name) const {
  for (const KmlElement field : fields(mark, name)) {
    if (std::string text = text_of(field); !text.empty()) return text;
  }
  return "";
}

void PlanDocument::set_field(const PlanMark& mark, const std::string& name,
                             const std::string& text) {
  const std::vector<KmlElement> known = fields(mark, name);
  if (!known.empty()) {
    // Map tools write a field twice; the two must stay equal.
    for (const KmlElement field : known) {
      if (field == known.front() || !text_of(field).empty()) set_text(field, text);
    }
    return;
  }
  const KmlElement extended = child(mark.element, "ExtendedData");
  LSOS_ASSERT(extended != nullptr);
  for (const KmlElement data : children(extended)) {
    if (mark.schema_url.empty() || attribute(data, "schemaUrl") != mark.schema_url) continue;
    set_attribute(dom_.add(data, "SimpleData", text), "name", name);
    declare(mark, name);
    return;
  }
  const KmlElement data = dom_.add(extended, "Data", "");
  set_attribute(data, "name", name);
  dom_.add(data, "value", text);
}

void PlanDocument::declare(const PlanMark& mark, const std::string& name) {
  // Viewers leave out fields that the Schema of a Placemark has not.
  const std::string id = mark.schema_url.substr(mark.schema_url.rfind('#') + 1);
  for (const KmlElement schema : dom_.shared("Schema")) {
    if (attribute(schema, "id") != id) continue;
    const std::vector<KmlElement> declared = children(schema);
    if (std::ranges::any_of(declared,
                            [&](KmlElement each) { return attribute(each, "name") == name; })) {
      continue;
    }
    const KmlElement added = dom_.add(schema, "SimpleField", "");
    set_attribute(added, "type", "string");
    set_attribute(added, "name", name);
  }
}

void PlanDocument::erase_field(const PlanMark& mark, const std::string& name) {
  for (const KmlElement field : fields(mark, name)) {
    dom_.remove(local_name(field) == "value" ? parent_of(field) : field);
  }
}

void PlanDocument::follow_rasters(const std::string& file) {
  namespace fs = std::filesystem;
  const auto folder = [](const std::string& of) {
    return fs::weakly_canonical(fs::absolute(of).parent_path());
  };
  const fs::path here = folder(plan_.file), there = folder(file);
  if (here == there) return;
  const auto follow = [&](const char* name, const TerrainName& terrain) {
    if (!terrain.is_raster || !fs::path(terrain.as_written).is_relative()) return;
    set_field(mission_, name, (here / terrain.as_written).lexically_relative(there).string());
  };
  // Rasters of a case lie beside the plan that it is a case of.
  if (const std::string& home = plan_.mission.case_of; !home.empty()) {
    if (fs::path(home).is_relative()) {
      set_field(mission_, "CaseOf", (here / home).lexically_relative(there).string());
    }
    return;
  }
  follow("Terrain", plan_.mission.terrain);
  follow("TerrainBeyond", plan_.mission.terrain_beyond);
}

std::string PlanDocument::name(const PlanMark& mark) const {
  const KmlElement element = child(mark.element, "name");
  return element == nullptr ? "" : text_of(element);
}

void PlanDocument::set_name(const PlanMark& mark, const std::string& text) {
  const KmlElement element = child(mark.element, "name");
  if (element != nullptr) {
    set_text(element, text);
  } else {
    dom_.add_first(mark.element, "name", text);
  }
}

}  // namespace lsos
