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

bool has_marker_field(const SourceData& data) {
  constexpr std::array<std::string_view, 3> markers{"RoverId", "Sequence", "RoverType"};
  return std::ranges::any_of(data.fields, [&](const SourceField& field) {
    return std::ranges::find(markers, field.name) != markers.end();
  });
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
    faults_.error(
        {source_.file, line},
        fmt::format("Placemark {}: {}",
                    placemark.name.empty() ? "without a name" : quoted(placemark.name), what));
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
    }
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
