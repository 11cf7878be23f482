#include "edit/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/error.h"
#include "edit/event_names.h"
#include "edit/references_edit.h"
#include "plan/mission_reader.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

constexpr std::array<std::string_view, 8> features{"Placemark",    "Folder",        "Document",
                                                   "NetworkLink",  "GroundOverlay", "ScreenOverlay",
                                                   "PhotoOverlay", "Tour"};

bool is_feature(KmlElement element) {
  return std::ranges::find(features, local_name(element)) != features.end();
}

bool is_style(KmlElement element) {
  return local_name(element) == "Style" || local_name(element) == "StyleMap";
}

std::string stem_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

bool are_same(const TerrainName& a, const TerrainName& b) {
  std::error_code absent;
  return a.name == b.name ||
         (a.is_raster && b.is_raster && std::filesystem::equivalent(a.name, b.name, absent));
}

bool are_same(const PlanAsset& a, const PlanAsset& b) {
  return a.type == b.type && a.position.lon_rad == b.position.lon_rad &&
         a.position.lat_rad == b.position.lat_rad && a.antenna_height_m == b.antenna_height_m;
}

// Puts a copy behind the last child that `is_one`, else before the first that `is_next`, else at
// the end.
template <class IsOne, class IsNext>
void insert(KmlDom& dom, KmlElement element, const IsOne& is_one, const IsNext& is_next) {
  const std::vector<KmlElement> there = children(dom.container());
  const auto last = std::find_if(there.rbegin(), there.rend(), is_one);
  const auto next = std::find_if(there.begin(), there.end(), is_next);
  if (last != there.rend()) {
    dom.copy_behind(element, *last);
  } else if (next != there.end()) {
    dom.copy_before(element, *next);
  } else {
    dom.copy_into(element, dom.container());
  }
}

}  // namespace

Merger::Merger(PlanDocument& document, std::vector<PlanDocument*> others)
    : document_(document), others_(std::move(others)) {
  const Plan& plan = document.plan();
  for (const PlanRover& rover : plan.rovers) ids_[rover.id] = {plan.file, nullptr};
  for (const PlanAsset& asset : plan.assets) ids_[asset.id] = {plan.file, &asset};
  std::map<std::string, std::set<const Plan*>> plans_with;
  for (const PlanEvent& event : plan.events) plans_with[event.label].insert(&plan);
  for (const PlanDocument* other : others_) {
    for (const PlanEvent& event : other->plan().events) {
      plans_with[event.label].insert(&other->plan());
    }
  }
  for (const auto& [label, plans] : plans_with) {
    if (plans.size() > 1) shared_labels_.insert(label);
  }
}

Merged Merger::run() {
  name_by_sequence(document_);
  for (PlanDocument* other : others_) add(*other);
  return std::move(merged_);
}

void Merger::add(PlanDocument& other) {
  const Plan& plan = other.plan();
  Faults faults;
  check(other, faults);
  faults.throw_if_errors();
  warn_of_mission_fields(other);
  keep_failure_rules(other);
  name_by_sequence(other);
  for (const PlanAsset& asset : plan.assets) {
    // The same as one that is there, as check() found.
    if (!ids_.emplace(asset.id, Known{plan.file, &asset}).second) {
      other.dom().remove(other.asset(asset.id).element);
    }
  }
  other.dom().remove(other.mission().element);
  add_schemas(other);
  add_styles(other);
  add_features(other);
  for (const PlanRover& rover : plan.rovers) ids_[rover.id] = {plan.file, nullptr};
  merged_.rovers += static_cast<int>(plan.rovers.size());
  merged_.events += static_cast<int>(plan.events.size());
}

void Merger::check(const PlanDocument& other, Faults& faults) {
  const Plan& plan = other.plan();
  const MissionInfo &here = document_.plan().mission, &there = plan.mission;
  const auto error = [&](int line, const std::string& what) {
    faults.error({plan.file, line}, what);
  };
  if (here.planet != there.planet) {
    error(there.place.line,
          fmt::format("Planet is {}, and {} in {}; a mission has one", there.planet->name,
                      here.planet->name, document_.plan().file));
  }
  if (!are_same(here.terrain, there.terrain)) {
    error(there.place.line,
          fmt::format("Terrain is {}, and {} in {}; a mission has one", there.terrain.as_written,
                      here.terrain.as_written, document_.plan().file));
  }
  if (here.start_time != there.start_time) {
    error(there.place.line,
          fmt::format("StartTime is {}, and {} in {}; 'edit shift' with --by='{} s' moves the plan",
                      format_utc(there.start_time), format_utc(here.start_time),
                      document_.plan().file, seconds(here.start_time - there.start_time)));
  }
  for (const PlanRover& rover : plan.rovers) {
    const auto known = ids_.find(rover.id);
    if (known == ids_.end()) continue;
    error(rover.place.line, fmt::format("rover {} is in {} too; give it another RoverId in one of "
                                        "the plans, at its Rover and its events",
                                        quoted(rover.id), known->second.file));
  }
  for (const PlanAsset& asset : plan.assets) {
    const auto known = ids_.find(asset.id);
    if (known == ids_.end()) continue;
    if (known->second.asset != nullptr && are_same(*known->second.asset, asset)) continue;
    error(asset.place.line, fmt::format("asset {} is in {} too, and is another there; give it "
                                        "another AssetId in one of the plans, or make both equal",
                                        quoted(asset.id), known->second.file));
  }
}

// What MissionInfo says holds for the rovers of its plan.
void Merger::keep_failure_rules(PlanDocument& other) {
  const std::string here = document_.plan().mission.on_failure.text;
  const std::string there = other.plan().mission.on_failure.text;
  if (here == there) return;
  for (const PlanRover& rover : other.plan().rovers) {
    if (!rover.on_failure.text.empty()) continue;
    other.set_field(other.rover(rover.id), "OnFailure", there.empty() ? "stop" : there);
  }
}

void Merger::warn_of_mission_fields(const PlanDocument& other) {
  for (const FieldDeclaration& field : mission_fields()) {
    constexpr std::array<std::string_view, 5> told{"Planet", "StartTime", "Terrain", "OnFailure",
                                                   site_field};
    if (std::ranges::find(told, field.name) != told.end()) continue;
    const std::string here = document_.field(document_.mission(), field.name);
    const std::string there = other.field(other.mission(), field.name);
    if (there.empty() || here == there) continue;
    merged_.warnings.push_back(fmt::format(
        "{}: {} = {} of its MissionInfo is not taken over; {} has {}", other.plan().file,
        field.name, there, document_.plan().file, here.empty() ? "none" : here));
  }
}

void Merger::name_by_sequence(PlanDocument& document) {
  const EventNames names(document.plan());
  const Rewording by_sequence = [&](const EventReference& reference) {
    // A goto looks on its own rover alone.
    const bool is_ambiguous = shared_labels_.contains(reference.text) && !reference.is_goto;
    return std::optional(is_ambiguous ? reference_text(reference_to(reference.target))
                                      : reference.text);
  };
  for (const PlanEvent& event : document.plan().events) {
    reword_references(document, document.mark(event), event, names, by_sequence);
  }
}

void Merger::add_schemas(PlanDocument& other) {
  for (const KmlElement schema : children(other.dom().container())) {
    if (local_name(schema) != "Schema") continue;
    const std::vector<KmlElement> there = document_.dom().shared("Schema");
    const auto same = std::ranges::find_if(there, [&](KmlElement each) {
      return attribute(each, "id") == attribute(schema, "id") &&
             attribute(each, "name") == attribute(schema, "name");
    });
    if (same == there.end()) {
      insert(
          document_.dom(), schema, [](KmlElement each) { return local_name(each) == "Schema"; },
          is_feature);
      continue;
    }
    const std::vector<KmlElement> declared = children(*same);
    for (const KmlElement field : children(schema)) {
      const bool is_known = std::ranges::any_of(declared, [&](KmlElement each) {
        return attribute(each, "name") == attribute(field, "name");
      });
      if (!is_known) document_.dom().copy_into(field, *same);
    }
  }
}

void Merger::add_styles(PlanDocument& other) {
  std::map<std::string, KmlElement> there;
  for (const KmlElement each : children(document_.dom().container())) {
    if (is_style(each)) there[attribute(each, "id")] = each;
  }
  std::vector<KmlElement> added;
  std::map<std::string, std::string> renamed;  // "#id"
  for (const KmlElement style : children(other.dom().container())) {
    if (!is_style(style)) continue;
    const std::string id = attribute(style, "id");
    const auto same = there.find(id);
    if (same != there.end() && xml_of(same->second) == xml_of(style)) continue;
    if (same != there.end()) {
      std::string free = id + "-" + stem_of(other.plan().file);
      while (there.contains(free)) free += "-2";
      set_attribute(style, "id", free);
      renamed["#" + id] = "#" + free;
    }
    added.push_back(style);
  }
  for_each_element(other.dom().root(), [&](KmlElement each) {
    if (local_name(each) != "styleUrl") return;
    const auto to = renamed.find(text_of(each));
    if (to != renamed.end()) set_text(each, to->second);
  });
  for (const KmlElement style : added) {
    insert(document_.dom(), style, is_style,
           [](KmlElement each) { return local_name(each) == "Schema" || is_feature(each); });
  }
}

void Merger::add_features(PlanDocument& other) {
  KmlDom& dom = document_.dom();
  const KmlElement folder = dom.add(dom.container(), "Folder", "");
  dom.add(folder, "name", stem_of(other.plan().file));
  for (const KmlElement each : children(other.dom().container())) {
    if (is_feature(each)) dom.copy_into(each, folder);
  }
}

}  // namespace lsos
