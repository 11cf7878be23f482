#include "product/comparison/measured_quantity.h"

#include <cmath>
#include <numbers>

#include "record/column_titles.h"
#include "record/layers.h"

namespace lsos {

namespace {

// The SI unit that a column's name ends in; "charge" ends in none and is a fraction.
const Unit* unit_of_name(std::string_view name) {
  const Unit* found = find_unit("1");
  for (const Unit& unit : all_units()) {
    if (unit.suffix.empty() || unit.si_factor != 1) continue;
    const bool is_longer = found->suffix.size() < unit.suffix.size();
    if (is_longer && name.ends_with("_" + std::string(unit.suffix))) found = &unit;
  }
  return found;
}

MeasuredQuantity quantity_of(std::string_view name, const Quantity* logged, int axis) {
  MeasuredQuantity quantity{
      std::string(name), std::string(name), {}, unit_of_name(name), logged, axis};
  const std::string_view suffix = quantity.unit->suffix;
  if (!suffix.empty()) quantity.base.resize(name.size() - suffix.size() - 1);
  quantity.title = column_title(layer_name<SampleRow>, name).title;
  return quantity;
}

}  // namespace

double MeasuredQuantity::value(const SampleRow& row) const {
  return logged != nullptr ? row.*logged->value : row.p_S_m[axis];
}

const std::vector<MeasuredQuantity>& measured_quantities() {
  static const std::vector<MeasuredQuantity> all = [] {
    std::vector<MeasuredQuantity> list;
    for (const Quantity& quantity : quantities()) {
      list.push_back(quantity_of(quantity.name, &quantity, -1));
    }
    for (int axis = 0; axis < 3; ++axis) {
      constexpr std::string_view names[] = {"x_m", "y_m", "z_m"};
      list.push_back(quantity_of(names[axis], nullptr, axis));
    }
    return list;
  }();
  return all;
}

double difference(const MeasuredQuantity& quantity, double a, double b) {
  return quantity.is_angle() ? std::remainder(a - b, 2 * std::numbers::pi) : a - b;
}

}  // namespace lsos
