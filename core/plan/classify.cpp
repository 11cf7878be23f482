#include "plan/classify.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string_view>

#include "plan/suggestions.h"

namespace lsos {

namespace {

constexpr std::string_view mission_name = "MissionInfo";
constexpr std::string_view rover_name = "Rover";
constexpr std::string_view asset_name = "Asset";
constexpr std::string_view type_name = "Type";

std::vector<std::string> known_names(const Declarations& declarations) {
  std::vector<std::string> names{std::string(mission_name), std::string(rover_name),
                                 std::string(asset_name)};
  for (const auto& [name, event] : declarations.events) names.push_back(name);
  return names;
}

// Fields that only rovers and events have.
bool is_marker(std::string_view field) {
  constexpr std::array<std::string_view, 3> markers{"RoverId", "Sequence", "RoverType"};
  return std::ranges::find(markers, field) != markers.end();
}

bool has_marker_field(const SourceData& data) {
  return std::ranges::any_of(data.fields,
                             [](const SourceField& field) { return is_marker(field.name); });
}

// Fields that map tools add to every feature, in any case of letters.
bool is_tool_field(std::string field) {
  constexpr std::array<std::string_view, 14> stamped{
      "fid",          "id",         "name",    "description", "timestamp", "begin", "end",
      "altitudemode", "tessellate", "extrude", "visibility",  "draworder", "icon",  "snippet"};
  std::ranges::transform(field, field.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::find(stamped, field) != stamped.end();
}

// Columns that GDAL's driver LIBKML adds to what it reads, in exactly this spelling.
bool is_libkml_column(std::string_view field) {
  return field == "heading" || field == "tilt" || field == "roll" || field == "altitudeMode";
}

class Classifier {
 public:
  Classifier(const KmlSource& source, const Declarations& declarations, Faults& faults)
      : source_(source),
        declarations_(declarations),
        faults_(faults),
        suggestions_(known_names(declarations)) {}

  Classified run() {
    for (const SourcePlacemark& placemark : source_.placemarks) classify(placemark);
    warn_of_unused();
    return std::move(classified_);
  }

 private:
  bool is_known(const std::string& name) const {
    return std::ranges::find(suggestions_.known(), name) != suggestions_.known().end();
  }

  bool is_nearly_known(const std::string& name) {
    constexpr int slip = 2;  // edit distance, letters
    const auto [found, is_new] = nearly_known_.emplace(name, false);
    if (is_new) {
      found->second = std::ranges::any_of(suggestions_.known(), [&](const std::string& known) {
        return name.size() <= known.size() + slip && edit_distance(name, known) <= slip;
      });
    }
    return found->second;
  }

  Place place(const SourcePlacemark& placemark, int line) const {
    return {placemark.file.empty() ? source_.file : placemark.file, line};
  }

  void error(const SourcePlacemark& placemark, int line, const std::string& what) {
    faults_.error(place(placemark, line), fmt::format("{}: {}", subject(placemark), what));
  }

  void classify(const SourcePlacemark& placemark) {
    std::vector<const SourceData*> ours;
    for (const SourceData& data : placemark.data) {
      if (is_known(data.schema)) ours.push_back(&data);
    }
    if (ours.size() > 1) {
      report_nearly_ours(placemark, true);
      error(placemark, ours[1]->line,
            fmt::format("is a {} and a {}; one Placemark is one thing", ours[0]->schema,
                        ours[1]->schema));
      classified_.unread.push_back({&placemark, *ours[0], nullptr});
    } else if (ours.size() == 1) {
      report_nearly_ours(placemark, true);
      classify_by_schema(placemark, *ours[0]);
    } else {
      classify_by_type(placemark);
    }
  }

  void classify_by_schema(const SourcePlacemark& placemark, const SourceData& data) {
    const SourceField* type = type_field(placemark, data.schema);
    if (type == nullptr || type->text == data.schema) {
      add({&placemark, joined_fields(placemark, &data, data.schema), nullptr});
      return;
    }
    error(placemark, type->line,
          fmt::format("is a {} by its schemaUrl and {} by its Type; one of them is wrong",
                      data.schema, shown(type->text)));
    classified_.unread.push_back({&placemark, data, nullptr});
  }

  // For a Placemark without a SchemaData of a known name.
  void classify_by_type(const SourcePlacemark& placemark) {
    const SourceField* type = type_field(placemark, "");
    if (type != nullptr && is_known(type->text)) {
      add({&placemark, joined_fields(placemark, nullptr, type->text), nullptr});
      return;
    }
    if (type != nullptr && (has_marker(placemark) || is_nearly_known(type->text))) {
      const std::string hint = suggestions_(type->text);
      error(placemark, type->line,
            fmt::format("Type = {}: there is no such event{}", shown(type->text),
                        hint.empty() ? "; there are " + listed(suggestions_.known()) : hint));
      classified_.unread.push_back({&placemark, all_fields(placemark), nullptr});
      return;
    }
    if (const std::string folder = folder_name(placemark); !folder.empty()) {
      if (has_field_of(placemark, folder)) {
        add({&placemark, joined_fields(placemark, nullptr, folder), nullptr});
        return;
      }
      count_unused(placemark, fmt::format("lies in the folder {} but has no field of a {}; it is "
                                          "not used",
                                          quoted(folder), folder));
    } else if (const SourceData* nearly_ours = report_nearly_ours(placemark, false)) {
      classified_.unread.push_back({&placemark, *nearly_ours, nullptr});
      return;
    } else {
      warn_if_ours(placemark);
    }
    ++classified_.decoration_count;
  }

  // The field Type of the Placemark; nullptr when there is none, or when `name` declares a field
  // Type of its own.
  const SourceField* type_field(const SourcePlacemark& placemark, const std::string& name) const {
    if (!name.empty() && has_declared(name, type_name)) return nullptr;
    const SourceField* found = nullptr;
    for_each_field(placemark, [&](const SourceField& field) {
      if (found == nullptr && field.name == type_name && !field.text.empty()) found = &field;
    });
    return found;
  }

  template <class Visit>
  static void for_each_field(const SourcePlacemark& placemark, const Visit& visit) {
    for (const SourceData& data : placemark.data) std::ranges::for_each(data.fields, visit);
    std::ranges::for_each(placemark.plain_data, visit);
  }

  static SourceData all_fields(const SourcePlacemark& placemark) {
    SourceData all;
    for_each_field(placemark, [&](const SourceField& field) { all.fields.push_back(field); });
    return all;
  }

  static bool has_marker(const SourcePlacemark& placemark) {
    return has_marker_field(all_fields(placemark));
  }

  // The innermost folder with a known name; "" when there is none.
  std::string folder_name(const SourcePlacemark& placemark) const {
    const auto& folders = placemark.folders;
    const auto found = std::find_if(folders.rbegin(), folders.rend(),
                                    [&](const std::string& name) { return is_known(name); });
    return found == folders.rend() ? "" : *found;
  }

  bool has_declared(const std::string& name, std::string_view field) const {
    return std::ranges::any_of(fields_of(name, declarations_), [&](const auto& list) {
      return std::ranges::find(list, field, &FieldDeclaration::name) != list.end();
    });
  }

  bool has_field_of(const SourcePlacemark& placemark, const std::string& name) const {
    return std::ranges::any_of(all_fields(placemark).fields, [&](const SourceField& field) {
      return !field.text.empty() && has_declared(name, field.name);
    });
  }

  // The fields of a Placemark of that name: those of the SchemaData `ours` (nullptr: of all its
  // SchemaData), and those in plain Data.
  SourceData joined_fields(const SourcePlacemark& placemark, const SourceData* ours,
                           const std::string& name) {
    SourceData joined{"", name, {}, placemark.line};
    if (ours != nullptr) joined = *ours;
    joined.fields.clear();
    for (const SourceData& data : placemark.data) {
      if (ours != nullptr && &data != ours) continue;
      for (const SourceField& field : data.fields) {
        const bool is_left_out =
            field.text.empty() || is_tool_field(field.name) || field.name == type_name;
        if (!is_left_out || has_declared(name, field.name)) joined.fields.push_back(field);
      }
    }
    for (const SourceField& field : placemark.plain_data) {
      if (is_wanted(placemark, field, name)) add_once(field, joined.fields);
    }
    return joined;
  }

  // Whether a field in plain Data belongs to a Placemark of that name. A foreign field is reported
  // once for all Placemarks that have it; one that is nearly right counts as wanted, because the
  // message of check_names() suggests the right name.
  bool is_wanted(const SourcePlacemark& placemark, const SourceField& field,
                 const std::string& name) {
    if (field.text.empty()) return false;
    if (has_declared(name, field.name)) return true;
    if (is_tool_field(field.name) || field.name == type_name) return false;
    std::vector<std::string> names;
    for (const auto& list : fields_of(name, declarations_)) {
      for (const FieldDeclaration& each : list) names.push_back(each.name);
    }
    const std::string hint = field.name.size() > 100 ? "" : did_you_mean(field.name, names);
    const bool is_table = !source_.layers.empty();
    const auto is_slip = [&](const std::string& known) {
      return edit_distance(known, field.name) <= 1;
    };
    if (is_table && is_libkml_column(field.name)) {
      if (hint.empty()) return false;
    } else if (!hint.empty() && (!is_table || std::ranges::any_of(names, is_slip))) {
      return true;
    }
    // Joins and notes leave columns in tables whose names only resemble those of the plan.
    count_unused(placemark,
                 fmt::format("the {} {} is no field of a {}; it is not used{}",
                             is_table ? "column" : "Data", quoted(field.name), name, hint));
    return false;
  }

  // Adds the field unless it stands there with the same text: equal repetition is no contradiction.
  static void add_once(const SourceField& field, std::vector<SourceField>& fields) {
    const auto same = std::ranges::find(fields, field.name, &SourceField::name);
    if (same != fields.end() && same->text.empty()) {
      *same = field;
    } else if (same == fields.end() || same->text != field.text) {
      fields.push_back(field);
    }
  }

  void count_unused(const SourcePlacemark& placemark, const std::string& what) {
    const auto [found, is_new] = unused_.emplace(what, Unused{&placemark, 0});
    ++found->second.count;
  }

  void warn_of_unused() {
    for (const auto& [what, unused] : unused_) {
      const std::string others =
          unused.count == 1 ? "" : fmt::format(" (so {} Placemarks)", unused.count);
      faults_.warning(place(*unused.first, unused.first->line),
                      fmt::format("{}: {}{}", subject(*unused.first), what, others));
    }
  }

  // Map tools rewrite SchemaData as Data, and the kind of the Placemark is then lost.
  void warn_if_ours(const SourcePlacemark& placemark) {
    const auto may_be_ours = [](const SourceField& field) {
      return !field.text.empty() && (is_marker(field.name) || field.name == "Planet");
    };
    const auto warn = [&](const SourceField& field, const char* where) {
      faults_.warning(place(placemark, placemark.line),
                      fmt::format("{}: is not used: its field {} stands in {}, which does not say "
                                  "what it is; a field Type = NAME, a folder of that name or "
                                  "<SchemaData schemaUrl=\"#NAME\"> is wanted",
                                  subject(placemark), field.name, where));
    };
    const auto plain = std::ranges::find_if(placemark.plain_data, may_be_ours);
    if (plain != placemark.plain_data.end()) return warn(*plain, "<Data>");
    for (const SourceData& data : placemark.data) {
      const auto found = std::ranges::find_if(data.fields, may_be_ours);
      if (found != data.fields.end()) return warn(*found, "another SchemaData");
    }
  }

  static std::string subject(const SourcePlacemark& placemark) {
    return "Placemark " + (placemark.name.empty() ? "without a name" : quoted(placemark.name));
  }

  // Reports SchemaData that are nearly ours and returns the last of them, or nullptr. In a
  // Placemark that is ours, other SchemaData come from a GIS tool that adds them to everything,
  // unless they have marker fields.
  const SourceData* report_nearly_ours(const SourcePlacemark& placemark, bool is_ours) {
    const SourceData* found = nullptr;
    for (const SourceData& data : placemark.data) {
      if (is_known(data.schema)) continue;
      const bool has_hash = data.schema_url.find('#') != std::string::npos;
      const std::string& name = has_hash ? data.schema : data.schema_url;
      if (!has_marker_field(data) && (is_ours || !is_nearly_known(name))) continue;
      found = &data;
      if (const auto broken = declarations_.broken_events.find(name);
          broken != declarations_.broken_events.end()) {
        faults_.add(broken->second);
        error(placemark, data.line, fmt::format("the script of event {} is broken", shown(name)));
        continue;
      }
      std::string what =
          fmt::format("schemaUrl = {}: there is no event {}", shown(data.schema_url), shown(name));
      if (!has_hash) what = fmt::format("schemaUrl = {}: has no '#'", shown(data.schema_url));
      if (!has_hash && is_known(name)) {
        what += fmt::format("; did you mean '#{}'?", name);
      } else {
        const std::string hint = suggestions_(name);
        what += hint.empty() ? fmt::format("; there are {}", listed(suggestions_.known())) : hint;
      }
      error(placemark, data.line, what);
    }
    return found;
  }

  void add(PlanPlacemark ours) {
    const std::string& name = ours.data.schema;
    if (name == mission_name) {
      classified_.missions.push_back(ours);
    } else if (name == rover_name) {
      classified_.rovers.push_back(ours);
    } else if (name == asset_name) {
      classified_.assets.push_back(ours);
    } else {
      ours.event = &declarations_.events.at(name);
      classified_.events.push_back(ours);
    }
  }

  const KmlSource& source_;
  const Declarations& declarations_;
  Faults& faults_;
  Suggestions suggestions_;
  std::map<std::string, bool> nearly_known_;
  // How many Placemarks have something that is not used, and the first of them.
  struct Unused {
    const SourcePlacemark* first;
    int count;
  };
  std::map<std::string, Unused> unused_;
  Classified classified_;
};

}  // namespace

Classified classify(const KmlSource& source, const Declarations& declarations, Faults& faults) {
  return Classifier(source, declarations, faults).run();
}

}  // namespace lsos
