// Residuals as text for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "product/comparison/residuals.h"

namespace lsos {

std::string to_text(const Residuals& found, const Telemetry& telemetry, const std::string& run);
std::string to_json(const Residuals& found, const Telemetry& telemetry, const std::string& run);

// The residuals by rover, quantity and event, as to_json has them.
nlohmann::ordered_json summaries_json(const Residuals& found);

}  // namespace lsos
