#include "study/case_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.h"
#include "base/quantity.h"

namespace lsos {

std::vector<std::int64_t> listed_cases(const std::string& text, std::int64_t cases) {
  std::set<std::int64_t> numbers;
  if (text.empty()) {
    for (std::int64_t number = 1; number <= cases; ++number) numbers.insert(number);
  }
  std::size_t from = 0;
  while (!text.empty() && from <= text.size()) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const std::string part = text.substr(from, comma - from);
    from = comma + 1;
    const std::size_t dash = part.find('-');
    const Parsed<std::int64_t> first = parse_integer(part.substr(0, dash));
    const Parsed<std::int64_t> last =
        dash == std::string::npos ? first : parse_integer(part.substr(dash + 1));
    if (!first || !last || *first.value < 1 || *last.value < *first.value || *last.value > cases) {
      throw InputError({},
                       fmt::format("--cases {}: numbers from 1 to {} are wanted, as in 40-59 or "
                                   "3,7,12-15",
                                   text, cases));
    }
    for (std::int64_t number = *first.value; number <= *last.value; ++number) {
      numbers.insert(number);
    }
  }
  return {numbers.begin(), numbers.end()};
}

std::string case_list(const std::vector<std::int64_t>& numbers) {
  std::string text;
  for (std::size_t first = 0; first < numbers.size();) {
    std::size_t last = first;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (!text.empty()) text += ',';
    text += fmt::format("{}", numbers[first]);
    if (last > first) text += fmt::format("-{}", numbers[last]);
    first = last + 1;
  }
  return text;
}

std::vector<std::string> case_chunks(const std::vector<std::int64_t>& numbers, std::size_t chunk) {
  std::vector<std::string> chunks;
  for (std::size_t from = 0; from < numbers.size(); from += chunk) {
    const std::size_t count = std::min(chunk, numbers.size() - from);
    const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(from);
    chunks.push_back(case_list({begin, begin + static_cast<std::ptrdiff_t>(count)}));
  }
  return chunks;
}

}  // namespace lsos
