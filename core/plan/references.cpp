#include "plan/references.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "base/quantity.h"
#include "base/text.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

using Indices = std::vector<std::size_t>;
using Parts =
    std::pair<std::string, std::string>;  // of a reference; `anything`: that part is unknown
constexpr const char* anything = "*";

// goto names one event, so a comma needs no escape there; one that has it is understood.
std::string unescaped(std::string text) {
  for (std::size_t at = text.find("\\,"); at != std::string::npos; at = text.find("\\,", at)) {
    text.erase(at, 1);
  }
  return text;
}

std::string escaped(const std::string& label) {
  std::string text;
  for (const char c : label) text += c == ',' ? "\\," : std::string(1, c);
  return text;
}

// The parts into which split_references() splits a label whose commas are not escaped, joined again
// by commas.
std::string joined_parts(const std::string& label) {
  std::string joined;
  for (const std::string& part : split_references(label)) {
    joined += (joined.empty() ? "" : ",") + part;
  }
  return joined;
}

// What OnFailure says, before a label is resolved.
struct FailureRule {
  OnFailure what = OnFailure::stop;
  std::string label;  // with OnFailure::go_to
};

// Where an OnFailure stands, for messages.
struct FailurePlace {
  std::string subject;
  Place place;
  std::string text;
};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

class Resolver {
 public:
  Resolver(std::vector<DraftEvent>& drafts, Faults& faults) : drafts_(drafts), faults_(faults) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < drafts.size(); ++i) {
      const PlanEvent& event = drafts[i].event;
      if (!drafts[i].is_placed) add_unplaced(drafts[i]);
      if (!event.label.empty()) by_label_[event.label].push_back(i);
      if (!event.label.empty()) names.push_back(event.label);
      if (event.label.find(',') != std::string::npos) {
        labels_with_commas_[joined_parts(event.label)] = event.label;
      }
      by_identity_[{event.rover_id, event.sequence}].push_back(i);
    }
    suggestions_ = Suggestions(std::move(names));
  }

  void run() {
    for (DraftEvent& draft : drafts_) {
      if (draft.start_after != nullptr) read_start_after(draft);
      if (draft.on_failure == nullptr) continue;
      const FailurePlace place{
          draft.subject, {draft.event.place.file, draft.on_failure->line}, draft.on_failure->text};
      const auto rule = read_rule(place, "a later event of the rover");
      if (!rule) continue;
      if (rule->what == OnFailure::go_to) {
        read_go_to(draft, place, rule->label);
      } else {
        draft.event.on_failure = rule->what;
      }
    }
  }

  // Gives the events of `rovers` that say nothing of their own what OnFailure says of them all;
  // returns their number.
  int apply_default(const FailurePlace& place, const std::vector<std::string>& rovers) {
    const auto rule = read_rule(place, "an event");
    if (!rule) return 0;
    const bool goes = rule->what == OnFailure::go_to;
    const Indices targets = goes ? default_targets(place, rule->label, rovers) : Indices{};
    int count = 0;
    for (DraftEvent& draft : drafts_) {
      PlanEvent& event = draft.event;
      if (!draft.takes_default_on_failure || !contains(rovers, event.rover_id)) continue;
      if (goes) {
        const auto next = std::ranges::find_if(targets, [&](std::size_t i) {
          const PlanEvent& target = drafts_[i].event;
          return target.rover_id == event.rover_id && target.sequence > event.sequence;
        });
        if (next == targets.end() || !draft.is_placed || event.at) continue;
        event.go_to_sequence = drafts_[*next].event.sequence;
      }
      event.on_failure = rule->what;
      draft.takes_default_on_failure = false;
      ++count;
    }
    return count;
  }

 private:
  // All events that the reference can mean, as a label or as ROVER/SEQUENCE.
  Indices meanings(const std::string& reference) const {
    Indices found;
    const auto labelled = by_label_.find(reference);
    if (labelled != by_label_.end()) found = labelled->second;
    const std::size_t slash = reference.rfind('/');
    if (slash != std::string::npos) {
      const Parsed<std::int64_t> sequence = parse_integer(reference.substr(slash + 1));
      if (sequence) {
        const auto identified =
            by_identity_.find({std::string(trimmed(reference.substr(0, slash))), *sequence.value});
        if (identified != by_identity_.end()) {
          found.insert(found.end(), identified->second.begin(), identified->second.end());
        }
      }
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  bool are_placed(const Indices& events) const {
    return std::ranges::all_of(events, [&](std::size_t i) { return drafts_[i].is_placed; });
  }

  // Whether the reference may mean an event whose rover or Sequence, and with it the default label,
  // cannot be read.
  bool may_be_unplaced(const std::string& reference) const {
    const auto is_in = [&](const std::set<Parts>& known, char between) {
      const std::size_t at = reference.rfind(between);
      if (at == std::string::npos) return false;
      const std::string first(trimmed(reference.substr(0, at)));
      const std::string second(trimmed(reference.substr(at + 1)));
      return known.contains({first, second}) || known.contains({anything, second}) ||
             known.contains({first, anything}) || known.contains({anything, anything});
    };
    return is_in(unplaced_, '/') || is_in(unplaced_labels_, ' ');
  }

  void add_unplaced(const DraftEvent& draft) {
    const PlanEvent& event = draft.event;
    const std::string sequence =
        draft.is_sequence_known ? std::to_string(event.sequence) : anything;
    unplaced_.insert({draft.is_rover_known ? event.rover_id : anything, sequence});
    if (!draft.has_default_label) return;
    unplaced_labels_.insert({draft.is_read ? event.type : anything, sequence});
  }

  std::string choices(const Indices& indices) const {
    std::vector<std::string> names;
    for (const std::size_t i : indices) names.push_back(named(drafts_[i]));
    return listed(names);
  }

  void error(const DraftEvent& draft, const SourceField& field, const std::string& what) {
    faults_.error(
        {draft.event.place.file, field.line, field.column},
        fmt::format("{}: {} = {}: {}", draft.subject, field.name, shown(field.text), what));
  }

  // Reports parts from `first` on that together are one label with commas; returns their number, or
  // 0 when they are none.
  std::size_t report_label_with_commas(const DraftEvent& draft,
                                       const std::vector<std::string>& parts, std::size_t first) {
    std::string joined = parts[first];
    for (std::size_t next = first + 1; next < parts.size(); ++next) {
      joined += "," + parts[next];
      const auto known = labels_with_commas_.find(joined);
      if (known == labels_with_commas_.end()) continue;
      error(draft, *draft.start_after,
            fmt::format("of the event {} the comma must be written '\\,': {}",
                        quoted(known->second), quoted(escaped(known->second))));
      return next + 1 - first;
    }
    return 0;
  }

  void read_start_after(DraftEvent& draft) {
    std::vector<PlanEvent::Reference>& awaited = draft.event.start_after;
    const std::vector<std::string> parts = split_references(draft.start_after->text);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::string& reference = parts[k];
      const Indices found = meanings(reference);
      if (found.empty()) {
        if (const std::size_t count = report_label_with_commas(draft, parts, k); count > 0) {
          k += count - 1;
          continue;
        }
      }
      if (reference.empty()) {
        error(draft, *draft.start_after, "names nothing between two commas");
      } else if (found.empty()) {
        if (may_be_unplaced(reference)) continue;
        error(draft, *draft.start_after,
              fmt::format("there is no event {}{}", shown(reference), suggestions_(reference)));
      } else if (found.size() > 1) {
        // Two events with the same Sequence have been reported already.
        if (!are_placed(found)) continue;
        error(draft, *draft.start_after,
              fmt::format("{} can be {}; ROVER/SEQUENCE says which", shown(reference),
                          choices(found)));
      } else {
        const PlanEvent& event = drafts_[found.front()].event;
        awaited.push_back({event.rover_id, event.sequence});
        if (!event.is_enabled && draft.event.is_enabled) {
          faults_.warning({draft.event.place.file, draft.start_after->line},
                          fmt::format("{}: StartAfter = {}: is disabled, and counts as ended from "
                                      "the beginning",
                                      draft.subject, shown(reference)));
        }
      }
    }
    std::ranges::sort(awaited);
    awaited.erase(std::unique(awaited.begin(), awaited.end()), awaited.end());
  }

  void error(const FailurePlace& place, const std::string& what) {
    faults_.error(place.place,
                  fmt::format("{}: OnFailure = {}: {}", place.subject, shown(place.text), what));
  }

  // Absent after a fault. `wanted`: what a goto may name.
  std::optional<FailureRule> read_rule(const FailurePlace& place, const char* wanted) {
    constexpr std::array<std::pair<std::string_view, OnFailure>, 3> words{
        {{"stop", OnFailure::stop}, {"skip", OnFailure::skip}, {"abort", OnFailure::abort}}};
    const std::string& text = place.text;
    for (const auto& [word, meaning] : words) {
      if (text == word) return FailureRule{meaning, ""};
    }
    if (text == "goto") {
      error(place, fmt::format("goto wants the label of {}", wanted));
    } else if (text.starts_with("goto ") || text.starts_with("goto\t")) {
      return FailureRule{OnFailure::go_to, unescaped(std::string(trimmed(text.substr(5))))};
    } else {
      const std::vector<std::string> known{"stop", "skip", "abort", "goto LABEL"};
      error(place, fmt::format("must be one of {}{}", listed(known),
                               text.size() > 20 ? "" : did_you_mean(text, known)));
    }
    return {};
  }

  // The events of `rovers` that a default of goto LABEL means, in order of rover and sequence; it
  // is a fault that there are none.
  Indices default_targets(const FailurePlace& place, const std::string& label,
                          const std::vector<std::string>& rovers) {
    const Indices found = meanings(label);
    if (!are_placed(found)) return {};
    Indices targets, timed;
    for (const std::size_t i : found) {
      const PlanEvent& event = drafts_[i].event;
      if (contains(rovers, event.rover_id)) (event.at ? timed : targets).push_back(i);
    }
    const bool is_for_none = rovers.empty() && !found.empty();  // each rover has one of its own
    if (!targets.empty() || is_for_none || may_be_unplaced(label)) return targets;
    if (found.empty()) {
      error(place, fmt::format("there is no event {}{}", shown(label), suggestions_(label)));
    } else if (timed.empty()) {
      error(place, fmt::format("{} is no event of {}", choices(found),
                               rovers.size() == 1 ? fmt::format("rover {}", quoted(rovers.front()))
                                                  : "a rover that it is for"));
    } else {
      error(place,
            fmt::format("{} takes effect at a time of its own, without a turn", choices(timed)));
    }
    return {};
  }

  void read_go_to(DraftEvent& draft, const FailurePlace& place, const std::string& label) {
    const Indices found = meanings(label);
    if (found.empty() && !may_be_unplaced(label)) {
      error(place, fmt::format("there is no event {}{}", shown(label), suggestions_(label)));
    }
    if (found.empty() || !draft.is_placed || !are_placed(found)) return;
    Indices later;
    for (const std::size_t i : found) {
      const PlanEvent& event = drafts_[i].event;
      if (event.rover_id == draft.event.rover_id && event.sequence > draft.event.sequence) {
        later.push_back(i);
      }
    }
    if (later.empty()) {
      error(place, fmt::format("{} is no later event of rover {}", choices(found),
                               quoted(draft.event.rover_id)));
    } else if (later.size() > 1) {
      error(place,
            fmt::format("{} can be {}; ROVER/SEQUENCE says which", shown(label), choices(later)));
    } else {
      draft.event.on_failure = OnFailure::go_to;
      draft.event.go_to_sequence = drafts_[later.front()].event.sequence;
    }
  }

  std::vector<DraftEvent>& drafts_;
  Faults& faults_;
  std::set<Parts> unplaced_;         // rover and Sequence
  std::set<Parts> unplaced_labels_;  // type and Sequence, of events without a name
  std::map<std::string, Indices> by_label_;
  std::map<std::string, std::string> labels_with_commas_;  // by joined_parts() of the label
  std::map<std::pair<std::string, std::int64_t>, Indices> by_identity_;
  Suggestions suggestions_;
};

}  // namespace

std::vector<std::string> split_references(const std::string& text) {
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] == ',') {
      parts.back() += text[++i];
    } else if (text[i] == ',') {
      parts.emplace_back();
    } else {
      parts.back() += text[i];
    }
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

void resolve_references(std::vector<DraftEvent>& drafts, Faults& faults) {
  Resolver(drafts, faults).run();
}

std::vector<std::string> apply_failure_defaults(std::vector<DraftEvent>& drafts,
                                                const MissionInfo& mission,
                                                const std::vector<PlanRover>& rovers,
                                                Faults& faults) {
  std::vector<std::string> lines, others;
  Resolver resolver(drafts, faults);
  const auto apply = [&](const FailurePlace& place, const std::vector<std::string>& ids) {
    const int count = resolver.apply_default(place, ids);
    if (count == 0) return;
    lines.push_back(fmt::format("{}: OnFailure = {} ({} of {} events)", place.subject, place.text,
                                count, drafts.size()));
  };
  for (const PlanRover& rover : rovers) {
    const auto& [text, line] = rover.on_failure;
    if (text.empty()) {
      others.push_back(rover.id);
    } else {
      apply({fmt::format("Rover {}", quoted(rover.id)), {rover.place.file, line}, text},
            {rover.id});
    }
  }
  const auto& [text, line] = mission.on_failure;
  if (!text.empty()) apply({"MissionInfo", {mission.place.file, line}, text}, others);
  return lines;
}

}  // namespace lsos
