// A value of a log column as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "record/columns.h"

namespace lsos {

// null where the log has NULL. The library writes numbers that are not finite as null, too.
inline nlohmann::ordered_json json_value(const ColumnValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return *whole;
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return nullptr;
}

}  // namespace lsos
