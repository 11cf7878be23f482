#include "interchange/decimals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "base/replaced.h"
#include "interchange/thing_fields.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

bool is_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

// A number's text as it is grouped: "1.200,5" has the groups 1, 200 and 5.
struct Grouped {
  std::string number, rest;     // rest: " km/h"
  std::string marks;            // ".,"
  bool is_by_thousands = true;  // all groups but the first and that after the last mark have three
  std::size_t last_digits = 0;  // after the last mark
  bool begins_with_zero = false;
};

// Without marks where the text is no number with some.
Grouped grouped(const std::string& text) {
  Grouped found;
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  const std::size_t end = std::min(text.find_first_not_of("0123456789.,", sign), text.size());
  const std::string_view digits = std::string_view(text).substr(sign, end - sign);
  std::string marks;
  std::size_t from = 0;
  for (std::size_t i = 0; i <= digits.size(); ++i) {
    if (i < digits.size() && digits[i] != '.' && digits[i] != ',') continue;
    const std::string_view group = digits.substr(from, i - from);
    if (!is_digits(group)) return {};
    if (from == 0) {
      found.begins_with_zero = group.front() == '0';
      found.is_by_thousands = group.size() <= 3 && !found.begins_with_zero;
    } else if (i < digits.size() && group.size() != 3) {
      found.is_by_thousands = false;
    }
    found.last_digits = group.size();
    if (i < digits.size()) marks += digits[i];
    from = i + 1;
  }
  found.number = text.substr(0, end);
  found.rest = text.substr(end);
  found.marks = marks;
  return found;
}

// What one number shows.
Decimals shown_by(const Grouped& number) {
  if (number.marks.empty()) return Decimals::either;
  const char last = number.marks.back();
  const Decimals by_last = last == ',' ? Decimals::commas : Decimals::points;
  if (number.marks.size() > 1) {
    return number.marks.front() == last ? Decimals::either : by_last;
  }
  const bool may_be_thousands = number.is_by_thousands && number.last_digits == 3;
  return may_be_thousands ? Decimals::either : by_last;
}

}  // namespace

Decimals decimals_of(const Table& table, const Columns& columns, const Declarations& declarations) {
  if (!table.has_commas) return Decimals::points;
  bool has_points = false, has_commas = false;
  for (const auto& each : columns.all()) {
    const auto is_number = [&](const std::string& type) {
      const FieldDeclaration* field = declared_field(type, each.first, declarations);
      return field != nullptr &&
             (field->kind == FieldKind::number || field->kind == FieldKind::duration);
    };
    if (!std::ranges::any_of(plan_names(declarations), is_number)) continue;
    for (const TableRow& row : table.rows) {
      const Decimals shown = shown_by(grouped(cell(row, each.second.index)));
      has_points = has_points || shown == Decimals::points;
      has_commas = has_commas || shown == Decimals::commas;
    }
  }
  if (has_points == has_commas) return Decimals::either;
  return has_commas ? Decimals::commas : Decimals::points;
}

Parsed<std::string> with_decimal_point(const std::string& text, Decimals decimals) {
  const Grouped number = grouped(text);
  if (number.marks.empty()) return {text, {}};
  const auto without = [&](const char* mark) { return replaced(number.number, mark, ""); };
  const bool is_alone = number.marks.size() == 1;
  const char last = number.marks.back();
  if (!is_alone) {
    // "1.200,5", "1,200.5", "1.200.000"
    if (!number.is_by_thousands) return {text, {}};
    const auto count = std::ranges::count(number.marks, last);
    if (count > 1 && number.last_digits != 3) return {text, {}};
    if (count > 1 && static_cast<std::size_t>(count) < number.marks.size()) return {text, {}};
    if (count > 1) return {without(last == '.' ? "." : ",") + number.rest, {}};
    const std::string plain = without(last == ',' ? "." : ",");
    return {replaced(plain, ",", ".") + number.rest, {}};
  }
  const bool may_be_thousands = shown_by(number) == Decimals::either;
  const std::string as_decimal = replaced(number.number, ",", ".");
  const std::string as_thousands = without(last == '.' ? "." : ",");
  if (!may_be_thousands) return {as_decimal + number.rest, {}};
  if (last == '.' && decimals == Decimals::commas) return {as_thousands + number.rest, {}};
  if (last == '.' && decimals == Decimals::points) return {text, {}};
  if (last == ',' && decimals == Decimals::commas) return {as_decimal + number.rest, {}};
  std::string shortest = as_decimal.substr(0, as_decimal.find_last_not_of('0') + 1);
  if (shortest.ends_with('.')) shortest.pop_back();
  return {{},
          fmt::format("{} may be {} or {}, since this sheet's decimals may have commas; one of "
                      "them is to be written",
                      quoted(text), as_thousands, shortest)};
}

}  // namespace lsos
