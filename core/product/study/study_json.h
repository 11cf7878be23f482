// Parts of a study page's data.
#pragma once

#include <nlohmann/json.hpp>

#include "product/study/case_courses.h"
#include "product/study/influence.h"
#include "product/study/study_results.h"

namespace lsos {

// Columns without those of the machine and the digest, and their values column by column; `shown`
// is the number of rows.
nlohmann::ordered_json table_json(const StudyResults& results, std::size_t shown);
// How missions ended, the most frequent first, each with the numbers of its cases.
nlohmann::ordered_json outcomes_json(const StudyResults& results);
nlohmann::ordered_json bands_json(const StudyResults& results);
nlohmann::ordered_json arrivals_json(const StudyResults& results, const CaseCourses& courses,
                                     const SiteFrame& site);
nlohmann::ordered_json ends_json(const StudyResults& results, const SiteFrame& site);
// Ellipses over time, and the courses of single cases in 16 bits a value.
nlohmann::ordered_json courses_json(const CaseCourses& courses);
// Histograms and quantiles.
nlohmann::ordered_json numbers_json(const StudyResults& results,
                                    const std::vector<StudyNumber>& numbers);
nlohmann::ordered_json influence_json(const Influence& found);

}  // namespace lsos
