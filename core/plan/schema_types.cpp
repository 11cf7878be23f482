#include "plan/schema_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "plan/suggestions.h"

namespace lsos {

namespace {

bool is_number_type(std::string_view type) {
  constexpr std::array<std::string_view, 8> types{"int",   "uint",   "short", "ushort",
                                                  "float", "double", "bool",  "integer"};
  return std::ranges::find(types, type) != types.end();
}

bool is_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

using FieldTypes = std::map<std::pair<std::string, std::string>, const SourceSchema::Field*>;

// The fields that one file types as numbers, by the schema's id and the field's name.
FieldTypes number_fields(const KmlSource& source, const std::string& file) {
  FieldTypes found;
  for (const SourceSchema& schema : source.schemas) {
    if (schema.file != file) continue;
    for (const SourceSchema::Field& field : schema.fields) {
      if (is_number_type(field.type)) found.emplace(std::pair{schema.id, field.name}, &field);
    }
  }
  return found;
}

std::string warning(const SourceField& field, const SourceSchema::Field& type) {
  if (field.text.empty()) {
    return fmt::format(
        "{} is empty, and the Schema types it as {} (line {}): map tools read that "
        "as 0; leave it out",
        field.name, type.type, type.line);
  }
  return fmt::format(
      "{} = {}: the Schema types it as {} (line {}), and map tools then lose what "
      "is no number; type it as string",
      field.name, shown(field.text), type.type, type.line);
}

}  // namespace

void check_schema_types(const KmlSource& source, const Classified& classified, Faults& faults) {
  std::map<std::string, FieldTypes> by_file;
  for (const SourceSchema& schema : source.schemas) {
    if (!by_file.contains(schema.file)) by_file[schema.file] = number_fields(source, schema.file);
  }
  std::set<const SourceSchema::Field*> reported;
  const auto check = [&](const PlanPlacemark& ours) {
    const std::string& file = ours.placemark->file.empty() ? source.file : ours.placemark->file;
    const auto types = by_file.find(file);
    if (types == by_file.end()) return;
    const std::size_t hash = ours.data.schema_url.rfind('#');
    if (hash == std::string::npos) return;
    for (const SourceField& field : ours.data.fields) {
      const auto type = types->second.find({ours.data.schema_url.substr(hash + 1), field.name});
      if (type == types->second.end() || is_number(field.text)) continue;
      if (!reported.insert(type->second).second) continue;
      faults.warning({file, field.line}, warning(field, *type->second));
    }
  };
  for (const auto* list :
       {&classified.missions, &classified.rovers, &classified.assets, &classified.events}) {
    std::ranges::for_each(*list, check);
  }
}

}  // namespace lsos
