#include "base/quantity_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "base/iso_duration.h"
#include "base/replaced.h"
#include "base/text.h"
#include "base/unit_spellings.h"

namespace lsos {

namespace {

constexpr std::size_t text_bytes_max = 64;  // no quantity is longer

// With the minus sign, dashes and apostrophes of word processors as plain ones.
std::string in_ascii(std::string text) {
  for (const char* minus : {"\u2212", "\u2013", "\u2010", "\u2011"}) {
    text = replaced(std::move(text), minus, "-");
  }
  return replaced(std::move(text), "\u2019", "'");
}

// A blank or an apostrophe between groups of three digits: "1 500", "1'500".
bool is_group_separator(std::string_view text, std::size_t at) {
  if (text[at] != ' ' && text[at] != '\'') return false;
  if (at == 0 || !is_digit(text[at - 1]) || at + 3 >= text.size()) return false;
  const bool are_three = std::ranges::all_of(text.substr(at + 1, 3), is_digit);
  return are_three && (at + 4 == text.size() || !is_digit(text[at + 4]));
}

// End of the number at the beginning of the text, in whatever notation.
std::size_t number_end(std::string_view text) {
  std::size_t end = 0;
  if (end < text.size() && (text[end] == '-' || text[end] == '+')) ++end;
  while (end < text.size()) {
    const char c = text[end];
    const bool is_exponent =
        (c == 'e' || c == 'E') && end > 0 && is_digit(text[end - 1]) && end + 1 < text.size() &&
        (is_digit(text[end + 1]) ||
         (text[end + 1] == '-' && end + 2 < text.size() && is_digit(text[end + 2])));
    if (is_exponent) {
      end += 2;
    } else if (is_digit(c) || c == '.' || c == ',' || is_group_separator(text, end)) {
      ++end;
    } else {
      break;
    }
  }
  while (end > 0 && (text[end - 1] == ',' || text[end - 1] == '.')) --end;
  return end;
}

std::optional<double> plain_number(const std::string& text) {
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

// Whether groups of three digits follow each separator, up to the end or the decimal sign.
bool is_grouped(std::string_view text, char separator, char decimal) {
  text = text.substr(0, text.find(decimal));
  std::size_t at = text.find(separator);
  while (at != std::string_view::npos) {
    const std::size_t next = std::min(text.find(separator, at + 1), text.size());
    if (next - at != 4) return false;
    at = next == text.size() ? std::string_view::npos : next;
  }
  return true;
}

// All values that the written number can mean, as plain numbers: "1,500" can be two.
std::vector<std::string> meanings(std::string_view number) {
  std::string text(number);
  std::erase_if(text, [](char c) { return c == ' ' || c == '\''; });
  const auto commas = std::ranges::count(text, ','), points = std::ranges::count(text, '.');
  const auto without = [](std::string from, char c) {
    std::erase(from, c);
    return from;
  };
  std::vector<std::string> found;
  if (commas == 0 && points < 2) {
    found = {text};
  } else if (commas == 1 && points == 0) {
    const bool has_group =
        is_grouped(text, ',', 0) && text.find_first_of("123456789") < text.find(',');
    if (has_group) found.push_back(without(text, ','));
    found.push_back(replaced(text, ",", "."));
  } else {
    const char decimal = text.rfind(',') + 1 > text.rfind('.') + 1 ? ',' : '.';
    const char only = commas == 0 ? '.' : points == 0 ? ',' : decimal == ',' ? '.' : ',';
    if (is_grouped(text, only, commas > 0 && points > 0 ? decimal : 0)) {
      found = {replaced(without(text, only), ",", ".")};
    }
  }
  std::erase_if(found, [](const std::string& each) { return !plain_number(each); });
  return found;
}

std::string as_question(const std::vector<std::string>& texts) {
  if (texts.empty()) return "";
  std::string all;
  for (const std::string& text : texts) {
    all += fmt::format("{}'{}'", all.empty() ? "" : " or ", text);
  }
  return fmt::format("; did you mean {}?", all);
}

// Suggestion for a clock time such as "01:30:00". Two parts may be hours and minutes or minutes and
// seconds.
std::string clock_advice(std::string_view text) {
  std::vector<int> parts;
  while (parts.size() < 3) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const auto digits = static_cast<std::size_t>(end - text.data());
    if (error != std::errc{} || value < 0 || digits > 3) return "";
    if (!parts.empty() && (digits != 2 || value > 59)) return "";
    parts.push_back(value);
    text.remove_prefix(digits);
    if (text.empty()) break;
    if (text.front() != ':') return "";
    text.remove_prefix(1);
  }
  if (!text.empty() || parts.size() < 2) return "";
  const auto iso = [](int hours, int minutes, int seconds) {
    std::string duration = "PT";
    if (hours > 0) duration += fmt::format("{}H", hours);
    if (minutes > 0) duration += fmt::format("{}M", minutes);
    if (seconds > 0 || duration == "PT") duration += fmt::format("{}S", seconds);
    return duration;
  };
  if (parts.size() == 3) return as_question({iso(parts[0], parts[1], parts[2])});
  return fmt::format("; did you mean '{}' (hours and minutes) or '{}' (minutes and seconds)?",
                     iso(parts[0], parts[1], 0), iso(0, parts[0], parts[1]));
}

// Part of a quantity in its correct spelling: "1.5 h".
struct Part {
  std::vector<std::string> texts;  // one, or two where the number is ambiguous
  std::string symbol;
};

std::optional<Part> part_of(std::string_view number, std::string_view word, const Unit& wanted) {
  Part part;
  const std::vector<std::string> numbers = meanings(number);
  if (numbers.empty()) return {};
  double factor = 1;
  if (!word.empty()) {
    const std::optional<UnitSpelling> spelling = spelled_unit(word, wanted.kind);
    if (!spelling) return {};
    part.symbol = spelling->symbol;
    factor = spelling->factor;
  }
  for (const std::string& each : numbers) {
    const std::string value =
        factor == 1 ? each : fmt::format("{:.7g}", *plain_number(each) * factor);
    part.texts.push_back(value + (part.symbol.empty() ? "" : " ") + part.symbol);
  }
  return part;
}

// Suggestion for a duration in several parts: "1 hr 30 mins", "1h30".
std::string several_parts(std::string_view text, const Unit& wanted) {
  std::string whole;
  std::string_view before;  // unit of the preceding part
  double before_s = std::numeric_limits<double>::infinity();
  while (!text.empty()) {
    const std::size_t end = number_end(text);
    const std::string_view number = text.substr(0, end);
    std::size_t next = end;
    while (next < text.size() && !is_digit(text[next])) ++next;
    std::string word(trimmed(text.substr(end, next - end)));
    if (word.ends_with(',')) word.pop_back();
    if (word.ends_with(" and")) word.resize(word.size() - 4);
    if (word.empty())
      word = before == "d" ? "h" : before == "h" ? "min" : before == "min" ? "s" : "";
    const auto part = part_of(number, word, wanted);
    if (!part || part->symbol.empty() || part->texts.size() != 1) return "";
    const Unit* unit = find_unit(part->symbol);
    if (number.starts_with('-') || unit->si_factor >= before_s) return "";
    before_s = unit->si_factor;
    whole += (whole.empty() ? "" : " ") + part->texts.front();
    before = unit->symbol;
    text.remove_prefix(next);
  }
  return as_question({whole});
}

// Suggestion for a gradient in percent given as an angle.
std::string gradient_advice(std::string_view number) {
  std::vector<std::string> angles;
  for (const std::string& each : meanings(number)) {
    angles.push_back(fmt::format("{:.4g} deg", degrees(std::atan(*plain_number(each) / 100))));
  }
  return as_question(angles);
}

}  // namespace

std::string quantity_advice(std::string_view text, const Unit& wanted) {
  if (text.size() > text_bytes_max) return "";
  const std::string plain(trimmed(in_ascii(std::string(text))));
  const bool is_duration = wanted.kind == "duration";
  if (is_duration) {
    std::string iso = plain;
    std::ranges::transform(iso, iso.begin(), [](unsigned char c) { return std::toupper(c); });
    if (iso != plain && iso.starts_with('P') && parse_iso_duration(iso)) return as_question({iso});
    if (std::string clock = clock_advice(plain); !clock.empty()) return clock;
  }
  const std::size_t end = number_end(plain);
  const std::string number = plain.substr(0, end), word(trimmed(plain.substr(end)));
  if (number.empty()) return "";
  if (is_duration && std::ranges::any_of(word, is_digit)) return several_parts(plain, wanted);
  if (wanted.kind == "angle" && word == "%") return gradient_advice(number);
  const std::optional<Part> part = part_of(number, word, wanted);
  if (!part) return "";
  // Where the number is right and the unit has the size that was meant, its symbol is enough.
  const bool is_number_right = plain_number(std::string(text.substr(0, end))).has_value();
  if (!is_number_right) return as_question(part->texts);
  if (word.empty() || word == part->symbol) return "";
  return spelled_unit(word, wanted.kind)->factor == 1 ? as_question({part->symbol})
                                                      : as_question(part->texts);
}

std::string unit_advice(std::string_view symbol, std::string_view kind) {
  if (symbol.empty() || symbol.size() > text_bytes_max) return "";
  std::vector<std::string> found;
  for (const Unit& unit : all_units()) {
    if (!kind.empty() && unit.kind != kind) continue;
    const std::optional<UnitSpelling> spelling = spelled_unit(symbol, unit.kind);
    if (spelling && spelling->factor == 1 && spelling->symbol == unit.symbol) {
      found.emplace_back(unit.symbol);
    }
  }
  return as_question(found);
}

std::string whole_number_advice(std::string_view text) {
  if (text.size() > text_bytes_max) return "";
  const std::string plain(trimmed(in_ascii(std::string(text))));
  if (plain.empty() || number_end(plain) != plain.size()) return "";
  std::vector<std::string> whole;
  for (const std::string& each : meanings(plain)) {
    const double value = *plain_number(each);
    if (value == std::round(value) && std::abs(value) < 1e15) {
      whole.push_back(fmt::format("{:.0f}", value));
    }
  }
  return as_question(whole);
}

}  // namespace lsos
