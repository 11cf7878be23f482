#include "interchange/outline_item.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "base/quantity.h"
#include "base/text.h"
#include "interchange/cell_text.h"
#include "interchange/clock_text.h"
#include "interchange/columns.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// What follows `words` at the beginning of the text, in any case of letters; absent when it begins
// otherwise. "drive to" begins "Drive to Ridge", not "drive together".
std::optional<std::string_view> after(std::string_view text, std::string_view words) {
  if (text.size() < words.size() || lower_case(text.substr(0, words.size())) != words) return {};
  const std::string_view rest = text.substr(words.size());
  if (!rest.empty() && rest[0] != ' ' && rest[0] != '\t') return {};
  return trimmed(rest);
}

// Splits "Ridge at 5 km/h" at the last " at "; the second part is "" without one.
std::pair<std::string_view, std::string_view> split_at_word(std::string_view text,
                                                            std::string_view word) {
  const std::string in_blanks = fmt::format(" {} ", word);
  const std::size_t at = lower_case(text).rfind(in_blanks);
  if (at == std::string::npos) return {text, {}};
  return {trimmed(text.substr(0, at)), trimmed(text.substr(at + in_blanks.size()))};
}

bool is_quantity(std::string_view text, const char* unit) {
  const Unit& own = *find_unit(unit);
  return static_cast<bool>(parse_quantity(with_known_unit(std::string(text), own.kind), own));
}

// One way to say an event. `fill` adds its fields from the text after the verb, and returns false
// where that text is none.
struct Verb {
  std::string_view words;
  const char* type;
  bool (*fill)(std::string_view rest, OutlineFields& fields);
  std::string_view example;
  bool may_say_where = true;  // with " at Ridge" at its end
};

bool fill_drive(std::string_view rest, OutlineFields& fields) {
  auto [place, speed] = split_at_word(rest, "at");
  if (!speed.empty() && !is_quantity(speed, "m/s")) {
    place = rest;
    speed = {};
  }
  if (place.empty()) return false;
  fields.emplace_back(column::place, place_text(place));
  if (!speed.empty()) fields.emplace_back("Speed", speed);
  return true;
}

bool fill_duration(const char* field, std::string_view rest, OutlineFields& fields) {
  if (const auto without_for = after(rest, "for")) rest = *without_for;
  if (rest.empty()) return true;
  if (!is_quantity(rest, "s") && !clock_s(rest)) return false;
  fields.emplace_back(field, rest);
  return true;
}

bool fill_activity(std::string_view rest, OutlineFields& fields) {
  return fill_duration("ActivityDuration", rest, fields);
}
bool fill_stay(std::string_view rest, OutlineFields& fields) {
  return fill_duration("Duration", rest, fields);
}
bool fill_until(std::string_view rest, OutlineFields& fields) {
  fields.emplace_back("Until", rest);
  return !rest.empty();
}

bool fill_recharge(std::string_view rest, OutlineFields& fields) {
  auto [how, from] = split_at_word(rest, "from");
  if (const auto asset = after(rest, "from")) {
    how = {};
    from = *asset;
  }
  if (!from.empty()) fields.emplace_back("From", from);
  if (const auto level = after(how, "to")) {
    fields.emplace_back("UntilCharge", *level);
    return is_quantity(*level, "1");
  }
  return fill_stay(how, fields);
}

bool fill_panel(std::string_view rest, OutlineFields& fields) {
  if (!rest.empty()) fields.emplace_back("Panel", rest);
  return true;
}
bool fill_antenna(std::string_view rest, OutlineFields& fields) {
  if (!rest.empty()) fields.emplace_back("Asset", rest);
  return true;
}
bool fill_track(std::string_view rest, OutlineFields& fields) {
  fields.emplace_back("Mode", "track");
  return rest.empty();
}
bool fill_follow(std::string_view rest, OutlineFields& fields) {
  auto [leader, distance] = split_at_word(rest, "at");
  fields.emplace_back("Leader", leader);
  if (!distance.empty()) fields.emplace_back("Distance", distance);
  return !leader.empty();
}

// Longer phrases stand before those that they begin with.
constexpr Verb verbs[] = {
    {"drive to", "PathPlanRoute", fill_drive, "drive to Ridge at 5 km/h", false},
    {"drive along", "Route", fill_drive, "drive along Traverse 1", false},
    {"drive straight to", "Route", fill_drive, "drive straight to Ridge", false},
    {"wait until", "Wait", fill_until, "wait until 08:00"},
    {"wait", "Pause", fill_stay, "wait 30 min"},
    {"pause", "Pause", fill_stay, "pause 30 min"},
    {"eva", "EVA", fill_activity, "EVA 2 h"},
    {"recharge", "Recharge", fill_recharge, "recharge to 80 %"},
    {"deploy panels", "DeploySP", fill_panel, "deploy panels"},
    {"deploy panel", "DeploySP", fill_panel, "deploy panel array"},
    {"stow panels", "StowSP", fill_panel, "stow panels"},
    {"stow panel", "StowSP", fill_panel, "stow panel array"},
    {"deploy antenna", "DeployCA", fill_antenna, "deploy antenna hga"},
    {"stow antenna", "StowCA", fill_antenna, "stow antenna hga"},
    {"track the sun", "SteerSP", fill_track, "track the Sun"},
    {"sample", "Sample", fill_stay, "sample 20 min"},
    {"drill", "Drill", fill_stay, "drill 1 h"},
    {"follow", "Follow", fill_follow, "follow SEV A at 30 m", false},
};

std::string what_would_be(std::string_view words) {
  std::vector<std::string> examples;
  const Verb* nearest = nullptr;
  int nearest_distance = 4;
  for (const Verb& verb : verbs) {
    examples.emplace_back(verb.example);
    const int distance = edit_distance(lower_case(words.substr(0, verb.words.size())), verb.words);
    const auto a_third = static_cast<int>(verb.words.size()) / 3;
    if (distance >= nearest_distance || distance > a_third) continue;
    nearest = &verb;
    nearest_distance = distance;
  }
  if (nearest != nullptr) return fmt::format("; did you mean '{}'?", nearest->example);
  return fmt::format(
      "; an item is one of: {}; or an event with its fields: Sample, Duration 20 min",
      fmt::join(examples, ", "));
}

// Takes a time from the beginning of an item: "08:00", "+2 h", "2026-07-01T08:00".
std::string_view take_time(std::string_view& item) {
  std::size_t end = item.find(' ');
  std::string_view word = item.substr(0, end);
  if (word.ends_with(':')) word.remove_suffix(1);  // "08:00: drive to Ridge"
  if (word.starts_with('+')) {
    // "+ 2 h" and "+2 h" have their unit in a word of its own.
    for (int words = 0; words < 3 && end != std::string_view::npos; ++words) {
      const std::string_view span = trimmed(item.substr(1, end - 1));
      if (is_quantity(span, "s") &&
          span.find_first_not_of("0123456789.") != std::string_view::npos) {
        break;
      }
      if (clock_s(span)) break;
      end = item.find(' ', end + 1);
    }
  } else if (!clock_s(word) && !(word.size() > 10 && word[4] == '-' && word[7] == '-')) {
    return {};
  }
  std::string_view time = item.substr(0, end);
  if (time.ends_with(':')) time.remove_suffix(1);
  item = end == std::string_view::npos ? std::string_view() : trimmed(item.substr(end));
  // "08:00 - drive to Ridge"
  for (const std::string_view dash : {"- ", "\xe2\x80\x93 ", "\xe2\x80\x94 "}) {
    if (item.starts_with(dash)) item = trimmed(item.substr(dash.size()));
  }
  return time;
}

// "08:00-10:00" or "08:00 - 10:00" at the beginning of an item; "" where it begins otherwise.
std::string_view leading_range(std::string_view item) {
  for (std::size_t blank = item.find(' '), words = 0; words < 3; ++words) {
    const std::string_view text = item.substr(0, blank);
    if (is_range(text)) return text;
    if (blank == std::string_view::npos) break;
    blank = item.find(' ', blank + 1);
  }
  return {};
}

// Takes a clock from the end of an item: "EVA 2 h at 08:00".
std::string_view take_last_clock(std::string_view& item) {
  const auto [words, time] = split_at_word(item, "at");
  if (time.empty() || !clock_s(time)) return {};
  item = words;
  return time;
}

}  // namespace

std::vector<std::string> split_outside(std::string_view text, char separator) {
  std::vector<std::string> parts;
  bool is_quoted = false;
  int depth = 0;
  std::size_t from = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') is_quoted = !is_quoted;
    if (is_quoted) continue;
    if (c == '(') ++depth;
    if (c == ')') depth = std::max(depth - 1, 0);
    if (c != separator || depth > 0) continue;
    parts.emplace_back(trimmed(text.substr(from, i - from)));
    from = i + 1;
  }
  parts.emplace_back(trimmed(text.substr(from)));
  return parts;
}

std::string unquoted(std::string_view text) {
  text = trimmed(text);
  if (text.size() < 2 || text.front() != '"' || text.back() != '"') return std::string(text);
  std::string plain;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    plain += text[i];
    if (text[i] == '"') ++i;
  }
  return plain;
}

std::string in_quotes(const std::string& text) {
  std::string quoted_text = "\"";
  for (const char c : text) {
    quoted_text += c;
    if (c == '"') quoted_text += '"';
  }
  return quoted_text + '"';
}

std::string place_text(std::string_view text) {
  std::vector<std::string> names;
  for (std::string part : split_outside(text, '>')) {
    if (part.size() > 1 && part.front() == '(' && part.back() == ')') {
      part = part.substr(1, part.size() - 2);
    }
    names.push_back(unquoted(part));
  }
  return fmt::format("{}", fmt::join(names, "; "));
}

std::vector<std::string> events_said(std::string_view words, const Declarations& declarations) {
  std::vector<std::string> events;
  const std::string said = lower_case(trimmed(words));
  for (const Verb& verb : verbs) {
    const bool is_said = after(verb.words, said) || after(said, verb.words);
    const bool is_known = declarations.events.contains(verb.type);
    if (said.empty() || !is_said || !is_known) continue;
    if (std::ranges::find(events, verb.type) == events.end()) events.emplace_back(verb.type);
  }
  return events;
}

std::string add_fields(const std::vector<std::string>& parts, std::size_t first,
                       const std::string& type, const Declarations& declarations,
                       OutlineFields& fields) {
  std::vector<std::string> names;
  for (const auto& list : fields_of(type, declarations)) {
    for (const FieldDeclaration& field : list) names.push_back(field.name);
  }
  for (std::size_t i = first; i < parts.size(); ++i) {
    const std::string& part = parts[i];
    if (part.empty()) continue;
    if (const auto label = after(part, "as")) {
      fields.emplace_back(column::name, unquoted(*label));
      continue;
    }
    if (const auto note = after(part, "note")) {
      fields.emplace_back(column::description, unquoted(*note));
      continue;
    }
    const std::size_t blank = std::min(part.find(' '), part.size());
    const std::string word = part.substr(0, blank), value = unquoted(part.substr(blank));
    const auto found = std::ranges::find_if(
        names, [&](const std::string& name) { return lower_case(name) == lower_case(word); });
    if (found != names.end() && !value.empty()) {
      fields.emplace_back(*found, value);
      continue;
    }
    const std::string hint = did_you_mean(word, names);
    return fmt::format("{}: after a comma comes a field of {} and its value{}", quoted(part), type,
                       hint.empty() ? "; there are " + listed(names) : hint);
  }
  return "";
}

Parsed<OutlineFields> parse_item(std::string_view item, const Declarations& declarations) {
  const std::vector<std::string> parts = split_outside(item, ',');
  std::string_view words = parts.front();
  OutlineFields fields;
  if (const std::string_view range = leading_range(words); !range.empty()) {
    return {{}, utc_text(range, {}).why};
  }
  if (const std::string_view time = take_time(words); !time.empty()) {
    fields.emplace_back("StartTime", time);
  }
  if (const std::string_view time = take_last_clock(words); !time.empty()) {
    fields.emplace_back("StartTime", time);
  }
  // "Sample at Ridge", "Sample": an event by its name, before what else begins so.
  auto [name, place] = split_at_word(words, "at");
  std::string type = name_meant(std::string(name), declarations);
  if (declarations.events.contains(type)) {
    if (!place.empty()) fields.emplace_back(column::place, place_text(place));
  } else {
    const auto verb = std::ranges::find_if(verbs, [&](const Verb& each) {
      return after(words, each.words) && declarations.events.contains(each.type);
    });
    if (verb == std::end(verbs)) {
      return {
          {},
          fmt::format("{} is not understood{}", quoted(std::string(words)), what_would_be(words))};
    }
    std::string_view what = *after(words, verb->words);
    if (verb->may_say_where) {
      const auto [before, where] = split_at_word(what, "at");
      if (!where.empty()) fields.emplace_back(column::place, place_text(where));
      what = before;
    }
    if (!verb->fill(what, fields)) {
      return {{},
              fmt::format("{}: {} is written like '{}'", quoted(std::string(words)),
                          quoted(std::string(verb->words)), verb->example)};
    }
    type = verb->type;
  }
  fields.emplace_back(column::type, type);
  const std::string why = add_fields(parts, 1, type, declarations, fields);
  if (!why.empty()) return {{}, why};
  return {std::move(fields), {}};
}

}  // namespace lsos
