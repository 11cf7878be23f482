#include "plan/field_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/quantity.h"
#include "base/sim_time.h"
#include "base/text.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

const Unit& unit_of(const FieldDeclaration& declaration) {
  if (declaration.unit != nullptr) return *declaration.unit;
  const bool is_time =
      declaration.kind == FieldKind::duration || declaration.kind == FieldKind::moment;
  return *find_unit(is_time ? "s" : "1");
}

template <class T>
Parsed<FieldValue> as_field_value(Parsed<T> parsed) {
  if (!parsed) return {{}, std::move(parsed.why)};
  return {FieldValue(*parsed.value), {}};
}

Parsed<FieldValue> parsed_duration(const std::string& text) {
  Parsed<double> duration = parse_quantity(text, *find_unit("s"));
  if (duration) duration.value = rounded_s(*duration.value);
  return as_field_value(duration);
}

// No duration begins like a date does: "2026-07-01".
Parsed<FieldValue> parsed_moment(const std::string& text) {
  constexpr std::size_t year_digits = 4;
  if (text.find('-') == year_digits) return as_field_value(parse_utc(text));
  Parsed<FieldValue> moment = parsed_duration(text);
  if (!moment) moment.why += "; or a UTC time, such as 2026-07-01T12:00:00Z";
  return moment;
}

// A share between 1 and 100 was probably meant in per cent; "" for other values.
std::string share_advice(const std::string& text, double share) {
  if (text.find('%') != std::string::npos) return "";
  return share > 1 && share <= 100 ? fmt::format("; did you mean '{} %'?", share) : "";
}

bool is_inside(const FieldDeclaration& declaration, double value_si) {
  const std::optional<double>&min = declaration.min_si, &max = declaration.max_si;
  return (!min || value_si >= *min) && (!max || value_si <= *max);
}

// The limit where the value is one but for the rounding of its unit's conversion, else the value:
// 0.036 km/h are 0.01 m/s, and 2e-18 less as a double.
double or_limit(const FieldDeclaration& declaration, double value_si) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  for (const std::optional<double>& limit_si : {declaration.min_si, declaration.max_si}) {
    if (limit_si && std::abs(value_si - *limit_si) <= rounding * std::abs(*limit_si)) {
      return *limit_si;
    }
  }
  return value_si;
}

// Whether a field may have the text, a number with its unit.
bool is_allowed(const FieldDeclaration& declaration, const std::string& text, const Unit& unit) {
  const Parsed<double> parsed = parse_quantity(text, unit);
  return parsed && is_inside(declaration, or_limit(declaration, *parsed.value));
}

// The value with at most ten digits.
std::string rounded_text(double value, const Unit& unit) {
  return fmt::format("{:.10g}{}{}", value, unit.symbol == "1" ? "" : " ",
                     unit.symbol == "1" ? "" : unit.symbol);
}

// The unit that the text has behind its number, where the limits have few digits in it; else that
// of the field.
const Unit& unit_for_limits(const FieldDeclaration& declaration, const std::string& text) {
  const Unit& own = unit_of(declaration);
  const std::size_t number_end = text.find_last_of("0123456789.");
  if (number_end == std::string::npos) return own;
  const Unit* written = find_unit(trimmed(std::string_view(text).substr(number_end + 1)));
  if (written == nullptr || written->kind != own.kind) return own;
  constexpr std::size_t digits_max = 6;
  for (const std::optional<double>& limit_si : {declaration.min_si, declaration.max_si}) {
    if (!limit_si) continue;
    const double limit = from_si(*limit_si, *written);
    if (fmt::format("{:.10g}", limit).size() > digits_max) return own;
    if (!is_allowed(declaration, rounded_text(limit, *written), *written)) return own;
  }
  return *written;
}

// A limit as the shortest text that is allowed itself: exact, or with ten digits, the last of them
// towards the inside where the nearest is outside.
std::string limit_text(const FieldDeclaration& declaration, double limit_si, const Unit& unit) {
  const double limit = from_si(limit_si, unit);
  const double digit = limit == 0 ? 0 : std::pow(10, std::floor(std::log10(std::abs(limit))) - 9);
  const std::string exact = format_quantity(limit_si, unit);
  std::string shortest;
  for (const std::string& text :
       {rounded_text(limit, unit), exact, rounded_text(limit + digit, unit),
        rounded_text(limit - digit, unit)}) {
    if (!shortest.empty() && text.size() >= shortest.size()) continue;
    if (is_allowed(declaration, text, unit)) shortest = text;
  }
  return shortest.empty() ? exact : shortest;
}

// Why a number is outside its field's range; "" when it is inside.
std::string out_of_range(const FieldDeclaration& declaration, double value_si,
                         const std::string& text) {
  if (is_inside(declaration, value_si)) return {};
  const std::optional<double>&min = declaration.min_si, &max = declaration.max_si;
  const auto limit = [&](double limit_si) {
    return limit_text(declaration, limit_si, unit_for_limits(declaration, text));
  };
  const bool is_share =
      unit_of(declaration).kind == "fraction" && declaration.kind == FieldKind::number;
  if (is_share && max && text.find('%') != std::string::npos && value_si > *max) {
    return fmt::format("is above {}", format_quantity(*max, *find_unit("%")));
  }
  // The ceiling that all durations share is not part of the field's own range.
  if (max == longest_duration_s && declaration.kind == FieldKind::duration) {
    return min && value_si < *min
               ? fmt::format("must be at least {}", limit(*min))
               : fmt::format("must be at most {}", format_quantity(*max, *find_unit("d")));
  }
  if (min && max) {
    return fmt::format("must be from {} to {}{}", limit(*min), limit(*max),
                       is_share ? share_advice(text, value_si) : "");
  }
  return min ? fmt::format("must be at least {}", limit(*min))
             : fmt::format("must be at most {}", limit(*max));
}

std::string range_fault(const FieldDeclaration& declaration, const FieldValue& value,
                        const std::string& text) {
  if (const auto* number = std::get_if<double>(&value)) {
    return out_of_range(declaration, *number, text);
  }
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    return out_of_range(declaration, static_cast<double>(*integer), text);
  }
  return {};
}

// Whether the text is a number without a unit: "2", "1.5e3".
bool is_bare_number(std::string_view text) {
  return !text.empty() &&
         text.find_first_not_of("0123456789.+-eE \t\n\r") == std::string_view::npos;
}

// Advice on a number without a unit that was probably meant in another one than is taken: a
// duration in seconds where the field's unit is hours, an angle in degrees that is a fraction of
// pi, a power in W that may be in kW. "" for others.
std::string bare_number_advice(const FieldDeclaration& declaration, const FieldValue& value,
                               const std::string& text) {
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr || declaration.unit == nullptr || !is_bare_number(text)) return "";
  const Unit& unit = *declaration.unit;
  if (declaration.kind == FieldKind::duration && declaration.default_value) {
    constexpr double much_shorter = 20, least_share = 0.1, most_share = 2;
    const auto* usual_s = std::get_if<double>(&*declaration.default_value);
    if (usual_s == nullptr || unit.si_factor == 1 || *number * much_shorter >= *usual_s) return "";
    // In the field's unit, or in minutes, the value would be close to the default.
    for (const Unit* meant : {&unit, find_unit("min")}) {
      const double meant_s = *number * meant->si_factor;
      if (meant_s < least_share * *usual_s || meant_s > most_share * *usual_s) continue;
      return fmt::format("is {:g} s, as without a unit; did you mean '{:g} {}'?", *number, *number,
                         meant->symbol);
    }
    return "";
  }
  // Rovers need kilowatts; fewer watts than a radio takes are rarely meant.
  constexpr double least_w = 5;
  const bool may_be_kw = !declaration.max_si || *number * 1000 <= *declaration.max_si;
  if (unit.symbol == "W" && *number > 0 && *number < least_w && may_be_kw) {
    return fmt::format("is {0:g} W, as without a unit; did you mean '{0:g} kW'?", *number);
  }
  if (unit.symbol != "deg") return "";
  // Only numbers with two decimals or more are compared with fractions of pi.
  const std::size_t point = text.find('.');
  if (point == std::string::npos || text.size() - point < 3) return "";
  constexpr double half_turn_rad = std::numbers::pi, last_digit = 0.002;
  const double written = degrees(*number), eighths = std::round(written / (half_turn_rad / 4));
  const bool is_part = eighths != 0 && std::abs(eighths) < 9 &&
                       std::abs(written - eighths * half_turn_rad / 4) < last_digit;
  const double meant_rad = eighths * half_turn_rad / 4;
  if (!is_part || !is_inside(declaration, meant_rad)) return "";
  return fmt::format("is {:g} deg, as without a unit; did you mean '{:g} deg'?", written,
                     45 * eighths);
}

}  // namespace

std::string format_value(const FieldDeclaration& declaration, const FieldValue& value) {
  struct Formatter {
    const FieldDeclaration& declaration;
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(std::int64_t integer) const { return fmt::format("{}", integer); }
    std::string operator()(double number) const {
      return format_quantity(number, unit_of(declaration));
    }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(Instant instant) const { return format_utc(instant); }
  };
  return std::visit(Formatter{declaration}, value);
}

void FieldReader::check_names(std::initializer_list<std::span<const FieldDeclaration>> known) {
  const auto is_known = [&](const std::string& name) {
    return std::ranges::any_of(known, [&](std::span<const FieldDeclaration> list) {
      return std::ranges::find(list, name, &FieldDeclaration::name) != list.end();
    });
  };
  std::map<std::string, int> lines;
  for (const SourceField& field : data_.fields) {
    const auto [first, is_new] = lines.emplace(field.name, field.line);
    if (!is_new) {
      report(field, fmt::format("{} is given twice; the first is at line {}", shown(field.name),
                                first->second));
    } else if (field.name.empty()) {
      report(field, "a SimpleData has no name");
    } else if (!is_known(field.name)) {
      std::vector<std::string> names;
      for (const auto& list : known) {
        for (const FieldDeclaration& each : list) names.push_back(each.name);
      }
      std::string hint = field.name.size() > 100 ? "" : did_you_mean(field.name, names);
      if (hint.empty()) hint = fmt::format("; there are {}", listed(names));
      report(field, fmt::format("there is no field {}{}", shown(field.name), hint));
      hints_.push_back(std::move(hint));
    }
  }
}

namespace {

// "2026-07-01T07:20:00": somebody may have meant the time of another zone.
bool is_time_without_zone(const FieldDeclaration& declaration, std::string_view text) {
  if (declaration.kind != FieldKind::utc && declaration.kind != FieldKind::moment) return false;
  const std::size_t time = text.find(':');
  return time != std::string_view::npos &&
         text.find_first_of("Zz+-", time) == std::string_view::npos;
}

}  // namespace

FieldValues FieldReader::read(std::span<const FieldDeclaration> declarations,
                              std::vector<std::string>* defaults) {
  FieldValues values;
  for (const FieldDeclaration& declaration : declarations) {
    if (const SourceField* field = find(declaration.name)) {
      if (auto value = parse(declaration, *field)) values[declaration.key] = std::move(*value);
      if (defaults != nullptr && is_time_without_zone(declaration, field->text)) {
        defaults->push_back(fmt::format("{}: {} = {} has no zone: UTC", subject_.name,
                                        declaration.name, shown(field->text)));
      }
    } else if (declaration.is_required) {
      // The field is given under a misspelt name, which has been reported.
      const std::string hint = fmt::format("; did you mean '{}'?", declaration.name);
      if (std::ranges::find(hints_, hint) != hints_.end()) continue;
      report(fmt::format("{} is missing; it is required", declaration.name));
    } else if (declaration.default_value) {
      values[declaration.key] = *declaration.default_value;
      if (defaults != nullptr) {
        defaults->push_back(fmt::format("{}: {} = {}", subject_.name, declaration.name,
                                        format_value(declaration, *declaration.default_value)));
      }
    }
  }
  return values;
}

const SourceField* FieldReader::find(const std::string& name) const {
  for (const SourceField& field : data_.fields) {
    if (field.name == name) return field.text.empty() ? nullptr : &field;
  }
  return nullptr;
}

void FieldReader::error(const std::string& field_name, const std::string& what) {
  const SourceField* field = find(field_name);
  if (field == nullptr) {
    report(fmt::format("{}: {}", field_name, what));
  } else {
    report(*field, fmt::format("{} = {}: {}", field_name, shown(field->text), what));
  }
}

void FieldReader::report(const std::string& what) {
  ++fault_count_;
  faults_.error(subject_.place, fmt::format("{}: {}", subject_.name, what));
}

void FieldReader::report(const SourceField& field, const std::string& what) {
  ++fault_count_;
  faults_.error({subject_.place.file, field.line, field.column},
                fmt::format("{}: {}", subject_.name, what));
}

std::optional<FieldValue> FieldReader::parse(const FieldDeclaration& declaration,
                                             const SourceField& field) {
  Parsed<FieldValue> result = parsed(declaration, field.text);
  if (result) {
    if (auto* number = std::get_if<double>(&*result.value)) {
      *number = or_limit(declaration, *number);
    }
    result.why = range_fault(declaration, *result.value, field.text);
  }
  if (result.why.empty()) {
    if (const std::string advice = bare_number_advice(declaration, *result.value, field.text);
        !advice.empty()) {
      faults_.warning({subject_.place.file, field.line, field.column},
                      fmt::format("{}: {} = {}: {}", subject_.name, declaration.name,
                                  shown(field.text), advice));
    }
    return std::move(result.value);
  }
  error(declaration.name, result.why);
  return {};
}

Parsed<FieldValue> FieldReader::parsed(const FieldDeclaration& declaration,
                                       const std::string& text) const {
  switch (declaration.kind) {
    case FieldKind::duration:  // a bare number is in seconds, whatever the field's unit
      return parsed_duration(text);
    case FieldKind::moment:
      return parsed_moment(text);
    case FieldKind::number:
      if (!declaration.amount_of.empty() && !is_bare_number(text)) {
        return {{}, "a plain number is allowed, in the resource's own unit, such as '2'"};
      }
      return as_field_value(parse_quantity(text, unit_of(declaration)));
    case FieldKind::integer:
      return as_field_value(parse_integer(text));
    case FieldKind::boolean:
      return as_field_value(parse_boolean(text));
    case FieldKind::utc:
      return as_field_value(parse_utc(text));
    case FieldKind::choice:
      if (std::ranges::find(declaration.choices, text) == declaration.choices.end()) {
        return {{},
                fmt::format("must be one of {}{}", listed(declaration.choices),
                            text.size() > 100 ? "" : did_you_mean(text, declaration.choices))};
      }
      return {FieldValue(text), {}};
    case FieldKind::text:
      return {FieldValue(text), {}};
  }
  LSOS_ASSERT(false);
}

const double* find_number(const FieldValues& values, const EventDeclaration& declaration,
                          NumberRole role) {
  const auto field = std::ranges::find(declaration.fields, role, &FieldDeclaration::role);
  return field == declaration.fields.end() ? nullptr : find_value<double>(values, field->key);
}

const std::string* find_name(const FieldValues& values, const EventDeclaration& declaration,
                             NameOf names) {
  const auto field = std::ranges::find(declaration.fields, names, &FieldDeclaration::names);
  return field == declaration.fields.end() ? nullptr : find_value<std::string>(values, field->key);
}

}  // namespace lsos
