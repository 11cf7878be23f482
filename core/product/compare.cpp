#include "product/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "product/column_json.h"
#include "product/quantity_text.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view equal_text = "equal";

class Collector {
 public:
  explicit Collector(std::vector<Difference>& found) : found_(found) {}

  void add(const std::string& of, const std::string& quantity, const Json& a, const Json& b) {
    if (a == b) return;
    Difference difference{of,
                          quantity,
                          a.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
                          b.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
                          {}};
    if (a.is_number() && b.is_number()) difference.change = b.get<double>() - a.get<double>();
    found_.push_back(std::move(difference));
  }
  // Compares each value of two objects; a value that one of them lacks is null.
  void add_all(const std::string& of, const Json& a, const Json& b) {
    for (const auto& [key, value] : a.items()) add(of, key, value, at(b, key));
    for (const auto& [key, value] : b.items()) {
      if (!a.contains(key)) add(of, key, nullptr, value);
    }
  }
  static Json at(const Json& object, const std::string& key) {
    return object.is_object() && object.contains(key) ? object[key] : Json();
  }

 private:
  std::vector<Difference>& found_;
};

// The keys of both objects, each once, sorted.
std::vector<std::string> keys(const Json& a, const Json& b) {
  std::vector<std::string> all;
  for (const Json* object : {&a, &b}) {
    for (const auto& [key, value] : object->items()) all.push_back(key);
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void compare_rovers(const Json& a, const Json& b, Collector& found) {
  for (const std::string& id : keys(a, b)) {
    const std::string of = "rover " + id;
    if (!a.contains(id) || !b.contains(id)) {
      found.add(of, "in the run", a.contains(id), b.contains(id));
    } else {
      found.add_all(of, a[id], b[id]);
    }
  }
}

// Events keyed by rover and sequence.
std::map<std::pair<std::string, std::int64_t>, Json> events_by_key(const Json& summary) {
  std::map<std::pair<std::string, std::int64_t>, Json> events;
  for (const Json& event : summary.value("events", Json::array())) {
    events[{event.at("rover_id").get<std::string>(), event.at("sequence").get<std::int64_t>()}] =
        event;
  }
  return events;
}

void compare_events(const Json& a, const Json& b, Collector& found) {
  auto events_a = events_by_key(a), events_b = events_by_key(b);
  std::map<std::pair<std::string, std::int64_t>, bool> all;
  for (const auto& [key, event] : events_a) all[key] = true;
  for (const auto& [key, event] : events_b) all[key] = true;
  for (const auto& [key, is_there] : all) {
    const bool in_a = events_a.contains(key), in_b = events_b.contains(key);
    const Json& event = in_a ? events_a[key] : events_b[key];
    const std::string of =
        fmt::format("event {}/{} {}", key.first, key.second, event.at("label").get<std::string>());
    if (!in_a || !in_b) {
      found.add(of, "in the run", in_a, in_b);
    } else {
      found.add_all(of, events_a[key], events_b[key]);
    }
  }
}

// Numbers in the units of the report; texts without their quotes.
std::string shown(const std::string& quantity, const std::string& json) {
  const Json value = Json::parse(json, nullptr, false);
  if (value.is_null()) return "-";
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return quantity_text(quantity, value.get<double>());
  if (value.is_string()) return value.get<std::string>();
  return json;
}

bool is_number_of(const std::string& json) { return Json::parse(json).is_number(); }

std::string difference_lines(const std::vector<Difference>& differences) {
  std::string text, of;
  for (const Difference& difference : differences) {
    if (difference.of != of) text += fmt::format("\n{}\n", difference.of);
    of = difference.of;
    const std::string& quantity = difference.quantity;
    const bool is_number = is_number_of(difference.a) || is_number_of(difference.b);
    const std::string label = is_number ? quantity_label(quantity) : quantity;
    const std::string a = shown(quantity, difference.a), b = shown(quantity, difference.b);
    constexpr std::size_t column = 28;
    if (std::max(a.size(), b.size()) > column) {
      text += fmt::format("  {}\n    {}\n    {}\n", label, a, b);
      continue;
    }
    text += fmt::format("  {:<20} {:>28} {:>28}", label, a, b);
    if (difference.change) {
      text += fmt::format(" {:>14}", change_text(quantity, *difference.change));
    }
    text += '\n';
  }
  return text;
}

Json differences_json(const std::vector<Difference>& differences) {
  Json array = Json::array();
  for (const Difference& difference : differences) {
    array.push_back({{"of", difference.of},
                     {"quantity", difference.quantity},
                     {"a", Json::parse(difference.a)},
                     {"b", Json::parse(difference.b)},
                     {"change", difference.change ? Json(*difference.change) : Json()}});
  }
  return array;
}

// A warning without a leading "file:line: ", as plans are named the way they were typed.
std::string without_place(const Json& warning) {
  std::string text = warning.is_string()
                         ? warning.get<std::string>()
                         : warning.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  for (std::size_t end = text.find(": "); end < text.find('\n'); end = text.find(": ", end + 1)) {
    const std::size_t colon = text.find_last_not_of("0123456789", end - 1);
    if (colon != std::string::npos && colon + 1 < end && text[colon] == ':') {
      return text.substr(end + 2);
    }
  }
  return text;
}

std::string dumped(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

LogDigest log_digest(const std::string& summary, const std::string& sha256_of_log) {
  const Json digest = Collector::at(Json::parse(summary), "log_sha256");
  return {sha256_of_log, digest.is_string() ? digest.get<std::string>() : ""};
}

std::string digest_fault(const LogDigest& digest) {
  if (digest.matches()) return "";
  return fmt::format(
      "log.gpkg is not the log that summary.json was written of: log_sha256 is {}, the summary "
      "says {}",
      digest.of_log, digest.of_summary.empty() ? "none" : digest.of_summary);
}

Comparison compare(const ComparedRun& run_a, const ComparedRun& run_b) {
  const Json a = Json::parse(run_a.summary), b = Json::parse(run_b.summary);
  Comparison comparison;
  comparison.logs = {log_digest(run_a.summary, run_a.log_sha256),
                     log_digest(run_b.summary, run_b.log_sha256)};
  Collector found(comparison.differences);
  for (const char* key : {"status", "sim_s"}) {
    found.add("run", key, Collector::at(a, key), Collector::at(b, key));
  }
  compare_rovers(a.value("rovers", Json::object()), b.value("rovers", Json::object()), found);
  compare_events(a, b, found);
  for (const char* key : {"warnings", "assumptions"}) {
    const Json none = Json::array();
    const Json texts_a = a.value(key, none), texts_b = b.value(key, none);
    if (texts_a == texts_b) continue;
    // Each text of one run is matched with one of the other, so a text that occurs twice must occur
    // twice there as well.
    const auto lacking = [](const Json& all, const Json& of) {
      std::multiset<std::string> others;
      for (const Json& text : of) others.insert(without_place(text));
      Json rest = Json::array();
      for (const Json& text : all) {
        const auto same = others.find(without_place(text));
        if (same == others.end()) {
          rest.push_back(text);
        } else {
          others.erase(same);
        }
      }
      return rest;
    };
    const Json only_a = lacking(texts_a, texts_b), only_b = lacking(texts_b, texts_a);
    for (std::size_t k = 0; k < std::max(only_a.size(), only_b.size()); ++k) {
      const auto text_or_null = [&](const Json& texts) {
        return k < texts.size() ? texts[k] : Json();
      };
      found.add("run", key, text_or_null(only_a), text_or_null(only_b));
    }
  }
  Collector(comparison.made_of).add_all("made of", Json(run_a.run), Json(run_b.run));
  return comparison;
}

ExactComparison compare_exactly(const LogReader& a, const LogReader& b) {
  ExactComparison found{{a.sha256(), b.sha256()}, {}};
  if (found.sha256[0] != found.sha256[1]) found.difference = first_difference(a, b);
  return found;
}

std::string to_json(const Comparison& found) {
  return dumped({{"equal", found.is_equal()},
                 {"equal_logs", found.has_equal_logs()},
                 {"log_sha256", {found.logs[0].of_log, found.logs[1].of_log}},
                 {"summary_log_sha256", {found.logs[0].of_summary, found.logs[1].of_summary}},
                 {"differences", differences_json(found.differences)},
                 {"made_of", differences_json(found.made_of)}});
}

std::string to_text(const Comparison& found, const std::array<std::string, 2>& names) {
  std::string text = fmt::format("A {}\nB {}\n", names[0], names[1]);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string fault = digest_fault(found.logs[k]);
    if (!fault.empty()) text += fmt::format("{}: {}\n", k == 0 ? 'A' : 'B', fault);
  }
  if (found.is_equal()) {
    text += fmt::format("{}: every rover and event came to the same; the logs are {}\n", equal_text,
                        found.has_equal_logs() ? "equal too" : "not equal (--exact)");
  } else if (!found.differences.empty()) {
    text += fmt::format("\n  {:<20} {:>28} {:>28} {:>14}", "", "A", "B", "B - A");
    text += difference_lines(found.differences);
  }
  if (!found.made_of.empty()) text += difference_lines(found.made_of);
  return text;
}

std::string to_json(const ExactComparison& found) {
  Json document = {{"equal", !found.difference},
                   {"log_sha256", {found.sha256[0], found.sha256[1]}},
                   {"difference", nullptr}};
  if (const auto& at = found.difference) {
    document["difference"] = {{"layer", at->layer},
                              {"row", at->row},
                              {"column", at->column.empty() ? Json() : Json(at->column)},
                              {"where", at->where},
                              {"a", json_value(at->a)},
                              {"b", json_value(at->b)}};
  }
  return dumped(document);
}

std::string to_text(const ExactComparison& found, const std::array<std::string, 2>& names) {
  if (!found.difference) return fmt::format("{}: log_sha256 {}\n", equal_text, found.sha256[0]);
  const LogDifference& at = *found.difference;
  const auto value = [](const ColumnValue& any) {
    const std::string text = to_text(any);
    return text.empty() ? std::string("NULL") : text;
  };
  std::string text =
      fmt::format("A {}  {}\nB {}  {}\n", names[0], found.sha256[0], names[1], found.sha256[1]);
  text += fmt::format("first difference: layer {}, row {}", at.layer, at.row);
  if (!at.where.empty()) text += fmt::format(" ({})", at.where);
  if (at.column.empty()) {
    const bool only_a = !std::holds_alternative<std::monostate>(at.a);
    return text + fmt::format(": only {} has this row\n", only_a ? "A" : "B");
  }
  if (at.column == "geometry") return text + ", its geometry\n";
  return text + fmt::format(", {}: {} in A, {} in B\n", at.column, value(at.a), value(at.b));
}

}  // namespace lsos
