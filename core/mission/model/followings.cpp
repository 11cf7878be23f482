#include "mission/model/followings.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "base/circles.h"
#include "mission/port/rover_port.h"
#include "plan/field_reader.h"
#include "plan/suggestions.h"
#include "vehicle/footprint.h"
#include "vehicle/suspension/rover_spec.h"

namespace lsos {

namespace {

struct Following {
  const PlanEvent* event;
  const EventDeclaration* declaration;
  std::string leader_id;
};

std::vector<Following> followings_of(const Plan& plan, const Declarations& declarations) {
  std::vector<Following> followings;
  for (const PlanEvent& event : plan.events) {
    if (!event.is_enabled) continue;
    const EventDeclaration& declaration = declarations.events.at(event.type);
    const std::string* leader_id = find_name(event.params, declaration, NameOf::leader);
    if (leader_id != nullptr) followings.push_back({&event, &declaration, *leader_id});
  }
  return followings;
}

std::string circle_text(const std::vector<const Following*>& circle) {
  const PlanEvent& first = *circle.front()->event;
  if (circle.size() == 1) {
    return fmt::format("{} '{}': {} follows itself", first.type, first.label, first.rover_id);
  }
  std::string text = fmt::format("{} '{}': rovers follow each other in a circle: {}", first.type,
                                 first.label, first.rover_id);
  for (const Following* following : circle) {
    text += fmt::format("{} follows {} ('{}')", following == circle.front() ? "" : ", which",
                        following->leader_id, following->event->label);
  }
  return text;
}

// Each circle is told from its first event in the plan. When circles share an event, only the first
// found is told.
void check_circles(const std::vector<Following>& followings, Faults& faults) {
  std::vector<std::vector<std::size_t>> edges(followings.size());
  for (std::size_t from = 0; from < followings.size(); ++from) {
    for (std::size_t to = 0; to < followings.size(); ++to) {
      if (followings[to].event->rover_id == followings[from].leader_id) edges[from].push_back(to);
    }
  }
  std::set<std::size_t> is_told;
  for (std::vector<CircleStep>& steps : find_circles(edges)) {
    const auto was_told = [&](const CircleStep& step) { return is_told.contains(step.node); };
    if (std::ranges::any_of(steps, was_told)) continue;
    const auto first = std::ranges::min_element(steps, {}, &CircleStep::node);
    std::rotate(steps.begin(), first, steps.end());
    std::vector<const Following*> circle;
    for (const CircleStep& step : steps) {
      is_told.insert(step.node);
      circle.push_back(&followings[step.node]);
    }
    faults.error(circle.front()->event->place, circle_text(circle));
  }
}

void check_leader_events(const Following& following, const Plan& plan, Faults& faults) {
  if (rover_of(plan, following.leader_id) == nullptr) return;
  const bool has_any = std::ranges::any_of(plan.events, [&](const PlanEvent& event) {
    return event.rover_id == following.leader_id && event.is_enabled && !event.at;
  });
  if (has_any) return;
  faults.warning(
      following.event->place,
      fmt::format("{} '{}': {} has no event that takes a turn, so that it stands and counts as "
                  "having ended: this event ends as soon as it begins",
                  following.event->type, following.event->label, quoted(following.leader_id)));
}

// Half the length of a rover's body; absent where faults of the plan leave it open.
std::optional<double> half_length_m(const Plan& plan, const std::string& rover_id,
                                    const std::map<std::string, RoverModel>& rovers) {
  const PlanRover* rover = rover_of(plan, rover_id);
  const auto model = rover == nullptr ? rovers.end() : rovers.find(rover->model());
  if (model == rovers.end()) return {};
  constexpr double any_gravity_mps2 = 1;  // lengths do not depend on it
  return footprint_at_rest(make_vehicle(model->second.spec, rover->configuration, any_gravity_mps2))
      .half_m.x();
}

void check_distance(const Following& following, const Plan& plan,
                    const std::map<std::string, RoverModel>& rovers, Faults& faults) {
  const PlanEvent& event = *following.event;
  const double* distance_m =
      find_number(event.params, *following.declaration, NumberRole::following_distance);
  const auto own_m = half_length_m(plan, event.rover_id, rovers);
  const auto leader_m = half_length_m(plan, following.leader_id, rovers);
  if (distance_m == nullptr || !own_m || !leader_m) return;
  const double nearest_m = *own_m + *leader_m + pursuit_clearance_m;
  if (*distance_m >= nearest_m) return;
  const auto field = std::ranges::find(following.declaration->fields,
                                       NumberRole::following_distance, &FieldDeclaration::role);
  faults.warning(
      event.place,
      fmt::format("{} '{}': {} = {}: behind {}, {} comes no nearer than {:.1f} m, "
                  "between reference points, because of their lengths",
                  event.type, event.label, field->name, format_value(*field, *distance_m),
                  quoted(following.leader_id), quoted(event.rover_id), nearest_m));
}

}  // namespace

void check_followings(const Plan& plan, const Declarations& declarations,
                      const std::map<std::string, RoverModel>& rovers, Faults& faults) {
  const std::vector<Following> followings = followings_of(plan, declarations);
  check_circles(followings, faults);
  // Faults may keep events of the leader from being read.
  const bool are_events_known = !faults.has_errors();
  for (const Following& following : followings) {
    if (following.leader_id == following.event->rover_id) continue;
    if (are_events_known) check_leader_events(following, plan, faults);
    check_distance(following, plan, rovers, faults);
  }
}

}  // namespace lsos
