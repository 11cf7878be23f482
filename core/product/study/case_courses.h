// Where the rovers of all cases were, and with what charge and distance driven, from the files that
// cases leave: for the ellipses and the courses of single cases on the page of a study.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "planet/site_frame.h"
#include "product/study/place_spread.h"
#include "product/study/study_results.h"

namespace lsos {

// The courses of one rover. Times are evenly spaced from 0.
struct RoverCourses {
  std::string rover_id;
  double interval_s = 0, spread_interval_s = 0;
  std::size_t times = 0;             // of each course
  std::vector<PlaceSpread> spreads;  // of all cases, by time
  // Values of the cases that are shown, one case after another; NaN where its mission is over.
  std::vector<double> x_m, y_m, charge, distance_m;
};

// Where and when an event ended in the cases that completed it.
struct EventPlaces {
  PlaceSpread spread;           // of all cases
  std::vector<double> ended_s;  // of the cases that are shown; NaN where there is none
};

struct CaseCourses {
  std::vector<RoverCourses> rovers;
  std::vector<EventPlaces> events;  // by arrivals
};

// The number of cases whose single courses are shown, and how finely.
struct CourseLimits {
  std::size_t cases = 5000;
  std::size_t values = 1'200'000;  // of all cases, rovers and quantities
  std::size_t spreads = 200;       // times
};

// Courses are of the first cases in layer `cases`. Throws InputError where a file is damaged; a
// case that has none has no course.
CaseCourses read_courses(const std::string& folder, const StudyResults& results,
                         const SiteFrame& site, const CourseLimits& limits = {});

}  // namespace lsos
