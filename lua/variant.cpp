#include "lua/variant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <vector>

#include "base/quantity_advice.h"
#include "lua/reader.h"

namespace lsos {

namespace {

constexpr const char* example = "battery.capacity_j = 60 kWh; cruise_speed_mps = 1.5";

// A table of tables and values in Lua.
struct Node {
  std::string value;  // "" for a table
  std::map<std::string, Node> parts;
};

std::string trimmed(std::string_view text) {
  const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return std::string(text);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at; (at = text.find(separator, from)) != std::string::npos; from = at + 1) {
    parts.push_back(trimmed(std::string_view(text).substr(from, at - from)));
  }
  parts.push_back(trimmed(std::string_view(text).substr(from)));
  return parts;
}

bool is_name(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ' ' || c == '-';
  });
}

// A number in the unit that the key's name ends in. Of a key without one it is a share, or in the
// unit that it has: where the key is another's name without its unit, the rover's script says so.
Parsed<double> number_of(const std::string& key, const std::string& text) {
  if (const Unit* unit = find_unit(si_unit_of(key))) {
    Parsed<double> number = parse_quantity(text, *unit);
    if (!number) number.why += quantity_advice(text, *unit);
    return number;
  }
  Parsed<double> number = parse_quantity(text, *find_unit("1"));
  for (const Unit& unit : all_units()) {
    if (number) break;
    if (Parsed<double> found = parse_quantity(text, unit)) number = found;
  }
  return number;
}

Parsed<std::string> value_of(const std::string& key, const std::string& text) {
  if (text == "true" || text == "false") return {text, ""};
  if (text.size() >= 2 && text.front() == text.back() && (text[0] == '\'' || text[0] == '"') &&
      is_name(text.substr(1, text.size() - 2))) {
    return {fmt::format("'{}'", text.substr(1, text.size() - 2)), ""};
  }
  const Parsed<double> number = number_of(key, text);
  if (number) return {fmt::format("{}", *number.value), ""};
  return {{}, number.why};
}

// Adds "a.b = value"; "" or what is wrong with it.
std::string add(const std::string& change, Node& root) {
  const std::size_t equals = change.find('=');
  if (equals == std::string::npos) {
    return fmt::format("'{}': KEY = VALUE is wanted, as in {}", change, example);
  }
  const std::vector<std::string> path = split(change.substr(0, equals), '.');
  if (!std::ranges::all_of(path, is_name)) {
    return fmt::format("'{}': a key is wanted before '=', as in {}", change, example);
  }
  const Parsed<std::string> value =
      value_of(path.back(), trimmed(std::string_view(change).substr(equals + 1)));
  if (!value) return fmt::format("{}: {}", trimmed(change.substr(0, equals)), value.why);
  Node* node = &root;
  for (const std::string& part : path) {
    if (!node->value.empty()) return fmt::format("'{}': is changed twice", change);
    node = &node->parts[part];
  }
  if (!node->value.empty() || !node->parts.empty()) {
    return fmt::format("'{}': is changed twice", change);
  }
  node->value = *value.value;
  return "";
}

std::string table_text(const Node& node) {
  if (!node.value.empty()) return node.value;
  std::string text = "{ ";
  for (const auto& [name, part] : node.parts) {
    text += fmt::format("['{}'] = {}, ", name, table_text(part));
  }
  return text + "}";
}

}  // namespace

Parsed<std::string> variant_table(const std::string& text) {
  Node root;
  for (const std::string& change : split(text, ';')) {
    if (change.empty()) continue;
    if (const std::string fault = add(change, root); !fault.empty()) return {{}, fault};
  }
  if (root.parts.empty()) return {{}, fmt::format("changes nothing; {} is an example", example)};
  return {table_text(root), ""};
}

}  // namespace lsos
