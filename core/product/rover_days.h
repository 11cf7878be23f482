// What each rover did on each day of a mission: a table for planners, in summary.json, days.csv and
// the report.
#pragma once

#include <string>
#include <vector>

#include "base/sim_time.h"
#include "record/log.h"

namespace lsos {

// Days are counted from the start of the mission. NaN: not modelled.
struct RoverDay {
  std::string rover_id;
  int day = 1;
  double from_s = 0, to_s = 0;  // mission time
  double distance_m = 0;
  double drive_s = 0;  // faster than 1 mm/s
  double energy_used_j = not_modelled, solar_j = not_modelled, external_j = not_modelled;
  double charge_start = not_modelled, charge_min = not_modelled;
  double charge_max = not_modelled, charge_end = not_modelled;  // 0..1
  // When the middle of the Sun rises for the first time and sets for the last time on the day.
  double charge_dawn = not_modelled, charge_dusk = not_modelled;
  double sunlit_s = not_modelled;  // some sunlight falls on it
  double earth_visible_s = not_modelled, earth_link_s = not_modelled;
  double max_slope_rad = not_modelled;  // of the samples
  double events_ended = 0, evas = 0;    // counts; an EVA counts where it begins
};

// The last day may be shorter. Values between two samples are linear. In the order of rovers, then
// days.
std::vector<RoverDay> rover_days(const LogReader& log);
// The same of a mission that is longer than a day; none of a shorter one.
std::vector<RoverDay> days_of_long_run(const LogReader& log);

// The numbers of a day, by the names that files have for them.
struct DayColumn {
  const char* name;
  double RoverDay::*value;
};
const std::vector<DayColumn>& day_columns();

// A header and a row a day, with RFC 4180's commas.
std::string days_csv(const std::vector<RoverDay>& days, Instant start);

// Writes DIR/days.csv of a finished run that is longer than a day: that of one which goes on would
// lack the sight of Earth that has not ended.
void write_days(const std::string& run_dir);

}  // namespace lsos
