// study.kml: the bands of a study for Google Earth. Of each rover: the course at the medians of its
// places, which a time slider plays with the bands of charge and distance; ellipses that hold most
// cases, at times and at the ends of events; the share of cases that completed each event; where
// missions ended badly.
#pragma once

#include <string>

#include "product/study/study_page.h"

namespace lsos {

inline constexpr const char* study_overlay_file = "study.kml";

// Throws InputError where files of the study are missing or damaged.
std::string study_overlay(const StudyPageRequest& request);

}  // namespace lsos
