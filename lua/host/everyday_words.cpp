#include "lua/host/everyday_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "lua/host/condition.h"

namespace lsos {

namespace {

struct Meaning {
  std::string_view word, quantity;
};
constexpr std::array meanings{
    Meaning{"battery", "charge"},
    Meaning{"battery_charge", "charge"},
    Meaning{"battery_level", "charge"},
    Meaning{"soc", "charge"},
    Meaning{"state_of_charge", "charge"},
    Meaning{"charge_level", "charge"},
    Meaning{"energy", "energy_j"},
    Meaning{"battery_energy", "energy_j"},
    Meaning{"power", "energy_rate_w"},
    Meaning{"energy_rate", "energy_rate_w"},
    Meaning{"solar", "solar_w"},
    Meaning{"solar_power", "solar_w"},
    Meaning{"load", "load_w"},
    Meaning{"loads", "load_w"},
    Meaning{"drive_power", "drive_w"},
    Meaning{"loss", "loss_w"},
    Meaning{"sun", "sun_fraction"},
    Meaning{"sunlight", "sun_fraction"},
    Meaning{"light", "sun_fraction"},
    Meaning{"lit", "sun_fraction"},
    Meaning{"shadow", "sun_fraction"},
    Meaning{"speed", "speed_mps"},
    Meaning{"velocity", "speed_mps"},
    Meaning{"v", "speed_mps"},
    Meaning{"distance", "distance_m"},
    Meaning{"driven", "distance_m"},
    Meaning{"odometer", "distance_m"},
    Meaning{"odometry", "distance_m"},
    Meaning{"slope", "slope_rad"},
    Meaning{"gradient", "slope_rad"},
    Meaning{"steepness", "slope_rad"},
    Meaning{"tilt", "slope_rad"},
    Meaning{"roll", "roll_rad"},
    Meaning{"pitch", "pitch_rad"},
    Meaning{"heading", "heading_rad"},
    Meaning{"yaw", "heading_rad"},
    Meaning{"course", "heading_rad"},
    Meaning{"bearing", "heading_rad"},
    Meaning{"slippage", "slip"},
    Meaning{"wheel_slip", "slip"},
    Meaning{"max_slip", "slip_max"},
    Meaning{"sinkage", "sinkage_m"},
    Meaning{"sink", "sinkage_m"},
    Meaning{"elevation", "elevation_m"},
    Meaning{"height", "elevation_m"},
    Meaning{"altitude", "elevation_m"},
    Meaning{"alt", "elevation_m"},
    Meaning{"time", "time_s"},
    Meaning{"t", "time_s"},
    Meaning{"elapsed", "time_s"},
    Meaning{"mission_time", "time_s"},
    Meaning{"lon", "lon_deg"},
    Meaning{"longitude", "lon_deg"},
    Meaning{"lat", "lat_deg"},
    Meaning{"latitude", "lat_deg"},
    Meaning{"x", "x_m"},
    Meaning{"y", "y_m"},
    Meaning{"z", "z_m"},
    Meaning{"range", "distance_to"},
    Meaning{"distance_from", "distance_to"},
    Meaning{"near", "distance_to"},
    Meaning{"visible", "sees"},
    Meaning{"visibility", "sees"},
    Meaning{"can_see", "sees"},
    Meaning{"in_sight", "sees"},
    Meaning{"link", "is_linked_to"},
    Meaning{"linked", "is_linked_to"},
    Meaning{"comms", "is_linked_to"},
    Meaning{"connected", "is_linked_to"},
};

// A unit at the end of a word, the quantity's own unit, and the conversion between the two.
struct Suffix {
  std::string_view suffix, own, conversion;
};
constexpr std::array suffixes{
    Suffix{"_deg", "_rad", "math.rad(20) is 20 deg"},
    Suffix{"_kmh", "_mps", "5 / 3.6 is 5 km/h"},
    Suffix{"_kmph", "_mps", "5 / 3.6 is 5 km/h"},
    Suffix{"_kph", "_mps", "5 / 3.6 is 5 km/h"},
    Suffix{"_ms", "_mps", ""},
    Suffix{"_km", "_m", "1000 is 1 km"},
    Suffix{"_h", "_s", "3600 is 1 h"},
    Suffix{"_hours", "_s", "3600 is 1 h"},
    Suffix{"_min", "_s", "60 is 1 min"},
    Suffix{"_d", "_s", "86400 is 1 d"},
    Suffix{"_kwh", "_j", "3.6e6 is 1 kWh"},
    Suffix{"_wh", "_j", "3600 is 1 Wh"},
    Suffix{"_kw", "_w", "1000 is 1 kW"},
    Suffix{"_percent", "", "0.8 is 80 %"},
    Suffix{"_pct", "", "0.8 is 80 %"},
};

constexpr std::array<std::string_view, 5> shares{"charge", "slip", "slip_max", "sun_fraction",
                                                 "incidence"};

bool is_share(std::string_view quantity) {
  return std::ranges::find(shares, quantity) != shares.end();
}

std::string_view meaning_of(std::string_view word) {
  const auto found = std::ranges::find(meanings, word, &Meaning::word);
  if (found != meanings.end()) return found->quantity;
  const auto& names = condition_names();
  const auto known = std::ranges::find_if(
      names, [&](const ConditionName& name) { return std::string_view(name.name) == word; });
  return known == names.end() ? std::string_view() : std::string_view(known->name);
}

// Conversion from the unit in which people are likely to think to the quantity's unit.
std::string_view usual_conversion(std::string_view quantity) {
  for (const std::string_view suffix : {"_deg", "_kmh", "_kwh"}) {
    const auto found = std::ranges::find(suffixes, suffix, &Suffix::suffix);
    if (quantity.ends_with(found->own)) return found->conversion;
  }
  return "";
}

std::string hint(std::string_view quantity, std::string_view conversion) {
  const auto& names = condition_names();
  const auto known = std::ranges::find_if(
      names, [&](const ConditionName& name) { return std::string_view(name.name) == quantity; });
  std::string doc = known->doc;
  if (doc.starts_with(quantity)) doc.erase(0, doc.find(": ") + 2);  // drop a question's own name
  if (!conversion.empty()) doc += fmt::format("; {}", conversion);
  return fmt::format("; did you mean '{}' ({})?", quantity, doc);
}

}  // namespace

std::string everyday_word_hint(const std::string& word) {
  std::string small(word);
  std::ranges::transform(small, small.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (const std::string_view quantity = meaning_of(small); !quantity.empty()) {
    return hint(quantity, usual_conversion(quantity));
  }
  for (const Suffix& each : suffixes) {
    if (!small.ends_with(each.suffix)) continue;
    const std::string base = small.substr(0, small.size() - each.suffix.size());
    std::string_view quantity = meaning_of(base + std::string(each.own));
    if (quantity.empty()) quantity = meaning_of(base);
    // Percents are of the battery's charge and kWh of its energy, whichever word is used.
    if (each.own.empty() && quantity == "energy_j") quantity = "charge";
    if (each.own == "_j" && quantity == "charge") quantity = "energy_j";
    const bool is_of_unit = each.own.empty() ? is_share(quantity) : quantity.ends_with(each.own);
    if (!quantity.empty() && is_of_unit) return hint(quantity, each.conversion);
  }
  return "";
}

}  // namespace lsos
