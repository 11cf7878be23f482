// What `import --onto` tells of what it did.
#pragma once

#include <string>
#include <vector>

#include "edit/row_changes.h"
#include "interchange/imported_plan.h"

namespace lsos {

struct OntoResult {
  RowChanges changes;
  std::vector<ThingKey> removed;
  std::vector<ThingKey> removable;    // of those without a row
  std::vector<std::string> left_out;  // of the sheets
  std::vector<std::string> notes;     // how their texts were understood
  std::vector<MovedPlace> moved_places;
  std::string plan_sha256;  // of the new plan
};

// Lists what changed, each with what it was, and then counts. Long lists are cut.
std::string onto_text(const OntoResult& result, const std::string& output);
std::string onto_json(const OntoResult& result, const std::string& output);

}  // namespace lsos
