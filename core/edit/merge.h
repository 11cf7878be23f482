// `edit merge`: several plans of one mission as one.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "edit/plan_document.h"

namespace lsos {

struct Merged {
  int rovers = 0, events = 0;  // taken up
  std::vector<std::string> warnings;
};

class Merger {
 public:
  // `document` takes up the others; all must outlive it, and the others are used up.
  Merger(PlanDocument& document, std::vector<PlanDocument*> others);

  // Takes up rovers, assets, events and decoration of the other plans, each in a folder of its own.
  // Schemas and styles that are there already are not taken twice, nor an asset that is the same.
  // References by a label that several plans have become ROVER/SEQUENCE. Throws InputError where
  // Planet, Terrain or StartTime differ, or a rover or asset of the same name is there already.
  Merged run();

 private:
  void add(PlanDocument& other);
  void check(const PlanDocument& other, Faults& faults);
  void keep_failure_rules(PlanDocument& other);
  void warn_of_mission_fields(const PlanDocument& other);
  void name_by_sequence(PlanDocument& document);
  void add_schemas(PlanDocument& other);
  void add_styles(PlanDocument& other);
  void add_features(PlanDocument& other);

  PlanDocument& document_;
  std::vector<PlanDocument*> others_;
  struct Known {
    std::string file;
    const PlanAsset* asset = nullptr;  // that has the id; nullptr: a rover has it
  };
  std::map<std::string, Known> ids_;
  std::set<std::string> shared_labels_;  // that events of several plans have
  Merged merged_;
};

}  // namespace lsos
