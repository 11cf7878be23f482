// Checks a condition before anything runs: its names by its words, its result by trial calls.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <string_view>

#include "base/error.h"
#include "lua/host/condition.h"
#include "lua/host/condition_comparisons.h"
#include "lua/host/condition_sets.h"
#include "lua/host/condition_sizes.h"
#include "lua/host/condition_words.h"
#include "lua/host/everyday_words.h"
#include "lua/runtime/state.h"
#include "record/quantities.h"

namespace lsos {

namespace {

// Fault of a name that is not known; "" where the set of known names is incomplete.
std::string unknown(const char* what, const std::string& name, const std::set<std::string>& known,
                    bool are_all_known) {
  if (!are_all_known) return "";
  const std::vector<std::string> names(known.begin(), known.end());
  return fmt::format("there is no {} '{}'{}", what, name, did_you_mean(name, names));
}

std::string argument_fault(const std::string& question, const std::string& argument,
                           const ConditionWorld& world) {
  if (question == "resource") {
    return world.resources.contains(argument) ? ""
                                              : unknown("resource of the rover", argument,
                                                        world.resources, world.are_resources_known);
  }
  if (argument == world.own_id) {
    return fmt::format("'{}' is the event's own rover; {} asks of another rover or an asset",
                       argument, question);
  }
  std::set<std::string> ids = world.ids;
  ids.erase(world.own_id);
  if (question != "distance_to") ids.insert("Earth");
  return ids.contains(argument) ? ""
                                : unknown("rover or asset", argument, ids, world.are_ids_known);
}

// Type of an operand of == or ~=, where a single word or question determines it.
enum class Operand { unclear, number, truth, text };

Operand operand_of(const ConditionWord& word) {
  if (word.kind == ConditionWord::Kind::number) return Operand::number;
  if (word.kind == ConditionWord::Kind::text) return Operand::text;
  if (word.kind != ConditionWord::Kind::name) return Operand::unclear;
  if (word.text == "true" || word.text == "false") return Operand::truth;
  if (is_question(word.text)) return gives_number(word.text) ? Operand::number : Operand::truth;
  const bool is_quantity = std::ranges::any_of(
      condition_names(), [&](const ConditionName& name) { return name.name == word.text; });
  return is_quantity ? Operand::number : Operand::unclear;
}

// First word of the operand that ends at `i`: sees('B') and sees 'B' are one operand.
std::size_t operand_begin(const std::vector<ConditionWord>& words, std::size_t i) {
  const auto asks = [&](std::size_t at) {
    return words[at].kind == ConditionWord::Kind::name && is_question(words[at].text);
  };
  if (i >= 3 && words[i].text == ")" && words[i - 2].text == "(" && asks(i - 3)) return i - 3;
  if (i >= 1 && words[i].kind == ConditionWord::Kind::text && asks(i - 1)) return i - 1;
  return i;
}

// First word behind the operand that begins at `i`.
std::size_t operand_end(const std::vector<ConditionWord>& words, std::size_t i) {
  if (!is_question(words[i].text)) return i + 1;
  return i + 1 < words.size() && words[i + 1].text == "(" ? i + 4 : i + 2;
}

// Lua compares a number with a boolean or a text without complaint, though they are never equal.
std::string equality_fault(const std::vector<ConditionWord>& words) {
  static constexpr const char* names[] = {"", "a number", "true or false", "a text"};
  const auto is_one_of = [&](std::size_t at, std::string_view symbols) {
    return words[at].kind == ConditionWord::Kind::symbol &&
           symbols.find(words[at].text) != std::string_view::npos;
  };
  for (std::size_t i = 1; i + 2 < words.size(); ++i) {
    if (!is_one_of(i, "=~") || !is_one_of(i + 1, "=")) continue;
    const std::size_t left = operand_begin(words, i - 1), right = i + 2;
    const bool is_negated = left > 0 && words[left - 1].text == "not";
    // Where an operand is part of a larger expression, as in a < b == c and in a == b + c, a single
    // word does not determine its type.
    if (left > 0 && !is_negated && !begins_operand(words[left - 1])) continue;
    const std::size_t after = operand_end(words, right);
    if (after < words.size() && !ends_operand(words[after])) continue;
    const Operand a = is_negated ? Operand::truth : operand_of(words[left]);
    const Operand b = operand_of(words[right]);
    if (a == Operand::unclear || b == Operand::unclear || a == b) continue;
    std::string fault =
        fmt::format("'{}=' compares {} with {}, and they never are the same", words[i].text,
                    names[static_cast<int>(a)], names[static_cast<int>(b)]);
    for (const std::size_t at : {left, right}) {
      if (is_question(words[at].text) && operand_of(words[at]) == Operand::truth) {
        fault += fmt::format("; {} needs no comparison: 'not' turns it round", words[at].text);
      }
    }
    return fault;
  }
  return "";
}

// Doubt about a quantity of panels or a battery that the rover does not have. It is not-a-number.
std::string missing_part_doubt(const std::string& word, const ConditionWorld& world) {
  const Quantity* quantity = find_quantity(word);
  if (quantity == nullptr) return "";
  const bool has_no_panels = world.is_without_panels && quantity->part == QuantityPart::panels;
  const bool has_no_battery = world.is_without_battery && quantity->part == QuantityPart::battery;
  if (!has_no_panels && !has_no_battery) return "";
  return fmt::format(
      "the rover has no {}: '{}' is not known; comparisons with it are false, '~=' is true",
      has_no_panels ? "panels" : "battery", word);
}

// What is wrong with the word at `i`, where it names something.
std::string name_fault(lua_State* L, const std::vector<ConditionWord>& words, std::size_t i,
                       const ConditionWorld& world) {
  static const std::set<std::string> lua_words{"and", "or", "not", "true", "false", "math"};
  const std::string& word = words[i].text;
  const bool is_member =
      i > 0 && words[i - 1].kind == ConditionWord::Kind::symbol && words[i - 1].text == ".";
  // A condition is a plain expression: no methods of texts, no indexing, no tables.
  if (words[i].kind == ConditionWord::Kind::symbol &&
      std::string_view(":[{").find(word) != std::string::npos) {
    return fmt::format("a condition has no '{}'", word);
  }
  if (words[i].kind != ConditionWord::Kind::name) return "";
  if (is_member) {
    const bool is_of_math = i >= 2 && words[i - 2].text == "math";
    return is_of_math ? math_fault(L, word) : fmt::format("only math has members, as .{}", word);
  }
  if (lua_words.contains(word)) return "";
  std::vector<std::string> known;
  for (const ConditionName& name : condition_names()) known.emplace_back(name.name);
  if (std::ranges::find(known, word) == known.end()) {
    std::string hint = everyday_word_hint(word);
    if (hint.empty()) hint = did_you_mean(word, known);
    if (hint.empty()) hint = "; see lua/README.md, Conditions";
    return fmt::format("a condition has no '{}'{}", word, hint);
  }
  if (!is_question(word)) return "";
  const std::string* argument = question_argument(words, i);
  if (argument == nullptr) {
    const char* example = word == "resource" ? "samples" : "SEV2";
    return fmt::format("{} is asked with a text: {}('{}')", word, word, example);
  }
  return argument_fault(word, *argument, world);
}

// Faults of all names, at most five.
std::string names_fault(lua_State* L, const std::vector<ConditionWord>& words,
                        const ConditionWorld& world) {
  constexpr std::size_t faults_max = 5;
  std::vector<std::string> faults;
  for (std::size_t i = 0; i < words.size() && faults.size() < faults_max; ++i) {
    std::string fault = name_fault(L, words, i, world);
    if (fault.empty() || std::ranges::find(faults, fault) != faults.end()) continue;
    faults.push_back(std::move(fault));
  }
  return fmt::format("{}", fmt::join(faults, "; "));
}

// Text of the numeric operand at `at`, alone or in brackets; "" where it is not known to be a
// number.
std::string number_operand_at(const std::vector<ConditionWord>& words, std::size_t at) {
  std::size_t brackets = 0;
  bool is_number = false;  // an operand with a minus is a number
  for (; at < words.size() && words[at].kind == ConditionWord::Kind::symbol; ++at) {
    if (words[at].text == "-") {
      is_number = true;
    } else if (words[at].text == "(") {
      ++brackets;
    } else {
      return "";
    }
  }
  if (at >= words.size()) return "";
  // Functions of math whose result may be a boolean, a text or nil, which `not` suits.
  static const std::set<std::string> no_numbers{"ult", "type", "tointeger"};
  if (words[at].text == "math" && at + 2 < words.size()) {
    const std::string name = "math." + words[at + 2].text;
    return brackets == 0 && !no_numbers.contains(words[at + 2].text) ? name + "(...)" : "";
  }
  if (!is_number && operand_of(words[at]) != Operand::number) return "";
  // An operand that is followed by more before its last bracket may be part of a comparison.
  std::size_t after = operand_end(words, at);
  for (; brackets > 0; --brackets, ++after) {
    if (after >= words.size() || words[after].text != ")") return "";
  }
  return words[at].text + (is_question(words[at].text) ? "(...)" : "");
}

// Lua treats every number as true, so `not` of a number is never true.
std::string negation_fault(const std::vector<ConditionWord>& words) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i].kind != ConditionWord::Kind::name || words[i].text != "not") continue;
    const std::string quantity = number_operand_at(words, i + 1);
    if (quantity.empty()) continue;
    return fmt::format(
        "'not {0}' negates a number, which always counts as true: it is never true; write {0} == "
        "0, or not ({0} > 1)",
        quantity);
  }
  return "";
}

}  // namespace

std::string condition_fault(lua_State* L, const std::string& text, const ConditionWorld& world) {
  std::string syntax = condition_syntax_fault(L, text);
  if (!syntax.empty()) return syntax;
  const std::vector<ConditionWord> words = condition_words(text);
  std::string names = names_fault(L, words, world);
  if (!names.empty()) return names;
  std::string equality = equality_fault(words);
  if (!equality.empty()) return equality;
  std::string size = sizes_fault(words);
  if (!size.empty()) return size;
  std::string negation = negation_fault(words);
  if (!negation.empty()) return negation;
  // Trial values that make comparisons true and false, so that most operands of `and` and `or` are
  // reached. Behind a narrow range, as in charge > 0.2 and charge < 0.5 and X, X is not.
  for (const double value : {0.0, 1.0, -1e9, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
    for (const bool answer : {false, true}) {
      std::string fault = condition_trial_fault(L, text, value, answer);
      if (!fault.empty()) return fault;
    }
  }
  return "";
}

std::string condition_doubt(const std::string& text, const ConditionWorld& world) {
  const std::vector<ConditionWord> words = condition_words(text);
  for (const ConditionWord& word : words) {
    if (word.kind != ConditionWord::Kind::name) continue;
    if (std::string doubt = missing_part_doubt(word.text, world); !doubt.empty()) return doubt;
  }
  std::string size = sizes_doubt(words, world);
  return size.empty() ? sets_doubt(words) : size;
}

}  // namespace lsos
