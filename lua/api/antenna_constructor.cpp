#include "lua/api/antenna_constructor.h"

namespace lsos {

namespace {

void read_antenna(TableReader& t, AntennaSpec& antenna) {
  t.text(required, "name", antenna.name, "What a plan's Asset says.");
  t.vec3(required, "position_m", antenna.p_B_m, "When up: forward, left, up.");
  t.vec3(optional, "stowed_position_m", antenna.stowed_p_B_m,
         "When stowed, as it is at the start; without one it is always up.");
  t.number(optional, "deploy_s", antenna.deploy_s, not_negative,
           "How long raising and lowering take when an event does not say (default 0).");
  t.number(optional, "deploy_w", antenna.deploy_w, not_negative, "Meanwhile (default 0).");
  t.number(optional, "power_w", antenna.power_w, not_negative, "While it is up (default 0).");
  t.number(optional, "range_max_m", antenna.range_max_m, positive,
           "How far it links to rovers and assets (default no limit).");
  t.boolean(optional, "reaches_earth", antenna.reaches_earth, "Links to Earth too (default true).");
}

}  // namespace

void read_antennas(TableReader& t, std::vector<AntennaSpec>& antennas) {
  t.list(optional, "antennas", "antenna", antennas,
         "In the order of preference: the first that is up is used (default: one on top, always "
         "up).");
  check_unique_names(t, "antennas", antennas);
}

std::vector<Constructor> antenna_constructors() {
  return {constructor<AntennaSpec, read_antenna>(
      "antenna", "What sees and is seen, and talks, on a mast that may be stowed.")};
}

}  // namespace lsos
