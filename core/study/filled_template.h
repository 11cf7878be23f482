// Texts with named gaps.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace lsos {

// What stands for each name. A text is not read again once it stands in its gap.
using TemplateValues = std::map<std::string, std::vector<std::string>>;

// The text with {{NAME}} replaced by the values of that name: the whole line once for each value,
// not at all where there is none. A line may have several names of one value each. `file` is named
// in faults: throws InputError where a name is unknown, or several of a line have more than one
// value.
std::string filled_template(const std::string& text, const TemplateValues& values,
                            const std::string& file);

}  // namespace lsos
