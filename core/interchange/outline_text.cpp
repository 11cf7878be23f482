// Writes a plan as an outline.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "interchange/outline.h"
#include "interchange/outline_item.h"
#include "interchange/places.h"

namespace lsos {

namespace {

const std::string* find(const SourceData& data, const std::string& name) {
  const auto found = std::ranges::find(data.fields, name, &SourceField::name);
  return found == data.fields.end() ? nullptr : &found->text;
}

// Quotes where a text would be read otherwise without them.
std::string value_text(const std::string& text) {
  const bool is_plain = text.find_first_of(",;\"()\n:#") == std::string::npos;
  return is_plain ? text : in_quotes(text);
}

std::string field_list(const SourcePlacemark& placemark, const std::vector<std::string>& left_out) {
  std::string text;
  const auto add = [&](const std::string& name, const std::string& value) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, value_text(value));
  };
  if (!placemark.name.empty()) add("as", placemark.name);
  for (const SourceField& field : placemark.data.front().fields) {
    if (std::ranges::find(left_out, field.name) == left_out.end()) add(field.name, field.text);
  }
  if (!placemark.description.empty()) add("note", placemark.description);
  return text;
}

std::string place_of(const SourcePlacemark& placemark) {
  if (placemark.geometries.empty()) return "";
  return " at " + wkt_of(placemark.geometries.front());
}

}  // namespace

std::string outline_of(const KmlSource& plan) {
  std::string head;
  std::map<std::string, std::string> events;  // by rover
  for (const SourcePlacemark& placemark : plan.placemarks) {
    const SourceData& data = placemark.data.front();
    if (data.schema == "MissionInfo") {
      head += fmt::format("Mission: {}\n", field_list(placemark, {}));
    } else if (data.schema == "Rover" || data.schema == "Asset") {
      const std::string id_field = data.schema + "Id", type_field = data.schema + "Type";
      const std::string *id = find(data, id_field), *type = find(data, type_field);
      const std::string fields = field_list(placemark, {id_field, type_field});
      head += fmt::format("{} {}: {}{}{}{}\n", data.schema, id == nullptr ? "" : value_text(*id),
                          type == nullptr ? "" : *type, place_of(placemark),
                          fields.empty() ? "" : ", ", fields);
    } else {
      const std::string* id = find(data, "RoverId");
      const std::string fields = field_list(placemark, {"RoverId"});
      events[id == nullptr ? "" : *id] += fmt::format(
          "  {}{}{}{}\n", data.schema, place_of(placemark), fields.empty() ? "" : ", ", fields);
    }
  }
  std::string text = head;
  for (const auto& [id, items] : events) text += fmt::format("\n{}:\n{}", in_quotes(id), items);
  return text;
}

}  // namespace lsos
