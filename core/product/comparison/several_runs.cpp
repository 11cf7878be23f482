#include "product/comparison/several_runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "base/error.h"

namespace lsos {

namespace {

// Dark for the trunk; the others are apart from each other on white and on the grey of the map.
constexpr std::array<std::string_view, runs_max> colours{"#17212b", "#d7263d", "#1f6fd6", "#1a9641",
                                                         "#f07f13", "#8e24aa", "#0097a7", "#b8860b",
                                                         "#e83fa8", "#7a5230", "#7cb518"};

// Values that are not modelled are equal to each other.
bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool is_same(const EventRow& a, const EventRow& b) {
  return a.status == b.status && a.start == b.start && a.end == b.end &&
         is_same(a.distance_m, b.distance_m) && is_same(a.energy_used_j, b.energy_used_j);
}

}  // namespace

bool EventOutcomes::differs(std::size_t run) const {
  const std::optional<EventRow>&first = runs.front(), &other = runs.at(run);
  if (!first || !other) return first.has_value() != other.has_value();
  return !is_same(*first, *other);
}

std::string run_name(std::size_t run) {
  LSOS_ASSERT(run < runs_max);
  return {static_cast<char>('A' + run)};
}

std::string run_colour(std::size_t run) { return std::string(colours.at(run)); }

std::vector<EventOutcomes> differing_events(const std::vector<RunOutcome>& runs) {
  std::map<std::pair<std::string, std::int64_t>, EventOutcomes> by_key;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    for (const EventRow& event : runs[k].events) {
      EventOutcomes& outcomes = by_key[{event.rover_id, event.sequence}];
      if (outcomes.runs.empty()) {
        outcomes = {event.rover_id, event.sequence, event.label, {}};
        outcomes.runs.resize(runs.size());
      }
      outcomes.runs[k] = event;
    }
  }
  std::vector<EventOutcomes> differing;
  for (auto& [key, outcomes] : by_key) {
    bool differs = false;
    for (std::size_t k = 1; k < runs.size(); ++k) differs |= outcomes.differs(k);
    if (differs) differing.push_back(std::move(outcomes));
  }
  return differing;
}

bool SeveralRuns::are_equal() const {
  return std::ranges::all_of(with_first, &Comparison::is_equal);
}

SeveralRuns compare_several(std::vector<RunOutcome> runs,
                            const std::vector<ComparedRun>& compared) {
  LSOS_ASSERT(runs.size() == compared.size() && runs.size() <= runs_max);
  SeveralRuns several;
  several.events = differing_events(runs);
  for (std::size_t k = 1; k < compared.size(); ++k) {
    several.with_first.push_back(compare(compared.front(), compared[k]));
  }
  several.runs = std::move(runs);
  return several;
}

}  // namespace lsos
