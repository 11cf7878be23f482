// Reads the Placemarks that are not events: MissionInfo, Rover, Asset.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "plan/classify.h"
#include "plan/field_reader.h"
#include "plan/plan.h"

namespace lsos {

// The field of MissionInfo that names the plan of which this is a case.
inline constexpr const char* case_of_field = "CaseOf";
inline constexpr const char* case_digest_field = "CaseOfSha256";
// From where x and y are counted.
inline constexpr const char* site_field = "SiteOrigin";

// Context that the readers of all kinds of Placemark share.
struct ReadContext {
  const std::string& plan_file;    // Plan::home; paths in the plan are relative to its folder
  const std::string& source_file;  // for messages
  const Declarations& declarations;
  Faults& faults;
};

// Checks that there is one MissionInfo and reads the first. Defaults go to `defaults`.
MissionInfo read_mission(const std::vector<PlanPlacemark>& missions, const ReadContext& context,
                         PlanGaps& gaps, std::vector<std::string>& defaults);

// The ids of the plan and where each is given, also by Placemarks with other faults.
using IdPlaces = std::map<std::string, Place>;

// Read rovers and assets; the results are in byte order of id.
std::vector<PlanRover> read_rovers(const std::vector<PlanPlacemark>& rovers,
                                   const ReadContext& context, IdPlaces& ids, PlanGaps& gaps,
                                   std::vector<std::string>& defaults);
std::vector<PlanAsset> read_assets(const std::vector<PlanPlacemark>& assets,
                                   const ReadContext& context, IdPlaces& ids, PlanGaps& gaps);

// File and line of the Placemark's element.
Place place_of(const SourcePlacemark& placemark, const ReadContext& context);
// Subject "Rover 'NAME'" of messages; when the Placemark has no name, the text of `id_field`
// replaces it.
Subject subject_of(const PlanPlacemark& ours, const std::string& id_field,
                   const ReadContext& context);

}  // namespace lsos
