#include "lua/app/instrument_answer.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/console.h"

namespace lsos {

namespace {

constexpr std::size_t screen = 100, gap = 2;  // characters
constexpr const char* warnings_key = "warnings";

struct UnitText {
  std::string_view suffix, unit;
};
// Longer suffixes come first, since the first that matches is used.
constexpr UnitText unit_texts[] = {{"_n_m", " N m"},   {"_deg", "°"}, {"_wpm2", " W/m2"},
                                   {"_mps2", " m/s2"}, {"_n", " N"},  {"_m", " m"},
                                   {"_s", " s"}};

const UnitText* unit_of(std::string_view key) {
  const auto found = std::ranges::find_if(
      unit_texts, [&](const UnitText& text) { return key.ends_with(text.suffix); });
  return found == std::end(unit_texts) ? nullptr : found;
}

// "sub_solar_lon_deg" becomes "sub solar lon".
std::string answer_label(const std::string& key) {
  const UnitText* unit = unit_of(key);
  std::string label = key.substr(0, key.size() - (unit == nullptr ? 0 : unit->suffix.size()));
  std::ranges::replace(label, '_', ' ');
  return label;
}

// Longitude and latitude with nine digits, 1e-6 degrees or a decimetre at least; other numbers with
// six.
std::string number_text(double value, const std::string& key) {
  constexpr double many = 1e6;
  if (key == "lon_deg" || key == "lat_deg") return fmt::format("{:.9g}", value);
  if (std::abs(value) >= many) return fmt::format("{:.0f}", value);
  return fmt::format("{:.6g}", value == 0 ? 0 : value);  // no negative zero
}

std::string value_text(const std::string& key, const AnswerRow& value) {
  if (value.is_null()) return "-";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array()) {
    std::string text;
    for (const AnswerRow& part : value) text += (text.empty() ? "" : " ") + value_text(key, part);
    return text;
  }
  if (!value.is_number())
    return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (key == "visible") return value == 0 ? "no" : "yes";
  const double number = value.get<double>();
  constexpr double far_m = 1e6, m_per_km = 1000;
  const UnitText* unit = unit_of(key);
  if (unit != nullptr && unit->unit == " m" && std::abs(number) >= far_m) {
    return number_text(number / m_per_km, key) + " km";
  }
  return number_text(number, key) + std::string(unit == nullptr ? "" : unit->unit);
}

// Width in characters; "°" counts as one.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool is_left) {
  const std::string space(width - std::min(width, width_of(text)), ' ');
  return is_left ? text + space : space + text;
}

// Lays out columns of texts, the first of which holds the labels; as many rows of the answer as fit
// stand side by side.
std::string table(const std::vector<std::vector<std::string>>& columns) {
  const auto widest = [](const std::vector<std::string>& column) {
    std::size_t width = 0;
    for (const std::string& text : column) width = std::max(width, width_of(text));
    return width;
  };
  const std::size_t labels = widest(columns.front());
  std::string text;
  for (std::size_t from = 1; from < columns.size();) {
    std::size_t to = from + 1, used = labels + gap + widest(columns[from]);
    for (; to < columns.size(); ++to) {
      used += gap + widest(columns[to]);
      if (used > screen) break;
    }
    if (from > 1) text += '\n';
    for (std::size_t line = 0; line < columns.front().size(); ++line) {
      text += padded(columns.front()[line], labels, true);
      for (std::size_t k = from; k < to; ++k) {
        text += std::string(gap, ' ') + padded(columns[k][line], widest(columns[k]), false);
      }
      text += '\n';
    }
    from = to;
  }
  return text;
}

}  // namespace

std::string answer_table(const AnswerRow& rows) {
  std::vector<std::string> keys;
  for (const AnswerRow& row : rows) {
    for (const auto& [key, value] : row.items()) {
      if (key == warnings_key) continue;  // they are printed on standard error
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
    }
  }
  std::vector<std::vector<std::string>> columns(1);
  for (const std::string& key : keys) columns.front().push_back(answer_label(key));
  for (const AnswerRow& row : rows) {
    std::vector<std::string>& column = columns.emplace_back();
    for (const std::string& key : keys) {
      column.push_back(row.contains(key) ? value_text(key, row[key]) : "");
    }
  }
  return table(columns);
}

void print_answer(const AnswerRow& rows, AnswerStyle style) {
  const bool is_table =
      style == AnswerStyle::text || (style == AnswerStyle::by_output && isatty(STDOUT_FILENO) != 0);
  if (is_table) {
    print_result("{}", answer_table(rows));
  } else {
    print_result("{}\n", rows.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  }
}

}  // namespace lsos
