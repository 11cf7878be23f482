#include <fmt/format.h>

#include <algorithm>

#include "plan/classify.h"
#include "plan/event_reader.h"
#include "plan/kml_reader.h"
#include "plan/mission_reader.h"
#include "plan/plan.h"
#include "plan/references.h"

namespace lsos {

namespace {

bool has_nothing_of_ours(const Classified& found) {
  return found.missions.empty() && found.rovers.empty() && found.assets.empty() &&
         found.events.empty();
}

// Any map that is no plan: one answer instead of a list of all that it lacks.
std::string no_plan(int count) {
  const std::string seen =
      count == 0 ? "no Placemark"
                 : fmt::format("{} Placemark{}, none of them a MissionInfo, Rover, Asset or event",
                               count, count == 1 ? "" : "s");
  return fmt::format(
      "is KML but no plan: it has {}; a plan has one with <SchemaData schemaUrl=\"#MissionInfo\">, "
      "and one with \"#Rover\" for each rover",
      seen);
}

Plan read_placemarks(const std::string& file, const KmlSource& source,
                     const Declarations& declarations, Faults& faults) {
  Plan plan;
  plan.file = file;
  const Classified ours = classify(source, declarations, faults);
  plan.decoration_count = ours.decoration_count;
  if (has_nothing_of_ours(ours) && !faults.has_errors()) {
    faults.error({source.file, 0}, no_plan(ours.decoration_count));
    return plan;
  }

  const ReadContext context{file, source.file, declarations, faults};
  plan.mission = read_mission(ours.missions, context, plan.defaults);
  IdLines ids;
  plan.rovers = read_rovers(ours.rovers, context, ids, plan.defaults);
  std::vector<std::string> rover_ids;
  for (const auto& [id, line] : ids) rover_ids.push_back(id);
  plan.assets = read_assets(ours.assets, context, ids);

  std::vector<DraftEvent> drafts = read_events(ours.events, context, rover_ids);
  resolve_references(drafts, faults);
  check_circles(drafts, faults);
  // Places that are wrong themselves would only give wrong distances.
  if (plan.mission.planet != nullptr && !faults.has_errors()) {
    check_stationary_points(drafts, plan.rovers, *plan.mission.planet, faults);
  }
  for (std::string& text : common_defaults(ours.events)) plan.defaults.push_back(std::move(text));
  for (DraftEvent& draft : drafts) {
    plan.events.push_back(std::move(draft.event));
    std::ranges::move(draft.defaults, std::back_inserter(plan.defaults));
  }
  return plan;
}

}  // namespace

Plan read_plan(const std::string& file, const Declarations& declarations, Faults& faults) {
  try {
    return read_placemarks(file, read_kml(file), declarations, faults);
  } catch (const InputError& error) {
    faults.add(error.faults());
  }
  Plan plan;
  plan.file = file;
  return plan;
}

}  // namespace lsos
