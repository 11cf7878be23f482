#include "mission/model/leader_circles.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "plan/field_reader.h"

namespace lsos {

namespace {

struct Following {
  const PlanEvent* event;
  std::string leader_id;
};

std::vector<Following> followings_of(const Plan& plan, const Declarations& declarations) {
  std::vector<Following> followings;
  for (const PlanEvent& event : plan.events) {
    if (!event.is_enabled) continue;
    for (const FieldDeclaration& field : declarations.events.at(event.type).fields) {
      if (field.names != NameOf::leader) continue;
      const auto* leader_id = find_value<std::string>(event.params, field.key);
      if (leader_id != nullptr) followings.push_back({&event, *leader_id});
    }
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

}  // namespace

// From each rover the search goes along its leaders in the order of the plan; a circle is reported
// once, and events in it are not looked at again.
void check_leader_circles(const Plan& plan, const Declarations& declarations, Faults& faults) {
  const std::vector<Following> followings = followings_of(plan, declarations);
  std::vector<bool> is_done(followings.size());
  std::vector<std::size_t> path;
  for (std::size_t start = 0; start < followings.size(); ++start) {
    if (is_done[start]) continue;
    path.assign(1, start);
    is_done[start] = true;
    std::vector<std::size_t> next{0};  // what is tried behind each step of the path
    while (!path.empty()) {
      const std::string& leader_id = followings[path.back()].leader_id;
      std::size_t& candidate = next.back();
      if (candidate == followings.size()) {
        path.pop_back();
        next.pop_back();
        continue;
      }
      const std::size_t to = candidate++;
      if (followings[to].event->rover_id != leader_id) continue;
      const auto on_path = std::ranges::find(path, to);
      if (on_path != path.end()) {
        std::vector<const Following*> circle;
        for (auto at = on_path; at != path.end(); ++at) circle.push_back(&followings[*at]);
        faults.error(circle.front()->event->place, circle_text(circle));
        break;
      }
      if (is_done[to]) continue;
      is_done[to] = true;
      path.push_back(to);
      next.push_back(0);
    }
  }
}

}  // namespace lsos
