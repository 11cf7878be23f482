#include "mission/rover/supply_watch.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/moment_text.h"
#include "mission/port/note_json.h"

namespace lsos {

namespace {

void report_short_supply(RoverPower& power, SimTime now, RoverJournal& journal) {
  if (!power.take_short_supply()) return;
  const PowerClaims& claims = power.claims();
  const double got_w = power.outside_w();
  const bool is_plugged = !claims.plugged_into.empty();
  const double asked_w = claims.supply_w + (is_plugged ? claims.asked_w : 0);
  journal.note(
      "supply_short",
      fmt::format(R"({{"asked_w":{},"given_w":{}}})",
                  note_json(std::isfinite(asked_w) ? asked_w : not_modelled), note_json(got_w)));
  const std::string from = is_plugged ? fmt::format("'{}'", claims.plugged_into) : "outside";
  if (!std::isfinite(asked_w)) {
    journal.warn(fmt::format("{}: at {} {} has no power left to give", journal.rover_id(),
                             moment_text(now), from));
    return;
  }
  journal.warn(fmt::format("{}: at {} {:.0f} W come from {}, {:.0f} W are requested",
                           journal.rover_id(), moment_text(now), got_w, from, asked_w));
}

}  // namespace

std::string reserve_text(const RoverPower& power) {
  return fmt::format("its charge is below the reserve of {:.4g} %, which is kept for its loads",
                     100 * power.reserve());
}

bool SupplyWatch::observe(const RoverPower& power, SimTime now, RoverJournal& journal) {
  warn_of_low_charge(power, now, journal);
  if (!power.has_reserve_changed() || !power.waits_for_reserve()) return false;
  journal.set_sequence(0);
  journal.note("battery_empty", fmt::format(R"({{"shed_w":{}}})", note_json(power.shed_w())));
  if (!std::exchange(has_warned_of_empty_, true)) {
    journal.warn(fmt::format(
        "{}: the battery is empty at {}, and {:.0f} W are shed; what drives or works fails, and "
        "what comes later waits until its charge is above the reserve",
        journal.rover_id(), moment_text(now), power.shed_w()));
  }
  return true;
}

// Planners count on the reserve, so a charge below it is reported long before the battery is empty.
void SupplyWatch::warn_of_low_charge(const RoverPower& power, SimTime now, RoverJournal& journal) {
  if (has_warned_of_low_ || !power.has_battery()) return;
  // A battery that has lost all its capacity holds nothing.
  const double charge = power.capacity_j() > 0 ? power.account().energy_j / power.capacity_j() : 0;
  if (!(charge < power.reserve())) return;
  has_warned_of_low_ = true;
  journal.warn(
      fmt::format("{}: at {} its charge is {:.1f} %, below the reserve of {:.4g} %; "
                  "it does not drive before it is above {:.4g} %",
                  journal.rover_id(), moment_text(now), 100 * charge, 100 * power.reserve(),
                  100 * power.drives_again_at()));
}

// observe() reports an empty battery.
void SupplyWatch::warn_of_shed_loads(const RoverPower& power, SimTime now, RoverJournal& journal) {
  if (has_warned_of_shed_ || !(power.account().energy_j > 0)) return;
  has_warned_of_shed_ = true;
  journal.warn(fmt::format(
      "{}: at {} its loads and motors ask {:.0f} W more than its battery gives; events go on "
      "as if they had them, and the energy is not counted",
      journal.rover_id(), moment_text(now), power.shed_w()));
}

void SupplyWatch::settle(RoverPower& power, SimTime now, RoverJournal& journal) {
  report_short_supply(power, now, journal);
  const double shed_w = power.shed_w();
  if ((shed_w > 0) == is_shedding_) return;
  is_shedding_ = shed_w > 0;
  journal.set_sequence(0);
  if (is_shedding_) {
    warn_of_shed_loads(power, now, journal);
    journal.note("loads_shed", fmt::format(R"({{"shed_w":{}}})", note_json(shed_w)));
  } else {
    journal.note("loads_restored", "{}");
  }
}

void SupplyWatch::archive(Archive& a) {
  LSOS_ARCHIVE(a, is_shedding_, has_warned_of_empty_, has_warned_of_low_, has_warned_of_shed_);
}

}  // namespace lsos
