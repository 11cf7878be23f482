#include "study/parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/quantity.h"
#include "plan/field_reader.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

const Unit& one() { return *find_unit("1"); }

// Reads one variation; faults are told at its line.
class ParameterReader {
 public:
  ParameterReader(const Variation& variation, const ParameterContext& context, Faults& faults)
      : variation_(variation), context_(context), faults_(faults) {}

  std::optional<Parameter> read() {
    const Parsed<Address> address =
        parse_address(variation_.of, context_.plan, context_.declarations);
    if (!address) return refuse(address.why);
    Parameter parameter;
    parameter.variation = variation_;
    parameter.address = *address.value;
    if (parameter.is_place() != (variation_.form == Form::within)) {
      return refuse(parameter.is_place()
                        ? "a place varies within = a radius, such as '50 m'"
                        : "'within' is of places; this varies by list, range, uniform, normal or "
                          "triangular");
    }
    if (parameter.is_place()) return with_radius(std::move(parameter));
    set_style(parameter);
    if (variation_.is_factor && !set_base(parameter)) return {};
    const bool is_read =
        variation_.form == Form::list ? read_list(parameter) : read_numbers(parameter);
    if (!is_read) return {};
    return parameter;
  }

 private:
  std::nullopt_t refuse(const std::string& why) {
    faults_.error(variation_.place, fmt::format("vary '{}': {}", variation_.of, why));
    return std::nullopt;
  }

  std::optional<Parameter> with_radius(Parameter parameter) {
    const Parsed<double> radius = parse_quantity(variation_.values.front(), *find_unit("m"));
    if (!radius) return refuse("within: " + radius.why);
    if (!(*radius.value > 0 && *radius.value <= 1e5)) {
      return refuse(fmt::format("within = {}: more than 0 and at most 100 km is allowed",
                                variation_.values.front()));
    }
    parameter.radius_m = *radius.value;
    return parameter;
  }

  void set_style(Parameter& parameter) const {
    if (parameter.address.what == Address::What::script_key) {
      parameter.style.unit = context_.unit_of_key(parameter.address.name);
      return;
    }
    const FieldDeclaration& field =
        field_of(parameter.address, context_.plan, context_.declarations);
    parameter.style.field = &field;
    parameter.style.unit = field.unit;
    parameter.style.is_utc = field.kind == FieldKind::utc;
  }

  bool set_base(Parameter& parameter) {
    const std::optional<double> base = context_.base_of(parameter.address);
    if (!base) {
      refuse("factor: there is no number in the plan or script that it could multiply");
      return false;
    }
    parameter.base_si = *base;
    return true;
  }

  // The value of a text as the plan has it, checked against the field's kind, unit and range.
  std::optional<FieldValue> field_value(const Parameter& parameter, const std::string& text) {
    SourceData data;
    data.fields = {{parameter.address.name, text, variation_.place.line}};
    FieldReader reader({variation_.place, fmt::format("vary '{}'", variation_.of)}, data, faults_);
    const FieldDeclaration& field = *parameter.style.field;
    if (text.empty()) {
      reader.error(field.name, "is empty");
      return {};
    }
    FieldValues values = reader.read(std::span(&field, 1), nullptr);
    const auto value = values.find(field.key);
    if (reader.fault_count() > 0 || value == values.end()) return {};
    return value->second;
  }

  bool read_list(Parameter& parameter) {
    bool is_good = true;
    for (const std::string& text : variation_.values) {
      if (variation_.is_factor) {
        const std::optional<double> factor = factor_of(text);
        if (factor) add_choice(parameter, *factor * parameter.base_si);
        is_good = is_good && factor;
      } else {
        if (parameter.style.field != nullptr) is_good &= field_value(parameter, text).has_value();
        parameter.choices.push_back(text);
      }
    }
    return is_good && are_in_range(parameter);
  }

  std::optional<double> factor_of(const std::string& text) {
    const Parsed<double> factor = parse_quantity(text, one());
    if (!factor) return refuse("factor: " + factor.why);
    return factor.value;
  }

  // Whether the values may be drawn from an interval.
  bool is_numeric(const Parameter& parameter) {
    const FieldDeclaration* field = parameter.style.field;
    if (field == nullptr) return true;
    switch (field->kind) {
      case FieldKind::number:
      case FieldKind::integer:
      case FieldKind::duration:
      case FieldKind::utc:
      case FieldKind::moment:
        return true;
      case FieldKind::boolean:
      case FieldKind::text:
      case FieldKind::choice:
        break;
    }
    refuse(fmt::format("{} is no number: it varies by list = {{ ... }}", field->name));
    return false;
  }

  // A bound of the interval in SI; of a UTC time, seconds since the first bound.
  std::optional<double> number(Parameter& parameter, const std::string& text) {
    if (variation_.is_factor) return factor_of(text);
    if (parameter.style.field == nullptr) {
      const Unit& unit = parameter.style.unit == nullptr ? one() : *parameter.style.unit;
      const Parsed<double> value = parse_quantity(text, unit);
      if (!value) return refuse(value.why);
      return value.value;
    }
    const std::optional<FieldValue> value = field_value(parameter, text);
    if (!value) return {};
    if (const auto* instant = std::get_if<Instant>(&*value)) {
      if (!parameter.style.origin) parameter.style.origin = *instant;
      parameter.style.is_utc = true;
      return seconds(*instant - *parameter.style.origin);
    }
    if (const auto* whole = std::get_if<std::int64_t>(&*value)) {
      return static_cast<double>(*whole);
    }
    if (parameter.style.origin) {
      return refuse("its bounds are UTC times and durations; one of the two is wanted");
    }
    return std::get<double>(*value);
  }

  // A difference of values: a step or a deviation.
  std::optional<double> difference(const Parameter& parameter, const std::string& text) {
    const bool is_time = parameter.style.is_utc;
    const Unit* unit = is_time ? find_unit("s") : parameter.style.unit;
    if (variation_.is_factor || unit == nullptr) unit = &one();
    const Parsed<double> value = parse_quantity(text, *unit);
    if (!value) return refuse(value.why);
    if (!(*value.value > 0)) {
      return refuse(
          fmt::format("{}: '{}': more than 0 is wanted", to_string(variation_.form), text));
    }
    return value.value;
  }

  bool read_numbers(Parameter& parameter) {
    if (!is_numeric(parameter)) return false;
    const std::vector<std::string>& texts = variation_.values;
    const bool has_difference = variation_.form == Form::normal || variation_.form == Form::range;
    const std::size_t place_of_difference = variation_.form == Form::normal ? 1 : 2;
    std::vector<double> values(texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (has_difference && i == place_of_difference) continue;
      const std::optional<double> value = number(parameter, texts[i]);
      if (!value) return false;
      values[i] = *value;
    }
    if (has_difference) {
      const auto value = difference(parameter, texts[place_of_difference]);
      if (!value) return false;
      values[place_of_difference] = *value;
    }
    return set_values(parameter, values) && are_in_range(parameter);
  }

  bool set_values(Parameter& parameter, const std::vector<double>& values) {
    const auto in_order = [&](double low, double high) {
      if (low < high) return true;
      refuse(fmt::format("{}: the first bound must be less than the second",
                         to_string(variation_.form)));
      return false;
    };
    switch (variation_.form) {
      case Form::uniform:
        parameter.distribution = Uniform{values[0], values[1]};
        return in_order(values[0], values[1]);
      case Form::normal:
        parameter.distribution = Normal{values[0], values[1], values[2], values[3]};
        return in_order(values[2], values[3]) && holds_values(values);
      case Form::triangular:
        parameter.distribution = Triangular{values[0], values[1], values[2]};
        if (!in_order(values[0], values[2])) return false;
        if (values[1] < values[0] || values[1] > values[2]) {
          refuse("triangular: the mode must lie between min and max");
          return false;
        }
        return true;
      case Form::range:
        return in_order(values[0], values[1]) && set_range(parameter, values);
      case Form::list:
      case Form::within:
        break;
    }
    return false;
  }

  // Farther out than eight deviations no value of a normal distribution is drawn.
  bool holds_values(const std::vector<double>& values) {
    constexpr double farthest = 8;
    const double reach = farthest * values[1];
    if (values[3] > values[0] - reach && values[2] < values[0] + reach) return true;
    refuse("normal: min and max lie more than 8 deviations from the mean, on one side");
    return false;
  }

  bool set_range(Parameter& parameter, const std::vector<double>& values) {
    constexpr double slack = 1e-9;
    const double steps = std::floor((values[1] - values[0]) / values[2] + slack);
    if (!(steps < static_cast<double>(cases_max))) {
      refuse("range: the step is too small: it gives more values than there can be cases");
      return false;
    }
    for (std::int64_t i = 0; i <= static_cast<std::int64_t>(steps); ++i) {
      add_choice(parameter, values[0] + static_cast<double>(i) * values[2]);
    }
    return true;
  }

  void add_choice(Parameter& parameter, double value);
  bool are_in_range(const Parameter& parameter);

  const Variation& variation_;
  const ParameterContext& context_;
  Faults& faults_;
};

// A number of a parameter as the plan has it. A factor has been multiplied already.
std::string number_text(const Parameter& parameter, double value) {
  const NumberStyle& style = parameter.style;
  if (style.is_utc) return format_utc(*style.origin + from_seconds(value));
  if (style.field == nullptr) return fmt::format("{}", value);
  if (style.field->kind == FieldKind::integer) {
    return fmt::format("{}", static_cast<std::int64_t>(std::floor(value)));
  }
  const bool is_time =
      style.field->kind == FieldKind::duration || style.field->kind == FieldKind::moment;
  if (is_time) return format_quantity(rounded_s(value), *find_unit("s"));
  return format_quantity(value, style.unit == nullptr ? one() : *style.unit);
}

void ParameterReader::add_choice(Parameter& parameter, double value) {
  parameter.choices.push_back(number_text(parameter, value));
}

// Factors and steps make values that the bounds alone do not show.
bool ParameterReader::are_in_range(const Parameter& parameter) {
  if (parameter.style.field == nullptr || parameter.style.is_utc) return true;
  std::vector<std::string> texts;
  if (parameter.distribution && variation_.is_factor) {
    texts = {number_text(parameter, least(*parameter.distribution) * parameter.base_si),
             number_text(parameter, greatest(*parameter.distribution) * parameter.base_si)};
  } else if (variation_.is_factor || variation_.form == Form::range) {
    texts = {parameter.choices.front(), parameter.choices.back()};
  }
  return std::ranges::all_of(
      texts, [&](const std::string& text) { return field_value(parameter, text).has_value(); });
}

// The value of a text in SI: what a study's table has.
Draw::Value value_of(const Parameter& parameter, const std::string& text) {
  if (parameter.style.field == nullptr) {
    if (text == "true" || text == "false") return text == "true";
    const Unit& unit = parameter.style.unit == nullptr ? one() : *parameter.style.unit;
    const Parsed<double> number = parse_quantity(text, unit);
    if (number) return *number.value;
    return text;
  }
  SourceData data;
  data.fields = {{parameter.address.name, text, 0}};
  Faults none;
  FieldReader reader({{}, ""}, data, none);
  const FieldDeclaration& field = *parameter.style.field;
  const FieldValues values = reader.read(std::span(&field, 1), nullptr);
  const auto found = values.find(field.key);
  if (found == values.end()) return text;
  if (const auto* instant = std::get_if<Instant>(&found->second)) return format_utc(*instant);
  if (const auto* flag = std::get_if<bool>(&found->second)) return *flag;
  if (const auto* whole = std::get_if<std::int64_t>(&found->second)) return *whole;
  if (const auto* number = std::get_if<double>(&found->second)) return *number;
  return std::get<std::string>(found->second);
}

std::string drawn_text(const Parameter& parameter, double share) {
  if (!parameter.distribution) {
    const auto count = parameter.choices.size();
    const auto index = static_cast<std::size_t>(share * static_cast<double>(count));
    return parameter.choices[std::min(index, count - 1)];
  }
  const bool is_whole =
      parameter.style.field != nullptr && parameter.style.field->kind == FieldKind::integer;
  if (is_whole && std::holds_alternative<Uniform>(*parameter.distribution)) {
    // Each whole number of the interval is as likely as the others, also the last.
    const auto [from, to] = std::get<Uniform>(*parameter.distribution);
    const double value = std::min(from + std::floor((to - from + 1) * share), to);
    return number_text(parameter, value * parameter.base_si);
  }
  const double value = quantile(*parameter.distribution, share) * parameter.base_si;
  return number_text(parameter, is_whole ? std::round(value) : value);
}

}  // namespace

std::vector<Dimension> Parameter::dimensions() const {
  if (is_place()) return {{name() + ".angle", 0}, {name() + ".radius", 0}};
  return {{name(), static_cast<std::int64_t>(choices.size())}};
}

std::vector<Parameter> parameters_of(const Study& study, const ParameterContext& context,
                                     Faults& faults) {
  std::vector<Parameter> parameters;
  std::map<std::string, Place> known;
  for (const Variation& variation : study.varied) {
    std::optional<Parameter> parameter = ParameterReader(variation, context, faults).read();
    if (!parameter) continue;
    const auto [first, is_new] = known.emplace(parameter->name(), variation.place);
    if (!is_new) {
      faults.error(variation.place, fmt::format("vary '{}': varies already, see {}", variation.of,
                                                line_text(first->second, variation.place.file)));
      continue;
    }
    parameters.push_back(std::move(*parameter));
  }
  std::ranges::sort(parameters, {}, &Parameter::name);
  return parameters;
}

Draw draw(const Parameter& parameter, const std::map<std::string, double>& shares) {
  Draw drawn;
  drawn.address = parameter.address;
  const std::string name = parameter.name();
  if (parameter.is_place()) {
    // Uniform over the disc: as many places in each of two equal areas.
    const double angle_rad = 2 * std::numbers::pi * shares.at(name + ".angle"),
                 radius_m = parameter.radius_m * std::sqrt(shares.at(name + ".radius"));
    drawn.offset_m = {radius_m * std::sin(angle_rad), radius_m * std::cos(angle_rad)};
    drawn.values = {{name + ".east_m", drawn.offset_m.x()},
                    {name + ".north_m", drawn.offset_m.y()}};
    return drawn;
  }
  drawn.text = drawn_text(parameter, shares.at(name));
  drawn.values = {{name, value_of(parameter, drawn.text)}};
  return drawn;
}

std::vector<Draw> draws(const std::vector<Parameter>& parameters,
                        const std::map<std::string, double>& shares) {
  std::vector<Draw> all;
  for (const Parameter& parameter : parameters) all.push_back(draw(parameter, shares));
  return all;
}

}  // namespace lsos
