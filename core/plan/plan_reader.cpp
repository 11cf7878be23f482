#include <algorithm>

#include "plan/classify.h"
#include "plan/event_reader.h"
#include "plan/kml_reader.h"
#include "plan/mission_reader.h"
#include "plan/plan.h"
#include "plan/references.h"

namespace lsos {

namespace {

Plan read_placemarks(const std::string& file, const KmlSource& source,
                     const Declarations& declarations, Faults& faults) {
  Plan plan;
  plan.file = file;
  const Classified ours = classify(source, declarations, faults);
  plan.decoration_count = ours.decoration_count;

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
