// Builder of the report's text, and its tables.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "validation/cases.h"

namespace lsos::validation {

class Text {
 public:
  std::string text;

  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
    text += '\n';
  }

  // A paragraph in lines of at most 100 characters, after an empty line.
  template <class... Args>
  void paragraph(fmt::format_string<Args...> format, Args&&... args) {
    std::istringstream words(fmt::format(format, std::forward<Args>(args)...));
    std::string line;
    for (std::string word; words >> word;) {
      if (!line.empty() && line.size() + 1 + word.size() > 100) {
        text += '\n' + std::exchange(line, "");
      }
      line += (line.empty() ? "" : " ") + word;
    }
    text += '\n' + line + '\n';
  }
};

// Errors of a set of points, one row each.
void summary_head(Text& t);
void summary_row(Text& t, const Case& c, const std::string& what, const std::string& soil_name,
                 const Soil& soil, const std::vector<MeasuredPoint>& points);

bool is_at_bound(const FitParameter& p, double value);

// Published values, allowed ranges and fitted values.
void parameters(Text& t, const Case& c);

// Measured and computed values, one row for each point: straight rolling, and at slip angles.
void straight_table(Text& t, const Case& c, const std::vector<MeasuredPoint>& points);
void turned_table(Text& t, const Case& c, const std::vector<MeasuredPoint>& points);

}  // namespace lsos::validation
