#include "lua/edit/change_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plan/suggestions.h"

namespace lsos {

namespace {

constexpr std::size_t listed_max = 30, keys_max = 12;

// "A/20 Route 'To the rim'".
std::string title(const ThingKey& key, const SourcePlacemark& thing) {
  if (key.kind != ThingKey::Kind::event) return key_text(key);
  const std::string name = thing.name.empty() ? "" : " " + quoted(thing.name);
  return fmt::format("{} {}{}", key_text(key), thing.data.front().schema, name);
}

// "Speed = 5 km/h, was 4 km/h".
std::string changed_value_text(const std::string& name, const std::string& before,
                               const std::string& after) {
  if (before.empty()) return fmt::format("{} = {}", name, after);
  if (after.empty()) return fmt::format("no {}, was {}", name, before);
  return fmt::format("{} = {}, was {}", name, after, before);
}

// "0.02,0.004 > 0.012,-0.006"; of more than four points the first and last two.
std::string mark_place_text(const SourcePlacemark& thing) {
  constexpr std::size_t ends = 2;
  if (thing.geometries.empty()) return "";
  std::vector<std::string> tuples = coordinate_tuples(thing.geometries.front().coordinates);
  for (std::string& tuple : tuples) {
    tuple = tuple.substr(0, std::min(tuple.find(',', tuple.find(',') + 1), tuple.size()));
  }
  if (tuples.size() > 2 * ends) {
    const std::string left_out = fmt::format("{} more", tuples.size() - 2 * ends);
    tuples.erase(tuples.begin() + ends, tuples.end() - ends);
    tuples.insert(tuples.begin() + ends, left_out);
  }
  return fmt::format("{}", fmt::join(tuples, " > "));
}

// The beginning of a description, on one line.
std::string description_words(const std::string& description) {
  return description.empty() ? "" : quoted(description);
}

std::vector<std::string> what_changed(const RowChange& change) {
  std::vector<std::string> parts;
  if (change.has_new_type) {
    parts.push_back(changed_value_text("Type", change.before.data.front().schema,
                                       change.after.data.front().schema));
  }
  if (change.has_new_name) {
    parts.push_back(changed_value_text("name", change.before.name, change.after.name));
  }
  for (const std::string& name : change.fields) {
    parts.push_back(
        changed_value_text(name, field_of(change.before, name), field_of(change.after, name)));
  }
  if (change.has_new_place) {
    parts.push_back(
        changed_value_text("place", mark_place_text(change.before), mark_place_text(change.after)));
  }
  if (change.has_new_type && !change.has_new_place && !change.after.geometries.empty()) {
    parts.emplace_back("its place stays");
  }
  if (change.has_new_description) {
    parts.push_back(changed_value_text("description", description_words(change.before.description),
                                       description_words(change.after.description)));
  }
  return parts;
}

std::string moved_text(const MovedPlace& moved) {
  return fmt::format("  moved: the place {} to {}, was {}\n", quoted(moved.place.name),
                     moved.coordinates, moved.place.coordinates);
}

std::string list_text(const std::vector<RowChange>& changes, bool is_new) {
  std::string text;
  for (std::size_t i = 0; i < changes.size() && i < listed_max; ++i) {
    const RowChange& change = changes[i];
    text += is_new ? fmt::format("  added: {}\n", title(change.key, change.after))
                   : fmt::format("  changed: {}: {}\n", title(change.key, change.before),
                                 fmt::join(what_changed(change), "; "));
  }
  if (changes.size() > listed_max) {
    text += fmt::format("  and {} more {}\n", changes.size() - listed_max,
                        is_new ? "added" : "changed");
  }
  return text;
}

// "A/20, A/30 and 7 more".
std::string keys_text(const std::vector<ThingKey>& keys) {
  std::vector<std::string> texts;
  for (const ThingKey& key : keys) {
    if (texts.size() < keys_max) texts.push_back(key_text(key));
  }
  const std::string more =
      keys.size() > keys_max ? fmt::format(" and {} more", keys.size() - keys_max) : "";
  return fmt::format("{}{}", fmt::join(texts, ", "), more);
}

// Those that the mission and its rovers have in any case are not worth a word.
std::vector<ThingKey> kept_of(const OntoResult& result) {
  std::vector<ThingKey> kept = result.changes.without_row;
  std::erase_if(kept, [](const ThingKey& key) { return key.kind == ThingKey::Kind::mission; });
  return kept;
}

}  // namespace

std::string onto_text(const OntoResult& result, const std::string& output) {
  const RowChanges& changes = result.changes;
  std::string text;
  for (const std::string& line : result.notes) text += fmt::format("  note: {}\n", line);
  for (const MovedPlace& each : result.moved_places) text += moved_text(each);
  text += list_text(changes.changed, false) + list_text(changes.added, true);
  for (const std::string& line : result.left_out) text += fmt::format("  left out: {}\n", line);
  const std::vector<ThingKey> kept = kept_of(result);
  if (!result.removed.empty()) text += fmt::format("  removed: {}\n", keys_text(result.removed));
  if (!kept.empty()) {
    const std::string hint =
        result.removable.empty()
            ? ""
            : fmt::format(" (--remove-missing removes {})",
                          result.removable.size() == kept.size()
                              ? kept.size() == 1 ? "it" : "them"
                              : fmt::format("{} of them", result.removable.size()));
    text += fmt::format("  kept without a row{}: {}\n", hint, keys_text(kept));
  }
  return text + fmt::format(
                    "{} changed, {} added, {} as they were, {} without a row kept, {} "
                    "removed; wrote {}\n",
                    changes.changed.size(), changes.added.size(), changes.unchanged, kept.size(),
                    result.removed.size(), output);
}

std::string onto_json(const OntoResult& result, const std::string& output) {
  using Json = nlohmann::ordered_json;
  const auto names = [](const std::vector<ThingKey>& keys) {
    Json list = Json::array();
    for (const ThingKey& key : keys) list.push_back(key_text(key));
    return list;
  };
  Json changed = Json::array(), added = Json::array();
  for (const RowChange& change : result.changes.changed) {
    changed.push_back({{"thing", key_text(change.key)}, {"changes", what_changed(change)}});
  }
  for (const RowChange& row : result.changes.added) added.push_back(key_text(row.key));
  Json moved = Json::array();
  for (const MovedPlace& each : result.moved_places) {
    moved.push_back({{"place", each.place.name}, {"to", each.coordinates}});
  }
  const Json answer{{"plan", output},
                    {"plan_sha256", result.plan_sha256},
                    {"changed", changed},
                    {"added", added},
                    {"unchanged", result.changes.unchanged},
                    {"kept", names(kept_of(result))},
                    {"removed", names(result.removed)},
                    {"moved_places", moved},
                    {"notes", result.notes},
                    {"left_out", result.left_out}};
  return answer.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lsos
