#include "record/quantities.h"

#include <algorithm>

namespace lsos {

std::span<const Quantity> quantities() { return quantity_table; }

const Quantity* find_quantity(std::string_view name) {
  const auto* const found = std::ranges::find(quantity_table, name, &Quantity::name);
  return found == quantity_table.end() ? nullptr : found;
}

}  // namespace lsos
