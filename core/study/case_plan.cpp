#include "study/case_plan.h"

#include <fmt/format.h>

#include "base/text.h"
#include "edit/coordinates.h"

namespace lsos {

const PlanMark& mark_of(const PlanDocument& document, const Address& address) {
  switch (address.of) {
    case Address::Of::mission:
    case Address::Of::soil:
      return document.mission();
    case Address::Of::rover:
      return document.rover(address.id);
    case Address::Of::asset:
      return document.asset(address.id);
    case Address::Of::event:
      break;
  }
  for (const PlanEvent& event : document.plan().events) {
    if (event.rover_id == address.id && event.sequence == address.sequence) {
      return document.mark(event);
    }
  }
  LSOS_ASSERT(false);
  return document.mission();
}

namespace {

void put(PlanDocument& document, const Draw& drawn) {
  const PlanMark& mark = mark_of(document, drawn.address);
  switch (drawn.address.what) {
    case Address::What::place:
      // The ground of all cases is one.
      if (drawn.address.of == Address::Of::rover &&
          drawn.address.id == document.plan().rovers.front().id) {
        keep_site(document);
      }
      move_places(document, mark, drawn.offset_m);
      return;
    case Address::What::script_key: {
      const char* field = drawn.address.of == Address::Of::soil ? "SoilVariant" : "Variant";
      document.set_field(
          mark, field,
          changed_variant(document.field(mark, field), drawn.address.name, drawn.text));
      return;
    }
    case Address::What::field:
      document.set_field(mark, drawn.address.name, drawn.text);
      return;
  }
}

}  // namespace

std::string changed_variant(const std::string& variant, const std::string& key,
                            const std::string& value) {
  std::string changed;
  std::size_t from = 0;
  while (from <= variant.size()) {
    const std::size_t end = std::min(variant.find(';', from), variant.size());
    const std::string_view part = trimmed(std::string_view(variant).substr(from, end - from));
    from = end + 1;
    if (part.empty() || trimmed(part.substr(0, part.find('='))) == key) continue;
    changed += fmt::format("{}; ", part);
  }
  return fmt::format("{}{} = {}", changed, key, value);
}

std::string case_plan(const std::string& kml, const Plan& plan, const Declarations& declarations,
                      const std::vector<Draw>& draws, const CaseOrigin& origin) {
  PlanDocument document(kml, plan, declarations);
  // The soil is changed after it is chosen, and the place of a thing moved once.
  for (const Draw& drawn : draws) put(document, drawn);
  if (!origin.plan.empty()) {
    document.set_field(document.mission(), "CaseOf", origin.plan);
    document.set_field(document.mission(), "CaseOfSha256", origin.sha256);
  }
  return document.text();
}

}  // namespace lsos
