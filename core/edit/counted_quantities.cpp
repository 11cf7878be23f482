#include "edit/counted_quantities.h"

#include <array>
#include <regex>

namespace lsos {

std::string counted_quantities(const PlanEvent& event) {
  static const std::array<std::string, 2> counted{"time_s", "distance_m"};
  std::string found;
  for (const std::string& name : counted) {
    const std::regex word("\\b" + name + "\\b");
    for (const PlanEvent::Condition* condition :
         {&event.start_when, &event.skip_when, &event.stop_when, &event.warn_when}) {
      if (!std::regex_search(condition->text, word)) continue;
      found += (found.empty() ? "" : ", ") + name;
      break;
    }
  }
  return found;
}

}  // namespace lsos
