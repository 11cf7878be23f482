// Suggests the nearest valid names in messages, at a bounded cost for plans with thousands of
// faults.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/error.h"

namespace lsos {

class Suggestions {
 public:
  Suggestions() = default;
  explicit Suggestions(std::vector<std::string> known) : known_(std::move(known)) {}

  // "; did you mean 'Speed'?" or "". Only the first 20 different names are compared with all known
  // ones: nobody reads so many suggestions.
  std::string operator()(const std::string& name);

  const std::vector<std::string>& known() const { return known_; }

 private:
  std::vector<std::string> known_;
  std::map<std::string, std::string> answers_;
};

// "a, b, c"; a long list ends in "... (40 in all)".
std::string listed(const std::vector<std::string>& names);

// "line 7" of `place`, with its file when that differs from `file`.
std::string line_text(const Place& place, const std::string& file);

// Text of a plan as messages show it: in quotes, on one line, and cut to 80 bytes.
std::string quoted(const std::string& text);
// The same, but without quotes for a number.
std::string shown(const std::string& text);

}  // namespace lsos
