// Numbers of cases as people and job scripts write them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lsos {

// "40-59,71" as numbers in ascending order, each once; "": 1..cases. Throws InputError beyond
// 1..cases.
std::vector<std::int64_t> listed_cases(const std::string& text, std::int64_t cases);

// The other way round. `numbers`: ascending, each once.
std::string case_list(const std::vector<std::int64_t>& numbers);

// The numbers in lists of `chunk` each; the last may have fewer.
std::vector<std::string> case_chunks(const std::vector<std::int64_t>& numbers, std::size_t chunk);

}  // namespace lsos
