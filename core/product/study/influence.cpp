#include "product/study/influence.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "planet/utc.h"

namespace lsos {

namespace {

using Kind = StudyColumn::Kind;

bool varies(const std::vector<double>& values) {
  std::optional<double> first;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (first && value != *first) return true;
    first = value;
  }
  return false;
}

// Texts by their places in byte order.
std::vector<double> places_of(const std::vector<std::string>& texts) {
  const std::set<std::string> distinct(texts.begin(), texts.end());
  std::vector<double> places;
  for (const std::string& text : texts) {
    places.push_back(static_cast<double>(std::distance(distinct.begin(), distinct.find(text))));
  }
  return places;
}

// Days of texts that all say a time, as those of a StartTime do; none where one does not.
std::vector<double> days_of(const std::vector<std::string>& texts) {
  std::vector<double> days;
  for (const std::string& text : texts) {
    const Parsed<Instant> instant = parse_utc(text);
    if (!instant) return {};
    days.push_back(utc_days(*instant.value));
  }
  return days;
}

// A parameter's values, and the classes that they put cases in.
struct ParameterValues {
  bool is_text = false;
  std::vector<double> values;
  std::vector<std::size_t> classes;
};

ParameterValues parameter_values(const StudyResults& results, std::size_t column) {
  ParameterValues of;
  of.is_text = results.columns[column].type == ColumnType::text;
  of.values = of.is_text ? days_of(results.texts(column)) : results.numbers(column);
  if (of.is_text && of.values.empty()) {
    of.values = places_of(results.texts(column));
  } else {
    of.is_text = false;
  }
  if (of.is_text) {
    for (const double place : of.values) of.classes.push_back(static_cast<std::size_t>(place));
  } else if (std::ranges::all_of(of.values, [](double value) { return std::isfinite(value); })) {
    of.classes = classes_of(of.values);
  }
  return of;
}

// Marks what is more than chance among all that have a probability.
template <class Probability, class Mark>
void mark_found(std::vector<std::vector<InfluenceCell>>& cells, Probability probability,
                Mark mark) {
  std::vector<double> p;
  std::vector<InfluenceCell*> of;
  for (auto& row : cells) {
    for (InfluenceCell& cell : row) {
      const std::optional<double> found = probability(cell);
      if (!found) continue;
      p.push_back(*found);
      of.push_back(&cell);
    }
  }
  const std::vector<bool> found = discoveries(p, false_rate);
  for (std::size_t i = 0; i < of.size(); ++i) mark(*of[i], found[i]);
}

}  // namespace

std::vector<StudyNumber> study_numbers(const StudyResults& results) {
  std::vector<StudyNumber> numbers{
      {completed_number, {}, "", "Whether the mission completed: 1 or 0.", {}}};
  for (const std::string& status : results.texts(results.column("status"))) {
    numbers.front().values.push_back(status == not_run_status ? std::nan("")
                                     : status == "completed"  ? 1
                                                              : 0);
  }
  for (const Kind kind : {Kind::gathered, Kind::summary}) {
    for (std::size_t i = 0; i < results.columns.size(); ++i) {
      const StudyColumn& column = results.columns[i];
      const bool is_of_all = column.name == "case" || column.name == "seed";
      if (column.kind != kind || column.type == ColumnType::text || is_of_all) continue;
      StudyNumber number{column.name, i, column.unit, column.sentence, results.numbers(i)};
      if (kind == Kind::gathered || varies(number.values)) numbers.push_back(std::move(number));
    }
  }
  return numbers;
}

Influence influence(const StudyResults& results, const std::vector<StudyNumber>& numbers,
                    bool has_shares) {
  Influence found;
  std::vector<ParameterValues> parameters;
  for (std::size_t i = 0; i < results.columns.size(); ++i) {
    if (results.columns[i].kind != Kind::parameter) continue;
    ParameterValues values = parameter_values(results, i);
    if (!varies(values.values)) continue;
    found.parameters.push_back(i);
    parameters.push_back(std::move(values));
  }
  for (const StudyNumber& number : numbers) {
    std::vector<InfluenceCell>& row = found.cells.emplace_back();
    for (const ParameterValues& parameter : parameters) {
      InfluenceCell& cell = row.emplace_back();
      if (!parameter.is_text) cell.correlation = rank_correlation(parameter.values, number.values);
      if (has_shares) cell.share = first_order_share(parameter.classes, number.values);
    }
  }
  mark_found(
      found.cells,
      [](const InfluenceCell& cell) {
        return cell.correlation ? cell.correlation->p : std::nullopt;
      },
      [](InfluenceCell& cell, bool is_found) { cell.is_found = is_found; });
  mark_found(
      found.cells,
      [](const InfluenceCell& cell) {
        return cell.share ? std::optional(cell.share->p) : std::nullopt;
      },
      [](InfluenceCell& cell, bool is_found) { cell.is_share_found = is_found; });
  return found;
}

}  // namespace lsos
