// The page rovers/MEASURED.md.
#pragma once

#include <string>
#include <vector>

#include "rovers/figures.h"

namespace lsos::rovers {

// Heading of the part that differs from machine to machine, at the end of the page.
inline constexpr const char* speed_heading = "## Speed\n";

// All but the part on speed; `figures` are by `subjects`.
std::string page(const std::vector<Figures>& figures);
// The part on speed. `times`: by `subjects`, simulated over elapsed time.
std::string speed_part(const std::string& machine, const std::vector<double>& times);
// "rovers/pictures/SEV.png"
std::string picture_path(const Subject& subject);

}  // namespace lsos::rovers
