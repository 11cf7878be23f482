// The distance up to which ground may hide what is seen low above the horizon.
#pragma once

#include "planet/body.h"

namespace lsos {

// Greatest rise of ground above a place within that distance of it, m: min(d tan 40 deg,
// sqrt(4 km d)). Chosen so that the greatest rises known lie below: the wall of Shackleton (4.2 km
// within 7.2 km), Rakaposhi (5.9 km within 11.5 km), Nanga Parbat (7 km within 27 km), the walls of
// Coprates Chasma (8.5 km within 20 km), Olympus Mons (22 km within 300 km). Single cliffs are
// steeper.
double greatest_rise_m(double distance_m);

// Ground at the distance d hides a ray that leaves a place at the elevation e where it rises above
// the place by more than d tan(e) + d^2/(2 R), for a body of radius R. Returns the greatest
// distance at which ground may do so, bounded by greatest_rise_m() and by the highest ground of the
// body; 0 if there is none. `eye_height_m`: above the reference surface. `elevation_rad`:
// -pi/2..pi/2.
double horizon_reach_m(const Body& body, double eye_height_m, double elevation_rad);

}  // namespace lsos
