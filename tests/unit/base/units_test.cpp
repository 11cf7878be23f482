#include "base/units.h"

#include <gmock/gmock.h>

#include <clocale>
#include <map>
#include <numbers>
#include <set>
#include <string>

namespace lsos {
namespace {

using ::testing::HasSubstr;

const Unit& unit(std::string_view symbol) {
  const Unit* found = find_unit(symbol);
  EXPECT_NE(found, nullptr) << symbol;
  return found != nullptr ? *found : *find_unit("1");
}

double quantity(std::string_view text, std::string_view symbol) {
  const Parsed<double> parsed = parse_quantity(text, unit(symbol));
  EXPECT_TRUE(parsed) << text << ": " << parsed.why;
  return parsed.value.value_or(-1e300);
}

std::string why(std::string_view text, std::string_view symbol) {
  const Parsed<double> parsed = parse_quantity(text, unit(symbol));
  EXPECT_FALSE(parsed) << text;
  return parsed.why;
}

TEST(Units, symbols_are_unique_and_one_kind_has_one_suffix) {
  std::set<std::string_view> symbols;
  std::map<std::string_view, std::string_view> suffix_of_kind;
  for (const Unit& u : all_units()) {
    EXPECT_TRUE(symbols.insert(u.symbol).second) << u.symbol;
    EXPECT_EQ(suffix_of_kind.emplace(u.kind, u.suffix).first->second, u.suffix) << u.symbol;
    EXPECT_GT(u.si_factor, 0) << u.symbol;
  }
}

TEST(Units, unknown_symbol_is_not_found) {
  EXPECT_EQ(find_unit("furlong"), nullptr);
  EXPECT_EQ(find_unit(""), nullptr);
}

TEST(Units, convert_as_defined) {
  EXPECT_DOUBLE_EQ(quantity("10 km/h", "m/s"), 10.0 / 3.6);
  EXPECT_DOUBLE_EQ(quantity("20 cm", "m"), 0.2);
  EXPECT_DOUBLE_EQ(quantity("35cm", "m"), 0.35);
  EXPECT_DOUBLE_EQ(quantity("1 ft", "m"), 0.3048);
  EXPECT_DOUBLE_EQ(quantity("2 kW", "W"), 2000);
  EXPECT_DOUBLE_EQ(quantity("1.5h", "s"), 5400);
  EXPECT_DOUBLE_EQ(quantity("2 d", "s"), 172800);
  EXPECT_DOUBLE_EQ(quantity("180 deg", "rad"), std::numbers::pi);
  EXPECT_DOUBLE_EQ(quantity("1 kWh", "J"), 3.6e6);
  EXPECT_DOUBLE_EQ(quantity("80%", "1"), 0.8);
  EXPECT_DOUBLE_EQ(quantity("80 %", "1"), 0.8);
  EXPECT_DOUBLE_EQ(quantity("100 ms", "s"), 0.1);
  EXPECT_DOUBLE_EQ(quantity("3 N m", "N m"), 3);
}

TEST(Units, bare_number_is_in_the_units_own_measure) {
  EXPECT_DOUBLE_EQ(quantity("90", "deg"), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(quantity("-3e2", "m"), -300);
  EXPECT_DOUBLE_EQ(quantity("+5", "km"), 5000);
  EXPECT_DOUBLE_EQ(quantity(" \t 2.5 \n", "s"), 2.5);
}

TEST(Units, durations_are_read_as_iso_8601) {
  EXPECT_DOUBLE_EQ(quantity("PT1H30M", "s"), 5400);
  EXPECT_DOUBLE_EQ(quantity("P2DT3H", "s"), 2 * 86400 + 3 * 3600);
  EXPECT_DOUBLE_EQ(quantity("P1W", "h"), 604800);
  EXPECT_DOUBLE_EQ(quantity("PT0.5S", "s"), 0.5);
  EXPECT_DOUBLE_EQ(quantity("PT1,5H", "s"), 5400);
  EXPECT_DOUBLE_EQ(quantity("PT36H", "s"), 129600);
}

TEST(Units, malformed_iso_durations_are_refused) {
  for (const char* text : {"P", "PT", "P1DT", "P1", "PT1", "P1Y", "P2M", "PT1M1H", "P1H", "PT1D",
                           "PT1.5H2M", "PT1H1H", "P-1D", "PT1..5S", "P1D ", "PTS", "P1DTT1H"}) {
    const Parsed<double> parsed = parse_quantity(text, unit("s"));
    if (std::string_view(text) == "P1D ") {
      EXPECT_TRUE(parsed) << "blanks around a value do not count";
    } else {
      EXPECT_THAT(parsed.why, HasSubstr("is no ISO 8601 duration")) << text;
    }
  }
}

TEST(Units, refusals_say_what_was_found_and_what_is_allowed) {
  EXPECT_EQ(why("fast", "m/s"), "'fast' is no number; a speed is allowed, such as '2 m/s'");
  EXPECT_EQ(why("3 kg", "m/s"), "'kg' is a unit of mass; a speed is allowed, such as '2 m/s'");
  EXPECT_EQ(why("3 kmh", "m/s"),
            "there is no unit 'kmh'; units of speed are m/s, km/h, cm/s, mm/s; did you mean "
            "'km/h'?");
  EXPECT_EQ(why("30 m", "s"),
            "'m' is a unit of length; a duration is allowed, such as '90 s', '1.5 h' or 'PT1H30M'");
  EXPECT_EQ(why("1,5", "m"), "'1,5' has a comma; a decimal point is allowed");
  EXPECT_THAT(why("", "rad"), HasSubstr("there is no text; an angle is allowed"));
  EXPECT_THAT(why("x", "1"), HasSubstr("a fraction is allowed"));
}

TEST(Units, infinite_and_undefined_values_are_refused) {
  for (const char* text : {"inf", "-inf", "nan", "infinity", "1e999", "1e308 km"}) {
    EXPECT_FALSE(parse_quantity(text, unit("m"))) << text;
  }
}

TEST(Units, numbers_do_not_depend_on_the_locale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    std::setlocale(LC_ALL, locale);
    EXPECT_DOUBLE_EQ(quantity("1.5", "m"), 1.5);
    EXPECT_EQ(format_quantity(1.5, unit("m")), "1.5 m");
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Units, whole_numbers) {
  EXPECT_EQ(parse_integer(" -42 ").value, -42);
  EXPECT_EQ(parse_integer("+7").value, 7);
  EXPECT_EQ(parse_integer("9223372036854775807").value, INT64_MAX);
  EXPECT_EQ(parse_integer("1.5").why, "'1.5' is no whole number");
  EXPECT_EQ(parse_integer("").why, "'' is no whole number");
  EXPECT_EQ(parse_integer("+-3").why, "'+-3' is no whole number");
  EXPECT_THAT(parse_integer("9223372036854775808").why, HasSubstr("outside"));
}

TEST(Units, booleans) {
  EXPECT_EQ(parse_boolean("true").value, true);
  EXPECT_EQ(parse_boolean(" 1 ").value, true);
  EXPECT_EQ(parse_boolean("false").value, false);
  EXPECT_EQ(parse_boolean("0").value, false);
  EXPECT_EQ(parse_boolean("yes").why,
            "'yes' is neither true nor false; true, false, 1, 0 are allowed");
}

TEST(Units, formatted_quantities_are_short) {
  EXPECT_EQ(format_quantity(0.05, unit("m/s")), "0.05 m/s");
  EXPECT_EQ(format_quantity(2.5 / 3.6, unit("km/h")), "2.5 km/h");
  EXPECT_EQ(format_quantity(86400 * 366.0, unit("d")), "366 d");
  EXPECT_EQ(format_quantity(86400, unit("s")), "86400 s");
  EXPECT_EQ(format_quantity(std::numbers::pi / 6, unit("deg")), "30 deg");
  EXPECT_EQ(format_quantity(0.25, unit("1")), "0.25");
  EXPECT_EQ(format_quantity(0, unit("m")), "0 m");
}

TEST(Units, formatted_quantities_read_back_equal) {
  for (const Unit& u : all_units()) {
    for (double value_si = 1e-3; value_si < 1e7; value_si *= 7.3) {
      const Parsed<double> back = parse_quantity(format_quantity(value_si, u), u);
      ASSERT_TRUE(back) << u.symbol << ": " << back.why;
      EXPECT_DOUBLE_EQ(*back.value, value_si) << u.symbol;
    }
  }
}

}  // namespace
}  // namespace lsos
