#include "terrain/raster/length_unit.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace lsos {

namespace {

struct LengthUnit {
  std::array<std::string_view, 8> names;  // the first is for messages
  double metres;
};

// The foot of 1959 is 0.3048 m; the US survey foot of maps before 2023 is 1200/3937 m.
constexpr std::array units{
    LengthUnit{{"m", "metre", "meter", "metres", "meters", "mtr"}, 1},
    LengthUnit{{"km", "kilometre", "kilometer", "kilometres", "kilometers"}, 1000},
    LengthUnit{{"dm", "decimetre", "decimeter", "decimetres", "decimeters"}, 0.1},
    LengthUnit{{"cm", "centimetre", "centimeter", "centimetres", "centimeters"}, 0.01},
    LengthUnit{{"mm", "millimetre", "millimeter", "millimetres", "millimeters"}, 0.001},
    LengthUnit{{"ft", "foot", "feet", "international foot", "intl foot", "foot_intl"}, 0.3048},
    LengthUnit{{"us-ft", "us survey foot", "us survey feet", "ftus", "foot_us", "us_survey_foot",
                "us foot", "survey foot"},
               1200.0 / 3937},
};

std::string plain(std::string_view name) {
  const auto is_space = [](unsigned char c) { return std::isspace(c) != 0; };
  while (!name.empty() && is_space(name.front())) name.remove_prefix(1);
  while (!name.empty() && is_space(name.back())) name.remove_suffix(1);
  std::string text(name);
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::optional<double> length_unit_m(std::string_view name) {
  const std::string wanted = plain(name);
  if (wanted.empty()) return {};
  for (const LengthUnit& unit : units) {
    if (std::ranges::count(unit.names, wanted) > 0) return unit.metres;
  }
  return {};
}

bool is_no_unit(std::string_view name) {
  constexpr std::array<std::string_view, 6> none{"", "unknown", "none", "n/a", "-", "unspecified"};
  return std::ranges::count(none, plain(name)) > 0;
}

std::vector<std::string> length_unit_names() {
  std::vector<std::string> names;
  for (const LengthUnit& unit : units) names.emplace_back(unit.names[0]);
  return names;
}

}  // namespace lsos
