// Warns of places so far from where they should be that a slip in writing is likely: longitude and
// latitude exchanged, decimal commas, 0,0.
#pragma once

#include <string>
#include <vector>

#include "plan/draft_event.h"

namespace lsos {

// "180 m", "4.2 km", "912 km"
std::string distance_text(double distance_m);

// "; with longitude and latitude exchanged it would be 12 m away" where that is a tenth of the
// distance from `from` to `place` or less, else "".
std::string exchanged_text(const Body& body, const Geodetic& from, const Geodetic& place);

// The places that coordinates give when every two whole numbers are read as one number with a
// decimal comma ("31,5 12,25": 31.5,12.25). Empty where they cannot be read so.
std::vector<Geodetic> with_decimal_commas(const std::string& coordinates);

// Warns of each drive with a waypoint improbably far from the place before it, and of each rover,
// asset and SiteOrigin improbably far from the first rover's start. The mission must have a planet.
void check_far_places(const std::vector<DraftEvent>& drafts, const MissionInfo& mission,
                      const std::vector<PlanRover>& rovers, const std::vector<PlanAsset>& assets,
                      const PlanGaps& gaps, Faults& faults);

}  // namespace lsos
