// What a study varies, by its address in a plan: "SEV1/20.Speed", "MissionInfo.StartTime",
// "Rover SEV1.battery.capacity_j", "Soil.cohesion_pa", "SEV1/20.Place".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/parsed.h"
#include "plan/plan.h"

namespace lsos {

struct Address {
  enum class Of { mission, soil, rover, asset, event };
  enum class What { field, script_key, place };

  Of of = Of::mission;
  std::string id;             // of a rover or an asset; of an event, its rover's
  std::int64_t sequence = 0;  // of an event
  What what = What::field;
  std::string name;  // of the field; or the key "battery.capacity_j" of the script

  bool operator==(const Address&) const = default;

  // The one form of each address: events by ROVER/SEQUENCE.
  std::string text() const;
};

// Finds in the plan what `text` addresses; an event also by its label: "Leg 2.Speed".
Parsed<Address> parse_address(const std::string& text, const Plan& plan,
                              const Declarations& declarations);

// What the Placemark of the address is called in the catalog: "MissionInfo", "Rover", "Route".
std::string type_of(const Address& address, const Plan& plan);

// The declaration of an address of a field.
const FieldDeclaration& field_of(const Address& address, const Plan& plan,
                                 const Declarations& declarations);

}  // namespace lsos
