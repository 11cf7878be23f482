#include "edit/row_changes.h"

#include <algorithm>

#include "base/error.h"

namespace lsos {

namespace {

// The column of what a thing is, which is none of its fields.
constexpr const char* type_field = "Type";

std::string type_of(const SourcePlacemark& thing) { return thing.data.front().schema; }

void put(SourcePlacemark& thing, const SourceField& field) {
  auto& fields = thing.data.front().fields;
  const auto found = std::ranges::find(fields, field.name, &SourceField::name);
  if (found == fields.end()) {
    fields.push_back(field);
  } else {
    found->text = field.text;
  }
}

// The names of the fields of both, each once, as they stand.
std::vector<std::string> fields_of_both(const SourcePlacemark& a, const SourcePlacemark& b) {
  std::vector<std::string> names;
  for (const SourcePlacemark* thing : {&a, &b}) {
    for (const SourceField& field : thing->data.front().fields) {
      if (std::ranges::count(names, field.name) == 0) names.push_back(field.name);
    }
  }
  return names;
}

RowChange change_of(const ThingKey& key, const SourcePlacemark& thing, const SourcePlacemark& row,
                    const SheetColumns& columns, const Declarations& declarations) {
  RowChange change{key, thing, row};
  const std::string type = type_of(row);
  change.has_new_type = type != type_of(thing);
  for (const std::string& name : fields_of_both(thing, row)) {
    if (name == type_field) continue;
    const std::string before = field_of(thing, name), after = field_of(row, name);
    // Fields of another type than before are not taken along.
    const bool is_kept = after.empty() && !columns.names.contains(name) && !change.has_new_type;
    if (is_kept || means_same(type, name, before, after, declarations)) {
      if (!before.empty()) put(change.after, {name, before});
    } else {
      change.fields.push_back(name);
    }
  }
  const bool says_name = columns.names.contains("name") || !row.name.empty();
  const bool says_text = columns.names.contains("description") || !row.description.empty();
  const bool says_place = columns.has_places || !row.geometries.empty();
  change.has_new_name = says_name && !has_same_words(row.name, thing.name);
  change.has_new_description = says_text && !has_same_words(row.description, thing.description);
  change.has_new_place = says_place && !has_same_places(row, thing);
  if (!change.has_new_name) change.after.name = thing.name;
  if (!change.has_new_description) change.after.description = thing.description;
  if (!change.has_new_place) change.after.geometries = thing.geometries;
  return change;
}

bool is_any(const RowChange& change) {
  return change.has_new_type || change.has_new_name || change.has_new_description ||
         change.has_new_place || !change.fields.empty();
}

}  // namespace

RowChanges row_changes(const KmlSource& things, const std::vector<SourcePlacemark>& rows,
                       const std::map<std::string, SheetColumns>& columns,
                       const Declarations& declarations) {
  std::map<ThingKey, const SourcePlacemark*> of_plan;
  for (const SourcePlacemark& thing : things.placemarks) {
    const std::optional<ThingKey> key = key_of(thing);
    LSOS_ASSERT(key);
    of_plan[*key] = &thing;
  }
  RowChanges changes;
  changes.merged.file = things.file;
  std::set<ThingKey> with_row;
  for (const SourcePlacemark& row : rows) {
    const std::optional<ThingKey> key = key_of(row);
    const auto thing = key ? of_plan.find(*key) : of_plan.end();
    if (thing == of_plan.end()) {
      changes.added.push_back({key.value_or(ThingKey{}), {}, row});
      changes.merged.placemarks.push_back(row);
      continue;
    }
    with_row.insert(*key);
    const auto said = columns.find(row.file);
    RowChange change =
        change_of(*key, *thing->second, row, said == columns.end() ? SheetColumns{} : said->second,
                  declarations);
    changes.merged.placemarks.push_back(change.after);
    if (is_any(change)) {
      changes.changed.push_back(std::move(change));
    } else {
      ++changes.unchanged;
    }
  }
  for (const SourcePlacemark& thing : things.placemarks) {
    const ThingKey key = *key_of(thing);
    if (with_row.contains(key)) continue;
    changes.without_row.push_back(key);
    changes.merged.placemarks.push_back(thing);
  }
  return changes;
}

std::vector<ThingKey> removable(const RowChanges& changes, const std::vector<SourcePlacemark>& rows,
                                std::set<ThingKey::Kind> kinds) {
  for (const SourcePlacemark& row : rows) {
    if (const std::optional<ThingKey> key = key_of(row)) kinds.insert(key->kind);
  }
  std::vector<ThingKey> keys;
  for (const ThingKey& key : changes.without_row) {
    if (key.kind != ThingKey::Kind::mission && kinds.contains(key.kind)) keys.push_back(key);
  }
  return keys;
}

void leave_out(RowChanges& changes, const std::vector<ThingKey>& keys) {
  const auto is_out = [&](const ThingKey& key) { return std::ranges::count(keys, key) > 0; };
  std::erase_if(changes.without_row, is_out);
  std::erase_if(changes.merged.placemarks, [&](const SourcePlacemark& thing) {
    const std::optional<ThingKey> key = key_of(thing);
    return key && is_out(*key);
  });
}

}  // namespace lsos
