// What of a study the gathering of its cases is told.
#pragma once

#include <string>

#include "lua/study/study_files.h"
#include "product/study/gather.h"

namespace lsos {

GatherRequest gather_request(const StudyFiles& files, const std::string& folder);

}  // namespace lsos
