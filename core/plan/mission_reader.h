// Reads the Placemarks that are no events: MissionInfo, Rover, Asset.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "plan/classify.h"
#include "plan/field_reader.h"
#include "plan/plan.h"

namespace lsos {

// What the readers of all kinds of Placemark share.
struct ReadContext {
  const std::string& plan_file;    // as given: paths in the plan are relative to it
  const std::string& source_file;  // for messages
  const Declarations& declarations;
  Faults& faults;
};

// Checks that there is one MissionInfo and reads the first. Defaults go to `defaults`.
MissionInfo read_mission(const std::vector<OurPlacemark>& missions, const ReadContext& context,
                         PlanGaps& gaps, std::vector<std::string>& defaults);

// Where the ids of the plan are given, also by Placemarks with other faults.
using IdPlaces = std::map<std::string, Place>;

// In byte order of id.
std::vector<PlanRover> read_rovers(const std::vector<OurPlacemark>& rovers,
                                   const ReadContext& context, IdPlaces& ids, PlanGaps& gaps,
                                   std::vector<std::string>& defaults);
std::vector<PlanAsset> read_assets(const std::vector<OurPlacemark>& assets,
                                   const ReadContext& context, IdPlaces& ids, PlanGaps& gaps);

// The file and line of its element.
Place place_of(const SourcePlacemark& placemark, const ReadContext& context);
// "Rover 'NAME'" of the Placemark; where it has none, the text of `id_field` stands for it.
Subject subject_of(const OurPlacemark& ours, const std::string& id_field,
                   const ReadContext& context);

}  // namespace lsos
