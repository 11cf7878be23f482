// overlay.kml: what happened in a run, drawn over its plan, for Google Earth and GIS tools.
#pragma once

#include <string>

#include "plan/plan.h"
#include "product/overlay_icons.h"
#include "record/log.h"

namespace lsos {

// Greatest numbers of sample Placemarks and of track points of one rover, and of the samples of all
// rovers, each of which may have some; the log has all samples. Larger: the file grows; a sample
// takes 2.7 kB, and three rovers over four weeks stay below 20 MB.
inline constexpr int overlay_samples_max = 2000, overlay_samples_min = 100;
inline constexpr int overlay_all_samples_max = 4000, overlay_track_max = 1500;

// The document. For each rover: its lines drawn in the plan, a track that a time slider plays, its
// planned lines, the line that it drove, its events where they happened, and samples evenly spaced
// along the drive and at each event (see DriveMarks) with every column of the log. In a mission
// longer than a day those of each day lie in a folder of their own. Then the notes, thinned.
std::string overlay_kml(const LogReader& log, const Plan& plan, IconPlace icon_href = server_icon);

// Reads DIR/log.gpkg and writes DIR/overlay.kml. Throws InputError when there is no log.
void write_overlay(const std::string& run_dir, const Plan& plan);
// The same as DIR/overlay.kmz, some ten times smaller, with the icons in it.
void write_packed_overlay(const std::string& run_dir, const Plan& plan);

}  // namespace lsos
