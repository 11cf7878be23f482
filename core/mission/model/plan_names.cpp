#include "mission/model/plan_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "mission/model/foreseen.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

template <class Things>
std::vector<std::string> names_of(const Things& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.push_back(thing.name);
  return names;
}

template <class Things, class Is>
std::vector<std::string> names_if(const Things& things, Is is) {
  Things chosen;
  std::ranges::copy_if(things, std::back_inserter(chosen), is);
  return names_of(chosen);
}

// Names that a field may have, and whose they are, as messages say it.
struct Known {
  std::string owner = {}, what = {};
  std::vector<std::string> names = {};
  bool are_all = false;                 // false: faults of the plan keep others from being read
  bool means_all = false;               // a field left out means all of them
  std::vector<std::string> unfit = {};  // exist, but do not suit the field
  std::string fitness = {};             // " that can be stowed"
  std::string unfitness = {};           // "it is an asset"; "": the fitness says it
};

std::string no_text(const Known& known) {
  return fmt::format("{} has no {}{}", known.owner, known.what,
                     known.unfit.empty() ? "" : known.fitness);
}

// Fault of a name; "" also when it may exist without being known.
std::string name_fault(const Known& known, const std::string& name) {
  if (std::ranges::find(known.names, name) != known.names.end()) return "";
  if (!known.are_all) return "";
  if (known.names.empty()) return no_text(known);
  const bool is_unfit = std::ranges::find(known.unfit, name) != known.unfit.end();
  if (is_unfit && !known.unfitness.empty()) return known.unfitness;
  std::string hint = name.size() > 100 || is_unfit ? "" : did_you_mean(name, known.names);
  if (hint.empty()) hint = fmt::format("; it has {}", listed(known.names));
  return fmt::format("{} has no {} of that name{}{}", known.owner, known.what,
                     is_unfit ? known.fitness : "", hint);
}

// Assets of the plan that have power to give. All are known but those that the plan's faults keep
// from being read.
Known power_sources(const Plan& plan, const std::map<std::string, AssetModel>& assets) {
  Known known{"the plan", "asset with power to give"};
  known.are_all = plan.gaps.unread_ids.empty() && !plan.gaps.asset_ids;
  for (const PlanAsset& asset : plan.assets) {
    const auto model = assets.find(asset.type);
    // An asset whose type or script has a fault may have power to give.
    if (model == assets.end()) {
      known.are_all = false;
      continue;
    }
    if (model->second.supply_w > 0 || !model->second.panels.empty()) {
      known.names.push_back(asset.id);
    }
  }
  return known;
}

Known others(const Plan& plan, const std::string& rover_id) {
  Known known{"the plan", "other rover or asset"};
  known.are_all = !plan.gaps.has_ids();
  for (const PlanRover& other : plan.rovers) {
    if (other.id != rover_id && !other.id.empty()) known.names.push_back(other.id);
  }
  for (const PlanAsset& asset : plan.assets) known.names.push_back(asset.id);
  known.names.insert(known.names.end(), plan.gaps.unread_ids.begin(), plan.gaps.unread_ids.end());
  return known;
}

// Rovers that another one may follow. It may name itself: that is a circle, see followings.h.
Known leaders(const Plan& plan) {
  Known known{"the plan", "rover"};
  known.are_all = !plan.gaps.has_ids();
  for (const PlanRover& rover : plan.rovers) {
    if (!rover.id.empty()) known.names.push_back(rover.id);
  }
  for (const PlanAsset& asset : plan.assets) known.unfit.push_back(asset.id);
  known.unfitness = "that is an asset, which does not drive";
  known.names.insert(known.names.end(), plan.gaps.unread_ids.begin(), plan.gaps.unread_ids.end());
  return known;
}

// Equipment of one kind that a rover of that type has.
Known equipment(const RoverModel& model, const std::string& type, NameOf names) {
  const std::vector<PanelSpec>& panels = model.power.panels;
  Known known{type, "", {}, true};
  switch (names) {
    case NameOf::panel:
      known.what = "panel";
      known.names = names_of(panels);
      break;
    case NameOf::stowable_panel:
      known.what = "panel";
      known.fitness = " that can be stowed";
      known.names = names_if(panels, &PanelSpec::is_stowable);
      known.means_all = true;
      known.unfit = names_of(panels);
      break;
    case NameOf::turning_panel:
      known.what = "panel";
      known.fitness = " that turns";
      known.names = names_if(panels, &PanelSpec::can_turn);
      known.means_all = true;
      known.unfit = names_of(panels);
      break;
    case NameOf::resource:
      known.what = "resource";
      known.names = names_of(model.power.resources);
      break;
    case NameOf::antenna:
      known.what = "stowable antenna";
      known.names = names_if(model.antennas, &AntennaSpec::is_stowable);
      known.means_all = true;
      known.unfit = names_of(model.antennas);
      break;
    case NameOf::stance:
      known.what = "stance";
      if (std::holds_alternative<Legged>(model.spec.suspension)) {
        known.names = names_if(model.spec.configurations, is_stance);
        known.unfit = names_of(model.spec.configurations);
        known.unfitness =
            "that configuration carries a payload, or sets modes of wheels: a rover can start in "
            "it, and not change to it";
      }
      break;
    default:
      break;
  }
  return known;
}

void check_names(const PlanEvent& event, const EventDeclaration& declaration,
                 const std::function<Known(NameOf)>& known_of, Faults& faults) {
  for (const FieldDeclaration& field : declaration.fields) {
    if (field.names == NameOf::anything) continue;
    const Known known = known_of(field.names);
    const auto value = event.params.find(field.key);
    if (value == event.params.end()) {
      const bool is_none = known.means_all && known.are_all && known.names.empty();
      if (is_none && event.has_all_params && event.is_enabled) {
        faults.add({foreseen_failure(event, no_text(known))});
      }
      continue;
    }
    const auto& name = std::get<std::string>(value->second);
    const std::string fault = name_fault(known, name);
    if (fault.empty()) continue;
    faults.error(event.place, fmt::format("{} '{}': {} = {}: {}", event.type, event.label,
                                          field.name, quoted(name), fault));
  }
}

// Amounts left of a rover's resources after the events so far.
class Stores {
 public:
  explicit Stores(const std::vector<ResourceSpec>& resources) {
    for (const ResourceSpec& resource : resources) {
      stores_[resource.name] = {resource.amount, resource.amount, resource.unit};
    }
  }

  void use(const PlanEvent& event, const EventDeclaration& declaration, Faults& faults) {
    for (const FieldDeclaration& field : declaration.fields) {
      const auto amount = event.params.find(field.key);
      const auto name = event.params.find(field.amount_of);
      if (field.amount_of.empty() || amount == event.params.end() || name == event.params.end()) {
        continue;
      }
      const double wanted = std::get<double>(amount->second);
      use(event, fmt::format("{} = {:.6g}", field.name, wanted), wanted,
          std::get<std::string>(name->second), faults);
    }
  }

  void change(const PlanEvent& event, const ResourceChange& change, Faults& faults) {
    for (const auto& [name, amount] : change.used) {
      const auto store = stores_.find(name);
      if (store == stores_.end()) continue;
      use(event, "takes " + amount_text(amount, store->second), amount, name, faults);
    }
    for (const auto& [name, amount] : change.filled) {
      const auto store = stores_.find(name);
      if (store == stores_.end()) continue;
      store->second.left = std::min(store->second.left + amount, store->second.at_start);
    }
  }

 private:
  struct Store {
    double at_start = 0, left = 0;
    std::string unit;
  };

  static std::string amount_text(double amount, const Store& store) {
    return fmt::format("{:.6g}{}{}", amount, store.unit.empty() ? "" : " ", store.unit);
  }

  // `subject`: what is wanted, as messages tell it.
  void use(const PlanEvent& event, const std::string& subject, double amount,
           const std::string& name, Faults& faults) {
    const auto found = stores_.find(name);
    if (found == stores_.end()) return;
    Store& store = found->second;
    const double rounding = 1e-9 * store.at_start;
    if (amount > store.at_start + rounding) {
      faults.add({foreseen_failure(
          event, fmt::format("{}: more {} than is aboard at the start, {}", subject, name,
                             amount_text(store.at_start, store)))});
      return;
    }
    if (amount > store.left + rounding) {
      faults.warning(
          event.place,
          fmt::format("{} '{}': {}: more {} than is left, {} of {}, when the "
                      "events before it have taken theirs",
                      event.type, event.label, subject, name, amount_text(store.left, store),
                      amount_text(store.at_start, store)));
      return;
    }
    store.left -= amount;
  }

  std::map<std::string, Store> stores_;
};

}  // namespace

void check_plan_names(const Plan& plan, const Declarations& declarations,
                      const std::map<std::string, RoverModel>& rovers,
                      const std::map<std::string, AssetModel>& assets,
                      const ResourceChangeOf& change_of, Faults& faults) {
  const Known sources = power_sources(plan, assets);
  std::map<std::string, Stores> stores;  // key: RoverId
  for (const PlanEvent& event : plan.events) {
    const PlanRover* rover = rover_of(plan, event.rover_id);
    const auto model = rover == nullptr ? rovers.end() : rovers.find(rover->model());
    const auto known_of = [&](NameOf names) -> Known {
      if (names == NameOf::power_source) return Known(sources);
      if (names == NameOf::leader) return leaders(plan);
      if (names == NameOf::other) return others(plan, event.rover_id);
      return model == rovers.end() ? Known{} : equipment(model->second, rover->type, names);
    };
    const EventDeclaration& declaration = declarations.events.at(event.type);
    check_names(event, declaration, known_of, faults);
    if (model == rovers.end() || !event.is_enabled) continue;
    Stores& aboard =
        stores.try_emplace(event.rover_id, model->second.power.resources).first->second;
    aboard.use(event, declaration, faults);
    if (event.has_all_params) aboard.change(event, change_of(event), faults);
  }
}

}  // namespace lsos
