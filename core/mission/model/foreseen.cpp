#include "mission/model/foreseen.h"

#include <fmt/format.h>

namespace lsos {

Fault foreseen_failure(const PlanEvent& event, const std::string& what, int line) {
  const Severity severity =
      event.on_failure == OnFailure::stop ? Severity::error : Severity::warning;
  return {severity,
          {event.place.file, line > 0 ? line : event.place.line},
          fmt::format("{} '{}': {}", event.type, event.label, what)};
}

}  // namespace lsos
