// study.json: what a study's folder was made of. Cases of another plan, script, raster, program or
// study are never put among those that are there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lua/study/study_files.h"

namespace lsos {

inline constexpr const char* study_file = "study.json";

// Makes the folder, or checks that it is of this study as it is now. Throws InputError that names
// all that has changed; a study may have more or fewer cases than before, but not with a Latin
// hypercube.
void open_study_folder(const StudyFiles& files, const std::string& folder);
// The same for a folder that must be there.
void check_study_folder(const StudyFiles& files, const std::string& folder);

// Writes that the study knows enough after so many cases; absent: that it does not.
void note_last_case(const std::string& folder, const std::optional<std::int64_t>& number);

// The number of cases that the folder is to have. Throws InputError where it is no study's.
std::int64_t cases_of_folder(const std::string& folder);

}  // namespace lsos
