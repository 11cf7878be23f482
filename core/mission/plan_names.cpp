#include "mission/plan_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "plan/suggestions.h"

namespace lsos {

namespace {

template <class Things>
std::vector<std::string> names_of(const Things& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.push_back(thing.name);
  return names;
}

std::vector<AntennaSpec> stowable(const RoverModel& rover) {
  std::vector<AntennaSpec> antennas;
  std::ranges::copy_if(rover.antennas, std::back_inserter(antennas), &AntennaSpec::is_stowable);
  return antennas;
}

// What a field may name, and whose that is, as messages say it.
struct Known {
  std::string owner, what;
  std::vector<std::string> names;
  bool are_all = false;  // false: faults of the plan keep others from being read
};

// "" too when it may be there without being known.
std::string fault_of(const Known& known, const std::string& name) {
  if (std::ranges::find(known.names, name) != known.names.end()) return "";
  if (!known.are_all) return "";
  if (known.names.empty()) return fmt::format("{} has no {}", known.owner, known.what);
  std::string hint = name.size() > 100 ? "" : did_you_mean(name, known.names);
  if (hint.empty()) hint = fmt::format("; it has {}", listed(known.names));
  return fmt::format("{} has no {} of that name{}", known.owner, known.what, hint);
}

}  // namespace

void check_plan_names(const Plan& plan, const Declarations& declarations,
                      const std::map<std::string, RoverModel>& rovers,
                      const std::map<std::string, AssetModel>& assets, Faults& faults) {
  std::vector<std::string> with_power;
  bool is_power_known = plan.gaps.unread_ids.empty() && !plan.gaps.asset_ids;
  for (const PlanAsset& asset : plan.assets) {
    const auto model = assets.find(asset.type);
    // One whose type or script has a fault may have power to give.
    if (model == assets.end()) {
      is_power_known = false;
      continue;
    }
    if (model->second.supply_w > 0 || !model->second.panels.empty()) with_power.push_back(asset.id);
  }
  const auto others = [&](const std::string& rover_id) {
    std::vector<std::string> ids;
    for (const PlanRover& other : plan.rovers) {
      if (other.id != rover_id && !other.id.empty()) ids.push_back(other.id);
    }
    for (const PlanAsset& asset : plan.assets) ids.push_back(asset.id);
    ids.insert(ids.end(), plan.gaps.unread_ids.begin(), plan.gaps.unread_ids.end());
    return ids;
  };
  for (const PlanEvent& event : plan.events) {
    const PlanRover* rover = rover_of(plan, event.rover_id);
    const auto model = rover == nullptr ? rovers.end() : rovers.find(rover->type);
    const auto known = [&](NameOf names) -> Known {
      if (names == NameOf::power_source) {
        if (!is_power_known) return {};
        return {"the plan", "asset with power to give", with_power, true};
      }
      if (names == NameOf::other) {
        return {"the plan", "other rover or asset", others(event.rover_id), !plan.gaps.has_ids()};
      }
      if (model == rovers.end()) return {};
      const PowerSpec& power = model->second.power;
      if (names == NameOf::panel) return {rover->type, "panel", names_of(power.panels), true};
      if (names == NameOf::resource) {
        return {rover->type, "resource", names_of(power.resources), true};
      }
      return {rover->type, "stowable antenna", names_of(stowable(model->second)), true};
    };
    for (const FieldDeclaration& field : declarations.events.at(event.type).fields) {
      const auto value = event.params.find(field.key);
      if (field.names == NameOf::anything || value == event.params.end()) continue;
      const auto& name = std::get<std::string>(value->second);
      const std::string fault = fault_of(known(field.names), name);
      if (fault.empty()) continue;
      faults.error(event.place, fmt::format("{} '{}': {} = {}: {}", event.type, event.label,
                                            field.name, quoted(name), fault));
    }
  }
}

}  // namespace lsos
