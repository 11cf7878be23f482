// What the questions of a condition can be asked about.
#pragma once

#include <set>
#include <string>

namespace lsos {

struct ConditionWorld {
  std::string own_id;               // of the event's rover
  std::set<std::string> ids;        // of rovers and assets
  std::set<std::string> resources;  // that the event's rover carries
};

}  // namespace lsos
