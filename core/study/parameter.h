// What varies in a study, once its plan is read: where its values go, and how they are drawn.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/units.h"
#include "base/vector.h"
#include "study/address.h"
#include "study/distribution.h"
#include "study/sampling.h"
#include "study/study.h"

namespace lsos {

// How numbers of a parameter are written.
struct NumberStyle {
  const FieldDeclaration* field = nullptr;  // nullptr: it is a key of a script
  const Unit* unit = nullptr;               // of a bare number; nullptr: its numbers have none
  bool is_utc = false;                      // numbers are seconds since `origin`
  std::optional<Instant> origin = {};
};

struct Parameter {
  Variation variation;
  Address address;
  NumberStyle style;
  std::vector<std::string> choices;          // of a list or range, as the plan has them
  std::optional<Distribution> distribution;  // in SI
  double radius_m = 0;                       // of a place
  double base_si = 1;                        // what a factor multiplies

  std::string name() const { return address.text(); }
  bool is_place() const { return address.what == Address::What::place; }
  std::vector<Dimension> dimensions() const;
};

// What parameters are made with. `base_of`: the number that an address has in the plan, in SI;
// absent where it has none. `unit_of_key`: the unit in the name of a script's key; nullptr: none.
struct ParameterContext {
  const Plan& plan;
  const Declarations& declarations;
  std::function<std::optional<double>(const Address&)> base_of;
  std::function<const Unit*(const std::string& key)> unit_of_key;
};

// The parameters of a study; faults of addresses, kinds, units and ranges at their lines.
std::vector<Parameter> parameters_of(const Study& study, const ParameterContext& context,
                                     Faults& faults);

// What a case has in place of the plan's own.
struct Draw {
  Address address;
  std::string text;     // as the plan has it; "" of a place
  Vec2 offset_m{0, 0};  // of a place: how far it is moved east and north
  // Columns of the study: name and value in SI. A place has two.
  using Value = std::variant<bool, std::int64_t, double, std::string>;
  std::vector<std::pair<std::string, Value>> values;
};

// `shares`: by dimension, see Sampler.
Draw draw(const Parameter& parameter, const std::map<std::string, double>& shares);
std::vector<Draw> draws(const std::vector<Parameter>& parameters,
                        const std::map<std::string, double>& shares);

}  // namespace lsos
