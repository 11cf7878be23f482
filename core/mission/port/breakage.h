// Something of a rover that breaks, or works again, in the words of plans and scripts. What can
// break, and how, is a table: mission/model/breakable.h.
#pragma once

#include <optional>
#include <string>

namespace lsos {

struct Breakage {
  std::string what;             // "wheel", "panel"
  std::string part = {};        // a name; "": all of them
  std::string mode = {};        // "locked"; "": the first that the table has, of a repair: all
  std::optional<double> share;  // that is lost, 0..1
  bool is_repair = false;
};

}  // namespace lsos
