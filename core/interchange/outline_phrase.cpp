#include "interchange/outline_phrase.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/replaced.h"
#include "interchange/columns.h"

namespace lsos {

namespace {

const std::string* field_named(const OutlineFields& fields, const std::string& name) {
  const auto found = std::ranges::find(fields, name, &std::pair<std::string, std::string>::first);
  return found == fields.end() ? nullptr : &found->second;
}

// "Ridge > Gate" of the column Place's "Ridge; Gate"; coordinates stand in brackets.
std::string place_words(const std::string& place) {
  const bool is_tuple =
      !place.empty() && place.find_first_not_of("0123456789.,-+eE ") == std::string::npos;
  return is_tuple ? fmt::format("({})", place) : replaced(place, "; ", " > ");
}

// How to say an event of a type: words, and for each field what stands before its value.
struct Phrase {
  const char* type;
  const char* words;
  struct Part {
    const char* field;
    const char* before;  // " at "
    bool is_needed;
  };
  std::vector<Part> parts;
};

const std::vector<Phrase>& phrases() {
  static const std::vector<Phrase> all{
      {"PathPlanRoute", "drive to", {{column::place, " ", true}, {"Speed", " at ", false}}},
      {"Route", "drive along", {{column::place, " ", true}, {"Speed", " at ", false}}},
      {"Route", "drive straight to", {{column::place, " ", true}, {"Speed", " at ", false}}},
      {"Wait", "wait until", {{"Until", " ", true}, {column::place, " at ", false}}},
      {"Pause", "pause", {{"Duration", " ", true}, {column::place, " at ", false}}},
      {"EVA", "EVA", {{"ActivityDuration", " ", false}, {column::place, " at ", false}}},
      {"Recharge",
       "recharge",
       {{"UntilCharge", " to ", true}, {"From", " from ", false}, {column::place, " at ", false}}},
      {"Recharge",
       "recharge",
       {{"Duration", " ", true}, {"From", " from ", false}, {column::place, " at ", false}}},
      {"DeploySP", "deploy panel", {{"Panel", " ", true}, {column::place, " at ", false}}},
      {"DeploySP", "deploy panels", {{column::place, " at ", false}}},
      {"StowSP", "stow panel", {{"Panel", " ", true}, {column::place, " at ", false}}},
      {"StowSP", "stow panels", {{column::place, " at ", false}}},
      {"DeployCA", "deploy antenna", {{"Asset", " ", false}, {column::place, " at ", false}}},
      {"StowCA", "stow antenna", {{"Asset", " ", false}, {column::place, " at ", false}}},
      {"SteerSP", "track the Sun", {{"Mode", "", true}, {column::place, " at ", false}}},
      {"Sample", "sample", {{"Duration", " ", false}, {column::place, " at ", false}}},
      {"Drill", "drill", {{"Duration", " ", false}, {column::place, " at ", false}}},
      {"Follow", "follow", {{"Leader", " ", true}, {"Distance", " at ", false}}}};
  return all;
}

// The phrase with its values; absent where a field that it needs is not there. `said` receives the
// names of the fields that it says.
std::optional<std::string> said_by(const Phrase& phrase, const OutlineFields& fields,
                                   std::vector<std::string>& said) {
  std::string text = phrase.words;
  const std::string* place = field_named(fields, column::place);
  const bool is_drawn = place != nullptr && place->starts_with("LINESTRING");
  if (text == "drive along" && !is_drawn) return {};
  for (const Phrase::Part& part : phrase.parts) {
    const std::string* value = field_named(fields, part.field);
    if (value == nullptr) {
      if (part.is_needed) return {};
      continue;
    }
    said.emplace_back(part.field);
    if (part.before[0] == '\0') continue;  // the words imply the value
    const bool is_place = part.field == std::string_view(column::place);
    text += part.before + (is_place ? place_words(*value) : *value);
  }
  return text;
}

OutlineFields sorted(OutlineFields fields) {
  std::ranges::sort(fields);
  return fields;
}

}  // namespace

std::string value_text(const std::string& text) {
  const bool is_plain = text.find_first_of(",;\"()\n#") == std::string::npos;
  return is_plain ? text : in_quotes(text);
}

std::string field_list(const OutlineFields& fields, const std::vector<std::string>& left_out) {
  std::string text;
  const auto add = [&](const std::string& name, const std::string& value) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, value_text(value));
  };
  for (const auto& [name, value] : fields) {
    if (name == column::name || name == column::description) continue;
    if (std::ranges::find(left_out, name) == left_out.end()) add(name, value);
  }
  if (const std::string* name = field_named(fields, column::name)) add("as", *name);
  if (const std::string* note = field_named(fields, column::description)) add("note", *note);
  return text;
}

std::string item_of(const OutlineFields& fields, const Declarations& declarations) {
  const std::string& type = *field_named(fields, column::type);
  const std::string *start = field_named(fields, "StartTime"),
                    *place = field_named(fields, column::place);
  const std::string time = start == nullptr ? "" : *start + " ";
  const auto whole = [&](const std::string& words, std::vector<std::string> said) {
    said.insert(said.end(), {column::type, "StartTime"});
    const std::string rest = field_list(fields, said);
    return time + words + (rest.empty() ? "" : ", ") + rest;
  };
  for (const Phrase& phrase : phrases()) {
    if (phrase.type != type) continue;
    std::vector<std::string> said;
    const std::optional<std::string> words = said_by(phrase, fields, said);
    if (!words) continue;
    const bool lacks_place =
        place != nullptr && std::ranges::find(said, column::place) == said.end();
    if (lacks_place) continue;
    const std::string item = whole(*words, said);
    const Parsed<OutlineFields> read = parse_item(item, declarations);
    if (read && sorted(*read.value) == sorted(fields)) return item;
  }
  return whole(place == nullptr ? type : type + " at " + place_words(*place), {column::place});
}

}  // namespace lsos
