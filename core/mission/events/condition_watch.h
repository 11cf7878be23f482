// WarnWhen of an event while it runs: whether its condition holds, and what is told when it begins
// to. It stops nothing.
#pragma once

#include <string>

#include "mission/events/turn.h"

namespace lsos {

class ConditionWatch {
 public:
  // Evaluates the condition when it is due. Each time it begins to hold, the rover's journal gets a
  // note and a warning. A condition whose script fails is warned of, and not asked again.
  // `phase`: of the event, which runs.
  void observe(const PlanEvent& event, const std::string& phase, bool is_first, const Turn& turn);

  // Whether it held when it was evaluated last.
  bool holds() const { return holds_; }

  void archive(Archive& a) { LSOS_ARCHIVE(a, holds_, is_faulty_); }

 private:
  bool holds_ = false;  // when it was evaluated last
  bool is_faulty_ = false;
};

}  // namespace lsos
