// The Placemarks of an overlay, made of a plan and the rows of its log.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plan/kml_writer.h"
#include "plan/plan.h"
#include "product/overlay_style.h"
#include "product/rover_track.h"
#include "product/thinned_notes.h"
#include "record/log.h"

namespace lsos {

// A Placemark and the time since the start of the mission to which it belongs; none: to no day.
struct OverlayMark {
  std::optional<SimTime> time;
  KmlPlacemark placemark;
};
using OverlayMarks = std::vector<OverlayMark>;

// A view from above that holds all places, centred on the first; absent where there are none.
std::optional<KmlLookAt> look_at(const Body& body, const std::vector<Geodetic>& places);
// XML's calendar has no second 60: within a leap second the result is "", no time to show.
std::string xml_time(Instant instant);

// The schemas of the columns that the Placemarks have.
std::vector<KmlSchema> overlay_schemas();

OverlayMarks drawn_lines(const Plan& plan, const std::string& rover_id, const RoverStyle& style);
OverlayMarks planned_lines(const std::vector<PlannedPathRow>& paths, Instant start,
                           const std::string& rover_id, const RoverStyle& style);
OverlayMarks driven_lines(const RoverTrack& track, Instant start, const std::string& rover_id,
                          const RoverStyle& style);
// An event belongs to the time of its end, or of its start while it goes on.
OverlayMarks event_points(const std::vector<EventRow>& events, Instant start,
                          const std::string& rover_id);
// The track that a time slider plays.
OverlayMarks moving_point(const RoverTrack& track, Instant start, const std::string& rover_id,
                          const RoverStyle& style);
OverlayMarks sample_points(const RoverTrack& track, Instant start, const std::string& rover_id,
                           const RoverStyle& style);
OverlayMarks note_points(const ThinnedNotes& notes, Instant start);

}  // namespace lsos
