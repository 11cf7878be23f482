#include "plan/draft_event.h"

#include <fmt/format.h>

namespace lsos {

std::string named(const DraftEvent& draft) {
  return fmt::format("{} ({}/{})", draft.subject, draft.event.rover_id, draft.event.sequence);
}

}  // namespace lsos
