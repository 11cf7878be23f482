// The options of `lsos-host edit`.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lsos {

struct EditOptions {
  std::string plan, verb, output;
  std::vector<std::string> arguments;  // what is behind the verb: events, or other plans
  bool is_forced = false;

  // Each is of some verbs, see the table in verb_table.cpp; "" or absent: not given.
  std::string rover, label, type, day, by, from, to, offset, places;
  std::vector<std::string> charges;
  std::optional<int> step, times;
};

}  // namespace lsos
