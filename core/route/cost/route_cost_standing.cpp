// Where a rover would come too near to the objects that stand beside a route.
#include <algorithm>
#include <cmath>

#include "route/cost/route_cost.h"

namespace lsos {

namespace {

// Distance over which a rover may drive along objects after a start without room to turn.
constexpr double leaving_room_m = 25;
// Extra distance from objects meanwhile: before a corner the rover begins to turn, and its tail
// swings out.
constexpr double corner_room_m = 2;

}  // namespace

bool RouteCost::is_occupied(const Vec2& at_m, const Vec2& ahead) const {
  if (standing_.empty()) return false;
  const Footprint rover = moved(rover_at_rest_, at_m, is_backing_ ? Vec2(-ahead) : ahead);
  const double off_m = rover.half_m.norm() + cross_track_margin_m;
  const bool is_tight =
      std::ranges::any_of(tight_, [&](const Disc2& disc) { return disc.holds(at_m); });
  const Vec2 from_start_m = at_m - (tight_.empty() ? at_m : tight_.front().center_m);
  const bool is_at_start = is_tight && tight_.front().holds(at_m);
  // A rover without room to turn drives straight on until it has room.
  const bool is_confined = !turn_room_.is_all_round() && from_start_m.norm() < leaving_room_m;
  const bool leaves = is_at_start || is_confined;
  const bool has_turned = !turn_room_.allows(std::atan2(ahead.y(), ahead.x()));
  const double near_m = is_confined ? off_m + corner_room_m : off_m;
  return std::ranges::any_of(standing_, [&](const Footprint& thing) {
    if (distance_m(thing, rover.center_S_m) >= near_m) return false;
    if (leaves && has_turned) return true;
    if (!leaves && !is_tight) return true;
    return gap_m(thing, rover) <= (is_at_start ? 0 : clearance_m);
  });
}

}  // namespace lsos
