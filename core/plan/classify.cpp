#include "plan/classify.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "plan/suggestions.h"

namespace lsos {

namespace {

constexpr std::string_view mission_name = "MissionInfo";
constexpr std::string_view rover_name = "Rover";
constexpr std::string_view asset_name = "Asset";

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

class Classifier {
 public:
  Classifier(const KmlSource& source, const Declarations& declarations, Faults& faults)
      : source_(source),
        declarations_(declarations),
        faults_(faults),
        suggestions_(known_names(declarations)) {}

  Classified run() {
    for (const SourcePlacemark& placemark : source_.placemarks) classify(placemark);
    return std::move(classified_);
  }

 private:
  bool is_known(const std::string& name) const {
    return std::ranges::find(suggestions_.known(), name) != suggestions_.known().end();
  }

  bool is_nearly_known(const std::string& name) {
    constexpr int slip = 2;  // letters
    const auto [found, is_new] = nearly_known_.emplace(name, false);
    if (is_new) {
      found->second = std::ranges::any_of(suggestions_.known(), [&](const std::string& known) {
        return name.size() <= known.size() + slip && edit_distance(name, known) <= slip;
      });
    }
    return found->second;
  }

  void error(const SourcePlacemark& placemark, int line, const std::string& what) {
    faults_.error({source_.file, line}, fmt::format("{}: {}", subject(placemark), what));
  }

  void classify(const SourcePlacemark& placemark) {
    std::vector<const SourceData*> ours;
    for (const SourceData& data : placemark.data) {
      if (is_known(data.schema)) ours.push_back(&data);
    }
    const SourceData* nearly_ours = report_nearly_ours(placemark, !ours.empty());
    if (ours.size() > 1) {
      error(placemark, ours[1]->line,
            fmt::format("is a {} and a {}; one Placemark is one thing", ours[0]->schema,
                        ours[1]->schema));
      classified_.unread.push_back({&placemark, ours[0], nullptr});
    } else if (ours.size() == 1) {
      add({&placemark, ours[0], nullptr});
    } else if (nearly_ours != nullptr) {
      classified_.unread.push_back({&placemark, nearly_ours, nullptr});
    } else {
      ++classified_.decoration_count;
      warn_if_ours(placemark);
    }
  }

  // Map tools rewrite SchemaData as Data, and what kind of thing it is is lost.
  void warn_if_ours(const SourcePlacemark& placemark) {
    const auto may_be_ours = [](const std::string& field) {
      return is_marker(field) || field == "Planet";
    };
    const auto warn = [&](const std::string& field, const char* where) {
      faults_.warning({source_.file, placemark.line},
                      fmt::format("{}: is not used: its field {} stands in {}, which does not say "
                                  "what it is; <SchemaData schemaUrl=\"#NAME\"> with "
                                  "<SimpleData> is wanted",
                                  subject(placemark), field, where));
    };
    const auto plain = std::ranges::find_if(placemark.plain_data, may_be_ours);
    if (plain != placemark.plain_data.end()) return warn(*plain, "<Data>");
    for (const SourceData& data : placemark.data) {
      for (const SourceField& field : data.fields) {
        if (may_be_ours(field.name)) return warn(field.name, "another SchemaData");
      }
    }
  }

  static std::string subject(const SourcePlacemark& placemark) {
    return "Placemark " + (placemark.name.empty() ? "without a name" : quoted(placemark.name));
  }

  // In a Placemark that is ours, other SchemaData are what a GIS tool stamps on everything, unless
  // they have fields that only ours have. Answers the last one told.
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

  void add(OurPlacemark ours) {
    const std::string& name = ours.data->schema;
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
  Classified classified_;
};

}  // namespace

Classified classify(const KmlSource& source, const Declarations& declarations, Faults& faults) {
  return Classifier(source, declarations, faults).run();
}

}  // namespace lsos
