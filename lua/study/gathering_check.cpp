#include "lua/study/gathering_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "edit/event_names.h"
#include "lua/host/condition.h"
#include "lua/host/condition_words.h"
#include "lua/host/host.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

using Take = Gathering::Take;

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const ConditionName& each : condition_names()) {
    if (!is_question(each.name)) names.emplace_back(each.name);
  }
  return names;
}

// Checks one gathering, and says what it lacks.
class GatheringCheck {
 public:
  GatheringCheck(const MissionFiles& mission, Gathering& gathering, Faults& faults)
      : plan_(mission.plan), mission_(mission), gathering_(gathering), faults_(faults) {}

  void run() {
    if (gathering_.take == Take::summary) {
      check_path();
    } else if (!gathering_.event.empty()) {
      find_event();
    } else {
      check_known("rover", gathering_.rover, rover_ids(plan_));
    }
    if (!gathering_.quantity.empty()) {
      check_known("quantity", gathering_.quantity, quantity_names());
    }
    if (gathering_.take == Take::share) check_condition();
    if (gathering_.name.empty()) gathering_.name = default_name();
  }

 private:
  void refuse(const std::string& why) { faults_.error(gathering_.place, "gather: " + why); }

  void check_known(const char* what, const std::string& name,
                   const std::vector<std::string>& known) {
    if (std::ranges::count(known, name) > 0) return;
    const std::string hint = did_you_mean(name, known);
    refuse(fmt::format("there is no {} '{}'{}", what, name,
                       hint.empty() ? "; there are " + listed(known) : hint));
  }

  void find_event() {
    const EventNames names(plan_);
    const auto meant = names.meanings(gathering_.event);
    if (meant.size() == 1) {
      gathering_.rover = meant.front()->rover_id;
      gathering_.event = reference_text(reference_to(*meant.front()));
      return;
    }
    std::vector<std::string> known;
    for (const PlanEvent& event : plan_.events) {
      known.push_back(event.label);
      known.push_back(reference_text(reference_to(event)));
    }
    refuse(meant.empty() ? fmt::format("the plan has no event '{}'{}", gathering_.event,
                                       did_you_mean(gathering_.event, known))
                         : fmt::format("{} events are called '{}'; ROVER/SEQUENCE says which",
                                       meant.size(), gathering_.event));
  }

  // The words of a path whose values are known before anything runs.
  void check_path() {
    const std::string& path = gathering_.path;
    const std::size_t point = path.find('.');
    const std::string first = path.substr(0, point);
    check_known("value in summary.json called", first,
                {"status", "log_sha256", "sim_s", "wall_s", "real_time_factor", "rovers", "events",
                 "plan"});
    if (first == "rovers" || first == "events") {
      std::vector<std::string> known = rover_ids(plan_);
      if (first == "events") {
        known.clear();
        for (const PlanEvent& event : plan_.events) {
          known.push_back(reference_text(reference_to(event)));
        }
      }
      const std::string rest = point == std::string::npos ? "" : path.substr(point + 1);
      const bool is_known = std::ranges::any_of(known, [&](const std::string& name) {
        return rest.starts_with(name + ".") && rest.size() > name.size() + 1;
      });
      if (is_known) return;
      refuse(fmt::format("summary = '{}': '{}.NAME.VALUE' is wanted; there are {}", path, first,
                         listed(known)));
    }
  }

  void check_condition() {
    if (has_question(gathering_.condition)) {
      refuse(
          fmt::format("share_when = '{}': the log's samples do not say what a question asks; "
                      "quantities do",
                      gathering_.condition));
      return;
    }
    LuaHost host(*mission_.catalog);
    const std::string fault = host.condition_fault(gathering_.condition, {});
    if (!fault.empty()) {
      refuse(fmt::format("share_when = '{}': {}", gathering_.condition, fault));
    }
  }

  std::string default_name() const {
    switch (gathering_.take) {
      case Take::summary:
        return gathering_.path;
      case Take::at_start:
        return fmt::format("{} {} at start", gathering_.event, gathering_.quantity);
      case Take::at_end:
        return fmt::format("{} {} at end", gathering_.event, gathering_.quantity);
      case Take::least:
        return fmt::format("{} least {}", gathering_.rover, gathering_.quantity);
      case Take::greatest:
        return fmt::format("{} greatest {}", gathering_.rover, gathering_.quantity);
      case Take::share:
        break;
    }
    return fmt::format("{} share of time with {}", gathering_.rover, gathering_.condition);
  }

  const Plan& plan_;
  const MissionFiles& mission_;
  Gathering& gathering_;
  Faults& faults_;
};

}  // namespace

std::vector<std::string> rover_ids(const Plan& plan) {
  std::vector<std::string> ids;
  for (const PlanRover& rover : plan.rovers) ids.push_back(rover.id);
  return ids;
}

void check_gatherings(const MissionFiles& mission, Study& study, Faults& faults) {
  std::map<std::string, Place> known;
  for (Gathering& gathering : study.gathered) {
    GatheringCheck(mission, gathering, faults).run();
    const auto [first, is_new] = known.emplace(gathering.name, gathering.place);
    if (is_new) continue;
    faults.error(gathering.place,
                 fmt::format("gather: '{}' is gathered already, see {}; 'name' "
                             "says another",
                             gathering.name, line_text(first->second, gathering.place.file)));
  }
}

}  // namespace lsos
