// What of a study the gathering of its cases is told.
#pragma once

#include <string>

#include "lua/study/study_files.h"
#include "product/study/gather.h"

namespace lsos {

GatherRequest gather_request(const StudyFiles& files, const std::string& folder);

// Whether each column of the table has a name of its own; SQLite tells letters by no case. Throws
// InputError.
void check_columns(const StudyFiles& files);

}  // namespace lsos
