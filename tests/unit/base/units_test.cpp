#include "base/quantity.h"

#include <gmock/gmock.h>

#include <clocale>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "base/quantity_advice.h"

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
            "'m' is a unit of length; a duration is allowed, such as '90 s', '1.5 h' or 'PT1H30M'; "
            "did you mean 'min'?");
  EXPECT_EQ(why("1,5", "m"), "'1,5' has a comma; a decimal point is allowed; did you mean '1.5'?");
  EXPECT_THAT(why("", "rad"), HasSubstr("there is no text; an angle is allowed"));
  EXPECT_THAT(why("x", "1"), HasSubstr("a fraction is allowed"));
}

TEST(Units, durations_are_read_in_parts) {
  EXPECT_DOUBLE_EQ(quantity("1 h 30 min", "s"), 5400);
  EXPECT_DOUBLE_EQ(quantity("1h30min", "s"), 5400);
  EXPECT_DOUBLE_EQ(quantity("2 d 3h 0.5 min", "s"), 2 * 86400 + 3 * 3600 + 30);
  EXPECT_DOUBLE_EQ(quantity("30min", "s"), 1800);
  for (const char* text : {"1 h 2 h", "30 min 1 h", "-1 h 30 min", "1 h -30 min", "1 h 30 kg"}) {
    EXPECT_FALSE(parse_quantity(text, unit("s"))) << text;
  }
  EXPECT_FALSE(parse_quantity("1 km 300 m", unit("m"))) << "durations alone come in parts";
}

TEST(Units, blanks_of_tables_and_web_pages_are_blanks) {
  EXPECT_DOUBLE_EQ(quantity("5\u00a0km", "m"), 5000);
  EXPECT_DOUBLE_EQ(quantity("5\u202fkm", "m"), 5000);
}

// The suggestions, in quotes; "" where there is none.
std::string suggested(std::string_view text, std::string_view symbol) {
  const std::string all = why(text, symbol);
  const std::string_view question = "; did you mean ";
  const std::size_t at = all.find(question);
  return at == std::string::npos ? "" : all.substr(at + question.size());
}

TEST(Suggestions, keep_kind_and_size_of_everyday_words) {
  EXPECT_EQ(suggested("2 hrs", "s"), "'h'?");
  EXPECT_EQ(suggested("2 hours", "s"), "'h'?");
  EXPECT_EQ(suggested("5 Min.", "s"), "'min'?");
  EXPECT_EQ(suggested("30 m", "s"), "'min'?");
  EXPECT_EQ(suggested("90 secs", "s"), "'s'?");
  EXPECT_EQ(suggested("3 days", "s"), "'d'?");
  EXPECT_EQ(suggested("5 kph", "m/s"), "'km/h'?");
  EXPECT_EQ(suggested("5 Km/h", "m/s"), "'km/h'?");
  EXPECT_EQ(suggested("3 M/S", "m/s"), "'m/s'?");
  EXPECT_EQ(suggested("3 m / s", "m/s"), "'m/s'?");
  EXPECT_EQ(suggested("3 km per hour", "m/s"), "'km/h'?");
  EXPECT_EQ(suggested("20°", "deg"), "'deg'?");
  EXPECT_EQ(suggested("20 Degrees", "deg"), "'deg'?");
  EXPECT_EQ(suggested("5 feet", "m"), "'ft'?");
  EXPECT_EQ(suggested("2 m²", "m2"), "'m2'?");
  EXPECT_EQ(suggested("2 KW", "W"), "'kW'?");
  EXPECT_EQ(suggested("2 KWH", "kWh"), "'kWh'?");
  EXPECT_EQ(suggested("80 percent", "1"), "'%'?");
  EXPECT_EQ(suggested("1 parsec", "m"), "");
}

// Mile 1609.344 m, nautical mile 1852 m, pound 0.45359237 kg by definition (NIST SP 811, 2008).
TEST(Suggestions, convert_what_is_no_unit_here) {
  EXPECT_EQ(suggested("5 mph", "m/s"), "'8.04672 km/h'?");
  EXPECT_EQ(suggested("5 knots", "m/s"), "'9.26 km/h'?");
  EXPECT_EQ(suggested("2 miles", "m"), "'3.218688 km'?");
  EXPECT_EQ(suggested("10 lbs", "kg"), "'4.535924 kg'?");
  EXPECT_EQ(suggested("2 weeks", "s"), "'14 d'?");
  EXPECT_EQ(suggested("3 sols", "s"), "'3.082474 d'?");
  EXPECT_EQ(suggested("20 %", "deg"), "'11.31 deg'?");
}

TEST(Suggestions, of_units_alone_are_of_the_same_size) {
  EXPECT_EQ(unit_advice("hrs"), "; did you mean 'h'?");
  EXPECT_EQ(unit_advice("kmh"), "; did you mean 'km/h'?");
  EXPECT_EQ(unit_advice("KW"), "; did you mean 'kW'?");
  EXPECT_EQ(unit_advice("meters"), "; did you mean 'm'?");
  EXPECT_EQ(unit_advice("mi", "length"), "") << "a mile is none of them";
  EXPECT_EQ(unit_advice("parsec"), "");
  EXPECT_EQ(unit_advice("feat", "length"), "; did you mean 'ft'?");
  EXPECT_EQ(unit_advice("mils", "length"), "") << "a thousandth of an inch";
}

TEST(Suggestions, never_take_milli_for_mega) {
  EXPECT_EQ(suggested("2 MW", "W"), "'2000 kW'?");
  EXPECT_EQ(suggested("2 MWh", "kWh"), "'2000 kWh'?");
  EXPECT_EQ(suggested("3 mJ", "J"), "'0.003 J'?");
  EXPECT_EQ(suggested("2 mw", "W"), "");
  EXPECT_EQ(suggested("2 mj", "J"), "");
  EXPECT_EQ(suggested("2 MPA", "Pa"), "");
}

TEST(Suggestions, write_clocks_and_parts_as_durations) {
  EXPECT_EQ(suggested("01:30:00", "s"), "'PT1H30M'?");
  EXPECT_EQ(suggested("00:00:45", "s"), "'PT45S'?");
  EXPECT_EQ(suggested("01:30", "s"),
            "'PT1H30M' (hours and minutes) or 'PT1M30S' (minutes and seconds)?");
  EXPECT_EQ(suggested("1h30", "s"), "'1 h 30 min'?");
  EXPECT_EQ(suggested("1 hr 30 mins", "s"), "'1 h 30 min'?");
  EXPECT_EQ(suggested("2 days and 3 hours", "s"), "'2 d 3 h'?");
  EXPECT_EQ(suggested("pt1h30m", "s"), "'PT1H30M'?");
  EXPECT_EQ(suggested("01:75:00", "s"), "");
}

TEST(Suggestions, write_numbers_as_they_are_read) {
  EXPECT_EQ(suggested("1,5 h", "s"), "'1.5 h'?");
  EXPECT_EQ(suggested("0,500", "m"), "'0.500'?");
  EXPECT_EQ(suggested("1,500 m", "m"), "'1500 m' or '1.500 m'?");
  EXPECT_EQ(suggested("1,000,000 W", "W"), "'1000000 W'?");
  EXPECT_EQ(suggested("1.000,5 W", "W"), "'1000.5 W'?");
  EXPECT_EQ(suggested("1 000 W", "W"), "'1000 W'?");
  EXPECT_EQ(suggested("1'000 W", "W"), "'1000 W'?");
  EXPECT_EQ(suggested("\u22123 m/s", "m/s"), "'-3 m/s'?");
  EXPECT_EQ(suggested("1.5.2 m", "m"), "");
  EXPECT_THAT(parse_integer("1,500").why, HasSubstr("did you mean '1500'?"));
  EXPECT_THAT(parse_boolean("Yes").why, HasSubstr("did you mean 'true'?"));
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
  EXPECT_EQ(parse_integer("10.0").value, 10) << "as spreadsheets write it";
  EXPECT_EQ(parse_integer("1.5").why, "'1.5' is no whole number");
  EXPECT_EQ(parse_integer("").why, "'' is no whole number");
  EXPECT_EQ(parse_integer("+-3").why, "'+-3' is no whole number");
  EXPECT_THAT(parse_integer("9223372036854775808").why, HasSubstr("outside"));
}

TEST(Units, booleans) {
  EXPECT_EQ(parse_boolean("true").value, true);
  EXPECT_EQ(parse_boolean(" 1 ").value, true);
  EXPECT_EQ(parse_boolean("false").value, false);
  EXPECT_EQ(parse_boolean("TRUE").value, true) << "as spreadsheets write it";
  EXPECT_EQ(parse_boolean("0").value, false);
  EXPECT_EQ(parse_boolean("yes").why,
            "'yes' is neither true nor false; true, false, 1, 0 are allowed; did you mean 'true'?");
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
