#include "plan/references.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
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
      if (draft.on_failure != nullptr) read_on_failure(draft);
    }
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
        {draft.event.place.file, field.line},
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

  void read_on_failure(DraftEvent& draft) {
    constexpr std::array<std::pair<std::string_view, OnFailure>, 3> words{
        {{"stop", OnFailure::stop}, {"skip", OnFailure::skip}, {"abort", OnFailure::abort}}};
    const std::string& text = draft.on_failure->text;
    for (const auto& [word, meaning] : words) {
      if (text == word) {
        draft.event.on_failure = meaning;
        return;
      }
    }
    if (text == "goto") {
      error(draft, *draft.on_failure, "goto wants the label of a later event of the rover");
    } else if (text.starts_with("goto ") || text.starts_with("goto\t")) {
      read_go_to(draft, unescaped(std::string(trimmed(text.substr(5)))));
    } else {
      const std::vector<std::string> known{"stop", "skip", "abort", "goto LABEL"};
      error(draft, *draft.on_failure,
            fmt::format("must be one of {}{}", listed(known),
                        text.size() > 20 ? "" : did_you_mean(text, known)));
    }
  }

  void read_go_to(DraftEvent& draft, const std::string& label) {
    const Indices found = meanings(label);
    if (found.empty() && !may_be_unplaced(label)) {
      error(draft, *draft.on_failure,
            fmt::format("there is no event {}{}", shown(label), suggestions_(label)));
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
      error(draft, *draft.on_failure,
            fmt::format("{} is no later event of rover {}", choices(found),
                        quoted(draft.event.rover_id)));
    } else if (later.size() > 1) {
      error(draft, *draft.on_failure,
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

}  // namespace lsos
