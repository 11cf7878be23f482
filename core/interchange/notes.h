// What an import tells beside its faults: how it understood what could be meant otherwise.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace lsos {

class Notes {
 public:
  // Each note is told once.
  void add(const std::string& note) {
    if (std::ranges::find(notes_, note) == notes_.end()) notes_.push_back(note);
  }
  const std::vector<std::string>& all() const { return notes_; }

 private:
  std::vector<std::string> notes_;
};

}  // namespace lsos
