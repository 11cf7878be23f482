#include "base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace lsos {

std::string to_string(const Fault& fault) {
  const std::string_view level = fault.severity == Severity::warning ? "warning: " : "";
  if (fault.place.file.empty()) return fmt::format("{}{}", level, fault.what);
  if (fault.place.line == 0) return fmt::format("{}: {}{}", fault.place.file, level, fault.what);
  return fmt::format("{}:{}{}: {}{}", fault.place.file, fault.place.column, fault.place.line, level,
                     fault.what);
}

namespace {

std::string joined(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) {
    if (!text.empty()) text += '\n';
    text += to_string(fault);
  }
  return text;
}

}  // namespace

InputError::InputError(std::vector<Fault> faults)
    : std::runtime_error(joined(faults)), faults_(std::move(faults)) {}

InputError::InputError(Place place, std::string what)
    : InputError({Fault{Severity::error, std::move(place), std::move(what)}}) {}

void Faults::error(Place place, std::string what) {
  faults_.push_back({Severity::error, std::move(place), std::move(what)});
}

void Faults::warning(Place place, std::string what) {
  faults_.push_back({Severity::warning, std::move(place), std::move(what)});
}

void Faults::add(const std::vector<Fault>& faults) {
  faults_.insert(faults_.end(), faults.begin(), faults.end());
}

bool Faults::has_errors() const {
  return std::ranges::any_of(faults_, [](const Fault& f) { return f.severity == Severity::error; });
}

std::vector<Fault> Faults::sorted() const {
  // A fault in a script is found by everything that names the script; it is listed once.
  std::vector<Fault> sorted;
  for (const Fault& fault : faults_) {
    const bool is_listed = std::ranges::any_of(sorted, [&](const Fault& listed) {
      return listed.place == fault.place && listed.severity == fault.severity &&
             listed.what == fault.what;
    });
    if (!is_listed) sorted.push_back(fault);
  }
  std::ranges::stable_sort(sorted, {}, &Fault::place);
  return sorted;
}

void Faults::throw_if_errors() const {
  std::vector<Fault> errors = sorted();
  std::erase_if(errors, [](const Fault& f) { return f.severity != Severity::error; });
  if (!errors.empty()) throw InputError(std::move(errors));
}

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int substituted = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

std::string did_you_mean(std::string_view name, std::span<const std::string> known) {
  constexpr std::size_t name_bytes_max = 64;  // no known name is longer; the cost is quadratic
  if (name.size() > name_bytes_max) return "";
  const auto lower = [](std::string_view text) {
    std::string copy(text);
    std::ranges::transform(copy, copy.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return copy;
  };
  const std::string wanted = lower(name);
  const std::string* nearest = nullptr;
  int best = static_cast<int>(name.size()) / 3 + 2;  // a larger distance is hardly a typing error
  for (const std::string& candidate : known) {
    const std::string other = lower(candidate);
    const int distance = edit_distance(wanted, other);
    // One or two letters, such as a rover's id, are near to each other whatever they are.
    const bool is_short = std::max(wanted.size(), other.size()) < 3;
    const bool begins = wanted.starts_with(other) || other.starts_with(wanted);
    if (distance < best && (!is_short || begins)) {
      best = distance;
      nearest = &candidate;
    }
  }
  return nearest == nullptr ? "" : fmt::format("; did you mean '{}'?", *nearest);
}

void assertion_failed(const char* condition, const char* file, int line) {
  throw InternalError(fmt::format("{}:{}: broken promise: {}", file, line, condition));
}

}  // namespace lsos
