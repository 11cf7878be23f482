#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/files.h"
#include "base/resolved_path.h"
#include "base/sha256.h"
#include "plan/classify.h"
#include "plan/event_reader.h"
#include "plan/far_places.h"
#include "plan/kml_reader.h"
#include "plan/kml_text.h"
#include "plan/mission_reader.h"
#include "plan/open_drives.h"
#include "plan/plan.h"
#include "plan/references.h"
#include "plan/schema_types.h"
#include "plan/suggestions.h"
#include "plan/timed_events.h"
#include "plan/unread.h"

namespace lsos {

namespace {

bool has_no_plan_placemark(const Classified& found) {
  return found.missions.empty() && found.rovers.empty() && found.assets.empty() &&
         found.events.empty();
}

constexpr const char* is_not_read =
    "is not read: a plan is one KML document, or a KMZ archive that holds what its document links "
    "to";

// Whether a link may lead to a part of the plan; base maps and other images are decoration.
bool may_lead_to_plan(const std::string& href) {
  std::string name = href.substr(0, href.find_first_of("#?"));
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.ends_with(".kml");
}

void warn_of_links(const KmlSource& source, Faults& faults) {
  for (const KmlSource::Link& link : source.links) {
    if (!may_lead_to_plan(link.href)) continue;
    faults.warning({link.file, link.line}, fmt::format("NetworkLink to {}: what it links to {}",
                                                       quoted(link.href), is_not_read));
  }
}

// Reports layers whose CRS is of another body than the mission's. A geographic CRS is only a
// warning, because its degrees are usable: GIS tools use the Earth's by default, also for KML.
void check_layers(const KmlSource& source, const MissionInfo& mission, Faults& faults) {
  if (mission.planet == nullptr) return;
  for (const KmlSource::Layer& layer : source.layers) {
    if (layer.body == mission.planet->name) continue;
    const Place place{layer.file, 0};
    if (layer.body.empty()) {
      faults.warning(place,
                     fmt::format("has no CRS: its coordinates are taken for degrees of the {}",
                                 mission.planet->name));
    } else if (layer.is_geographic) {
      faults.warning(place, fmt::format("its CRS is of {}, Planet is {}: its degrees are taken for "
                                        "those of {}",
                                        layer.body, mission.planet->name, mission.planet->name));
    } else {
      faults.error(
          place,
          fmt::format("its CRS is of {}, Planet is {}; it is to be saved in {}, or in degrees "
                      "of {}, which are then taken for those of {}",
                      layer.body, mission.planet->name, mission.planet->crs, layer.body,
                      mission.planet->name));
    }
  }
}

// Message for a map that is no plan: one statement replaces a list of all that it lacks.
std::string no_plan_text(int count, const KmlSource& source) {
  if (!source.layers.empty()) {
    return fmt::format(
        "is a GeoPackage but no plan: it has {} features, none of them of a layer MissionInfo, "
        "Rover, Asset or event; lsos-host schema -o plan.gpkg makes one to draw in",
        count);
  }
  const std::vector<KmlSource::Link>& links = source.links;
  const std::string seen =
      count == 0 ? "no Placemark"
                 : fmt::format("{} Placemark{}, none of them a MissionInfo, Rover, Asset or event",
                               count, count == 1 ? "" : "s");
  return fmt::format(
      "is KML but no plan: it has {}; a plan has one with <SchemaData schemaUrl=\"#MissionInfo\">, "
      "and one with \"#Rover\" for each rover{}",
      seen,
      links.empty()
          ? ""
          : fmt::format("; it links to {}, which {}", quoted(links[0].href), is_not_read));
}

// Message for a plan of more things than are simulated; "" for any other. Rovers and assets are
// looked at in pairs, for shadows, sight and contact.
std::string excess_text(const Classified& ours) {
  constexpr std::size_t rovers_max = 500, events_max = 20'000;
  const std::size_t rovers = ours.rovers.size() + ours.assets.size();
  if (rovers > rovers_max) {
    return fmt::format(
        "has {} rovers and assets; a plan may have {}: make several plans of it, each "
        "of rovers that meet",
        rovers, rovers_max);
  }
  if (ours.events.size() > events_max) {
    return fmt::format(
        "has {} events; a plan may have {}: make several plans of some days each; "
        "'lsos-host run LATER.kml --from RUN' goes on from the run of an earlier one",
        ours.events.size(), events_max);
  }
  return "";
}

}  // namespace

const Geodetic& site_of(const Plan& plan) {
  const MissionInfo& mission = plan.mission;
  if (mission.earlier_site) return *mission.earlier_site;
  return mission.site ? *mission.site : plan.rovers.front().start;
}

const PlanRover* rover_of(const Plan& plan, const std::string& rover_id) {
  const auto end = plan.rovers.end();
  const auto first = std::ranges::lower_bound(plan.rovers, rover_id, {}, &PlanRover::id);
  if (first == end || first->id != rover_id) return nullptr;
  const bool is_only = first + 1 == end || (first + 1)->id != rover_id;
  return is_only ? &*first : nullptr;
}

// CaseOf is looked for before scripts are known, and so before Placemarks are classified: no other
// kind of Placemark has a field of that name. What lies beside a plan of the user's is not for any
// plan that names it, but for one that was made of it.
std::string home_of(const KmlSource& source, const std::string& file) {
  std::string text, digest;
  const auto look = [&](const std::vector<SourceField>& fields) {
    for (const SourceField& field : fields) {
      if (field.name == case_of_field && text.empty()) text = field.text;
      if (field.name == case_digest_field && digest.empty()) digest = field.text;
    }
  };
  for (const SourcePlacemark& placemark : source.placemarks) {
    for (const SourceData& data : placemark.data) look(data.fields);
    look(placemark.plain_data);
  }
  if (text.empty()) return file;
  const std::string home = resolved_path(std::filesystem::path(file).parent_path().string(), text);
  const std::optional<std::string> bytes = read_file(home);
  return bytes && sha256_hex(*bytes) == digest ? home : file;
}

Plan read_plan(const std::string& file, const KmlSource& source, const Declarations& declarations,
               Faults& faults) {
  Plan plan;
  plan.file = file;
  plan.home = home_of(source, file);
  for (const auto& [type, event] : declarations.events) {
    if (event.activity != Activity::none) plan.activities[type] = event.activity;
  }
  const Classified ours = classify(source, declarations, faults);
  plan.decoration_count = ours.decoration_count;
  if (has_no_plan_placemark(ours) && !faults.has_errors()) {
    faults.error({source.file, 0}, no_plan_text(ours.decoration_count, source));
    return plan;
  }
  if (const std::string excess = excess_text(ours); !excess.empty()) {
    faults.error({source.file, 0}, excess);
    return plan;
  }
  warn_of_links(source, faults);
  check_schema_types(source, ours, faults);

  const ReadContext context{plan.home, source.file, declarations, faults};
  Unread unread = read_unread(ours.unread, context, plan.gaps);
  // A MissionInfo or a Rover that cannot be read is present all the same: it is not missing.
  if (ours.missions.empty() && unread.has_mission) {
    plan.gaps.start_time = true;
  } else {
    plan.mission = read_mission(ours.missions, context, plan.gaps, plan.defaults);
  }
  check_layers(source, plan.mission, faults);
  IdPlaces ids;
  if (!ours.rovers.empty() || !unread.has_rover) {
    plan.rovers = read_rovers(ours.rovers, context, ids, plan.gaps, plan.defaults);
  }
  std::vector<std::string> rover_ids = std::move(unread.rover_ids);
  for (const auto& [id, place] : ids) rover_ids.push_back(id);
  plan.assets = read_assets(ours.assets, context, ids, plan.gaps);

  std::vector<DraftEvent> drafts = read_events(ours.events, context, rover_ids, plan.gaps);
  for (DraftEvent& draft : unread.events) {
    draft.is_rover_known = std::ranges::find(rover_ids, draft.event.rover_id) != rover_ids.end();
    drafts.push_back(std::move(draft));
  }
  set_times(drafts, declarations, plan.mission, plan.gaps);
  resolve_references(drafts, faults);
  const std::vector<std::string> failure_defaults =
      apply_failure_defaults(drafts, plan.mission, plan.rovers, faults);
  check_timed_events(drafts, declarations, faults);
  check_circles(drafts, declarations, faults);
  if (plan.mission.planet != nullptr) {
    check_stationary_points(drafts, plan.rovers, plan.gaps, *plan.mission.planet, faults);
    check_far_places(drafts, plan.mission, plan.rovers, plan.assets, plan.gaps, faults);
  }
  find_open_drives(drafts, plan.gaps);
  std::erase_if(drafts, [](const DraftEvent& draft) { return !draft.is_read; });
  std::ranges::copy(common_defaults(ours.events, drafts), std::back_inserter(plan.defaults));
  std::ranges::copy(failure_defaults, std::back_inserter(plan.defaults));
  for (DraftEvent& draft : drafts) {
    plan.events.push_back(std::move(draft.event));
    std::ranges::move(draft.defaults, std::back_inserter(plan.defaults));
  }
  return plan;
}

PlanEvent read_event(const SourcePlacemark& placemark, const Plan& plan,
                     const Declarations& declarations) {
  Faults faults;
  const KmlSource source{placemark.file.empty() ? plan.file : placemark.file, {placemark}};
  const Classified ours = classify(source, declarations, faults);
  faults.throw_if_errors();
  LSOS_ASSERT(ours.events.size() == 1);
  const ReadContext context{plan.home, source.file, declarations, faults};
  std::vector<std::string> rover_ids;
  for (const PlanRover& rover : plan.rovers) rover_ids.push_back(rover.id);
  std::vector<DraftEvent> drafts = read_events(ours.events, context, rover_ids, plan.gaps);
  for (const PlanEvent& event : plan.events) {
    DraftEvent draft;
    draft.event = event;
    draft.subject = fmt::format("{} '{}'", event.type, event.label);
    draft.is_placed = draft.is_rover_known = draft.is_sequence_known = true;
    drafts.push_back(std::move(draft));
  }
  const auto identity_of = [](const DraftEvent& draft) {
    return PlanEvent::Reference{draft.event.rover_id, draft.event.sequence};
  };
  const PlanEvent::Reference identity = identity_of(drafts.front());
  std::ranges::stable_sort(drafts, {}, identity_of);
  set_times(drafts, declarations, plan.mission, plan.gaps);
  resolve_references(drafts, faults);
  apply_failure_defaults(drafts, plan.mission, plan.rovers, faults);
  check_timed_events(drafts, declarations, faults);
  check_circles(drafts, declarations, faults);
  faults.throw_if_errors();
  return std::ranges::find(drafts, identity, identity_of)->event;
}

Plan read_plan(const std::string& file, const Declarations& declarations, Faults& faults) {
  try {
    return read_plan(file, parse_plan(read_bytes(file), file), declarations, faults);
  } catch (const InputError& error) {
    faults.add(error.faults());
  }
  Plan plan;
  plan.file = plan.home = file;
  return plan;
}

}  // namespace lsos
