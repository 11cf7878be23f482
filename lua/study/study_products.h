// What is made of a study once cases have run: its table, page and map.
#pragma once

#include <string>

#include "lua/study/study_files.h"
#include "product/study/gather.h"
#include "product/study/study_overlay.h"
#include "product/study/study_page.h"

namespace lsos {

// Writes study.gpkg, study.html and study.kml of the cases in the folder. Throws OutputError, and
// InputError where a case's files are damaged. A page or map that cannot be made for another reason
// is a warning.
Gathered write_study(const StudyFiles& files, const std::string& folder, int threads);

// What the page shows besides. Without `has_ground` it has no relief.
StudyPageRequest study_page_request(const StudyFiles& files, const std::string& folder,
                                    bool has_ground);

}  // namespace lsos
