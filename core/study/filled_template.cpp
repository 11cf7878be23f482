#include "study/filled_template.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/error.h"

namespace lsos {

namespace {

// A line as texts with gaps between them: texts[0] gaps[0] texts[1] ...
struct Line {
  std::vector<std::string> texts;
  std::vector<const std::vector<std::string>*> gaps;
};

const std::vector<std::string>& values_of(const std::string& name, const TemplateValues& values,
                                          const Place& place) {
  const auto found = values.find(name);
  if (found != values.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [each, value] : values) known.push_back(each);
  throw InputError(
      place, fmt::format("{{{{{}}}}}: there is no such value{}", name, did_you_mean(name, known)));
}

Line read_line(const std::string& text, const TemplateValues& values, const Place& place) {
  Line line;
  std::size_t from = 0;
  for (;;) {
    const std::size_t open = text.find("{{", from);
    const std::size_t close = open == std::string::npos ? open : text.find("}}", open);
    line.texts.push_back(text.substr(from, close == std::string::npos ? close : open - from));
    if (close == std::string::npos) return line;
    line.gaps.push_back(&values_of(text.substr(open + 2, close - open - 2), values, place));
    from = close + 2;
  }
}

}  // namespace

std::string filled_template(const std::string& text, const TemplateValues& values,
                            const std::string& file) {
  std::istringstream lines(text);
  std::string filled, one;
  for (int number = 1; std::getline(lines, one); ++number) {
    const Place place{file, number};
    const Line line = read_line(one, values, place);
    std::size_t times = 1, lists = 0;
    for (const auto* gap : line.gaps) {
      times = gap->empty() || times == 0 ? 0 : std::max(times, gap->size());
      lists += gap->size() > 1 ? 1 : 0;
    }
    if (lists > 1) throw InputError(place, "a line has one value of which there are several");
    for (std::size_t i = 0; i < times; ++i) {
      filled += line.texts.front();
      for (std::size_t at = 0; at < line.gaps.size(); ++at) {
        const std::vector<std::string>& gap = *line.gaps[at];
        filled += gap[gap.size() > 1 ? i : 0] + line.texts[at + 1];
      }
      filled += '\n';
    }
  }
  return filled;
}

}  // namespace lsos
