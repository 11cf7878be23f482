// Stretches of an estimate in which a rover lacks what it needs: plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace lsos {

enum class LackKind {
  sunlight,   // no Sun reaches a panel, and the charge falls so far that it matters
  contact,    // a stowable antenna is up and reaches nobody all the while
  energy,     // the battery was empty, and is not above its reserve since
  condition,  // WarnWhen of events holds
};

// Times since the mission's start.
struct Lack {
  LackKind kind = LackKind::sunlight;
  std::string rover_id;
  std::int64_t sequence = 0;  // of the event under way at its beginning, or the last before
  double begin_s = 0, end_s = 0;
  // Charge 0..1 in a lack of sunlight: at its beginning, the least, and when it fell below the
  // reserve.
  double charge_begin = 0, charge_min = 0, reserve = 0;
  std::optional<double> below_s;
  std::int64_t below_sequence = 0;  // of the event under way then, or the last before
  bool is_stowed = false;           // all panels are, all the while
  bool is_idle = false;             // no event is under way at its beginning
  bool is_told = false;             // of energy: the event then fails, and says why
  std::string next;                 // of energy: label of the event that then comes next, "": none
  std::string what;                 // of contact: the antenna; of a condition: its text
};

// Charge, 0..1, that a rover loses in a stretch of darkness from which the loss is told even where
// the reserve is left.
inline constexpr double dark_loss_told = 0.5;

}  // namespace lsos
