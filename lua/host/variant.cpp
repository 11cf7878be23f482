#include "lua/host/variant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <vector>

#include "base/quantity.h"
#include "base/text.h"
#include "lua/runtime/reader.h"
#include "lua/runtime/text_literal.h"

namespace lsos {

namespace {

constexpr const char* example = "battery.capacity_j = 60 kWh; cruise_speed_mps = 1.5";

// A value, or a table of nodes, to be written in Lua.
struct Node {
  std::string value;  // "" for a table
  std::map<std::string, Node> parts;
};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at; (at = text.find(separator, from)) != std::string::npos; from = at + 1) {
    parts.emplace_back(trimmed(std::string_view(text).substr(from, at - from)));
  }
  parts.emplace_back(trimmed(std::string_view(text).substr(from)));
  return parts;
}

bool is_variant_name(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ' ' || c == '-';
  });
}

Parsed<std::string> variant_value(const std::string& key, const std::string& text);

// Whether the text is a vector: "0, 0, 1.2", but neither "144,000,000" nor "true, 0, 1".
bool is_vector(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  const auto is_group = [](const std::string& part) {
    return part.size() == 3 &&
           std::ranges::all_of(part, [](char c) { return c >= '0' && c <= '9'; });
  };
  const auto is_number = [](const std::string& part) {
    return !part.empty() && std::string_view("0123456789.+-").find(part[0]) != std::string::npos;
  };
  return parts.size() == 3 && std::ranges::all_of(parts, is_number) &&
         !(is_group(parts[1]) && is_group(parts[2]));
}

// Vector such as "0, 0, 1.2", each number in the unit of the key.
Parsed<std::string> vector_of(const std::string& key, const std::string& text) {
  std::vector<std::string> values;
  for (const std::string& part : split(text, ',')) {
    Parsed<std::string> value = variant_value(key, part);
    if (!value) return value;
    values.push_back(*value.value);
  }
  return {fmt::format("lsos.vec3({})", fmt::join(values, ", ")), ""};
}

Parsed<std::string> variant_value(const std::string& key, const std::string& text) {
  if (is_vector(text)) return vector_of(key, text);
  if (text == "true" || text == "false") return {text, ""};
  if (text.size() >= 2 && text.front() == text.back() && (text[0] == '\'' || text[0] == '"') &&
      is_variant_name(text.substr(1, text.size() - 2))) {
    return {fmt::format("'{}'", text.substr(1, text.size() - 2)), ""};
  }
  const Unit* own = find_unit(si_unit_of(key));
  const Parsed<double> number = parse_quantity(text, own == nullptr ? *find_unit("1") : *own);
  if (number) return {fmt::format("{}", *number.value), ""};
  if (own != nullptr) return {{}, number.why};
  // A quantity for a key written without its unit, as in capacity = 60 kWh, is passed on as a text:
  // lsos.derive then reports the key's real name.
  const bool has_unit = std::ranges::any_of(
      all_units(), [&](const Unit& unit) { return parse_quantity(text, unit).value.has_value(); });
  if (has_unit) return {lua_text(text), ""};
  return {{}, number.why};
}

// Adds the change "a.b = value"; returns its fault or "".
std::string add_change(const std::string& change, Node& root) {
  const std::size_t equals = change.find('=');
  if (equals == std::string::npos) {
    return fmt::format("'{}': KEY = VALUE is wanted, as in {}", change, example);
  }
  const std::vector<std::string> path = split(change.substr(0, equals), '.');
  if (!std::ranges::all_of(path, is_variant_name)) {
    return fmt::format("'{}': a key is wanted before '=', as in {}", change, example);
  }
  const Parsed<std::string> value =
      variant_value(path.back(), std::string(trimmed(std::string_view(change).substr(equals + 1))));
  static constexpr const char* fixed[] = {"name", "doc", "api", "assumptions"};
  if (std::ranges::find(fixed, path.front()) != std::end(fixed)) {
    return fmt::format("'{}' is the script's own and cannot be changed", path.front());
  }
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
    if (const std::string fault = add_change(change, root); !fault.empty()) return {{}, fault};
  }
  if (root.parts.empty()) return {{}, fmt::format("changes nothing; {} is an example", example)};
  return {table_text(root), ""};
}

}  // namespace lsos
