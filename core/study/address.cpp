#include "study/address.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "edit/event_names.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

constexpr const char* place_name = "Place";
constexpr std::string_view mission_prefix = "MissionInfo.", soil_prefix = "Soil.",
                           rover_prefix = "Rover ", asset_prefix = "Asset ";
// What makes a plan that plan, and is no value of it.
constexpr std::array<std::string_view, 6> fixed{"RoverId", "Sequence", "AssetId",
                                                "Planet",  "CaseOf",   "Type"};

constexpr const char* examples =
    "addresses are such as 'SEV1/20.Speed', 'MissionInfo.StartTime', 'Rover SEV1.InitialCharge', "
    "'Rover SEV1.battery.capacity_j', 'Soil.cohesion_pa' or 'SEV1/20.Place'";

Parsed<Address> refused(std::string why) { return {{}, std::move(why)}; }

// Keys of scripts begin with a small letter, fields of plans with a capital.
bool is_key(std::string_view name) {
  return !name.empty() && std::islower(static_cast<unsigned char>(name.front())) != 0;
}

// The name of which `text` begins with "NAME.", the longest one; names may have points in them.
std::optional<std::string> owner_in(std::string_view text, const std::vector<std::string>& names) {
  std::optional<std::string> found;
  for (const std::string& name : names) {
    const bool begins = text.starts_with(name) && text.substr(name.size()).starts_with('.');
    if (begins && (!found || name.size() > found->size())) found = name;
  }
  return found;
}

Parsed<Address> with_field(Address address, const std::string& name, bool may_have_place,
                           const Plan& plan, const Declarations& declarations) {
  const std::string type = type_of(address, plan);
  address.name = name;
  if (may_have_place && name == place_name) {
    address.what = Address::What::place;
    return {address, ""};
  }
  std::vector<std::string> names;
  for (const auto& list : fields_of(type, declarations)) {
    for (const FieldDeclaration& field : list) {
      if (std::ranges::find(fixed, field.name) == fixed.end()) names.push_back(field.name);
    }
  }
  if (may_have_place) names.emplace_back(place_name);
  if (std::ranges::count(names, name) > 0) return {address, ""};
  if (std::ranges::find(fixed, name) != fixed.end()) {
    return refused(
        fmt::format("{} of {} stays as it is drawn: it says what the Placemark is", name, type));
  }
  const std::string hint = did_you_mean(name, names);
  return refused(fmt::format("{} has no field '{}'{}", type, name,
                             hint.empty() ? "; there are " + listed(names) : hint));
}

Parsed<Address> of_event(const PlanEvent& event, const std::string& name, const Plan& plan,
                         const Declarations& declarations) {
  Address address;
  address.of = Address::Of::event;
  address.id = event.rover_id;
  address.sequence = event.sequence;
  return with_field(address, name, event.geometry.kind != GeometryKind::none, plan, declarations);
}

Parsed<Address> of_thing(Address::Of of, std::string_view rest, const std::vector<std::string>& ids,
                         const Plan& plan, const Declarations& declarations) {
  const char* noun = of == Address::Of::rover ? "rover" : "asset";
  const std::optional<std::string> id = owner_in(rest, ids);
  if (!id) {
    const std::string wanted(rest.substr(0, rest.find('.')));
    return refused(
        fmt::format("the plan has no {} '{}'{}", noun, wanted, did_you_mean(wanted, ids)));
  }
  Address address;
  address.of = of;
  address.id = *id;
  const std::string name(rest.substr(id->size() + 1));
  if (of == Address::Of::rover && is_key(name)) {
    address.what = Address::What::script_key;
    address.name = name;
    return {address, ""};
  }
  return with_field(address, name, true, plan, declarations);
}

template <class Thing>
std::vector<std::string> ids_of(const std::vector<Thing>& things) {
  std::vector<std::string> ids;
  for (const Thing& thing : things) ids.push_back(thing.id);
  return ids;
}

Parsed<Address> of_named_event(const std::string& text, const Plan& plan,
                               const Declarations& declarations) {
  const std::size_t point = text.rfind('.');
  if (point == std::string::npos) return refused(fmt::format("says no field; {}", examples));
  const std::string owner = text.substr(0, point), name = text.substr(point + 1);
  const EventNames events(plan);
  const std::vector<const PlanEvent*> meant = events.meanings(owner);
  if (meant.size() == 1) return of_event(*meant.front(), name, plan, declarations);
  if (meant.size() > 1) {
    return refused(
        fmt::format("{} events are called '{}'; ROVER/SEQUENCE says which", meant.size(), owner));
  }
  std::vector<std::string> known{"MissionInfo"};
  for (const PlanEvent& event : plan.events) {
    known.push_back(reference_text(reference_to(event)));
    known.push_back(event.label);
  }
  for (const PlanRover& rover : plan.rovers) known.push_back("Rover " + rover.id);
  for (const PlanAsset& asset : plan.assets) known.push_back("Asset " + asset.id);
  const std::string hint = did_you_mean(owner, known);
  return refused(fmt::format("the plan has no event '{}'{}", owner,
                             hint.empty() ? fmt::format("; {}", examples) : hint));
}

}  // namespace

std::string Address::text() const {
  switch (of) {
    case Of::mission:
      return std::string(mission_prefix) + name;
    case Of::soil:
      return std::string(soil_prefix) + name;
    case Of::rover:
      return fmt::format("{}{}.{}", rover_prefix, id, name);
    case Of::asset:
      return fmt::format("{}{}.{}", asset_prefix, id, name);
    case Of::event:
      break;
  }
  return fmt::format("{}/{}.{}", id, sequence, name);
}

Parsed<Address> parse_address(const std::string& text, const Plan& plan,
                              const Declarations& declarations) {
  if (text.starts_with(mission_prefix)) {
    return with_field({}, text.substr(mission_prefix.size()), false, plan, declarations);
  }
  if (text.starts_with(soil_prefix)) {
    Address address;
    address.of = Address::Of::soil;
    address.what = Address::What::script_key;
    address.name = text.substr(soil_prefix.size());
    return {address, ""};
  }
  if (text.starts_with(rover_prefix)) {
    return of_thing(Address::Of::rover, std::string_view(text).substr(rover_prefix.size()),
                    ids_of(plan.rovers), plan, declarations);
  }
  if (text.starts_with(asset_prefix)) {
    return of_thing(Address::Of::asset, std::string_view(text).substr(asset_prefix.size()),
                    ids_of(plan.assets), plan, declarations);
  }
  return of_named_event(text, plan, declarations);
}

std::string type_of(const Address& address, const Plan& plan) {
  switch (address.of) {
    case Address::Of::mission:
    case Address::Of::soil:
      return "MissionInfo";
    case Address::Of::rover:
      return "Rover";
    case Address::Of::asset:
      return "Asset";
    case Address::Of::event:
      break;
  }
  const auto event = std::ranges::find_if(plan.events, [&](const PlanEvent& each) {
    return each.rover_id == address.id && each.sequence == address.sequence;
  });
  LSOS_ASSERT(event != plan.events.end());
  return event->type;
}

const FieldDeclaration& field_of(const Address& address, const Plan& plan,
                                 const Declarations& declarations) {
  const FieldDeclaration* found = nullptr;
  for (const auto& list : fields_of(type_of(address, plan), declarations)) {
    for (const FieldDeclaration& field : list) {
      if (field.name == address.name) found = &field;
    }
  }
  LSOS_ASSERT(found != nullptr);
  return *found;
}

}  // namespace lsos
