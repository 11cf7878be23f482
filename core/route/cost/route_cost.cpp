#include "route/cost/route_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/rounding.h"
#include "base/segment.h"
#include "driving/fillet.h"
#include "driving/side_slip.h"
#include "route/cost/stance_drive.h"

namespace lsos {

namespace {

// Longest step of the midpoint rule, in map spacings: a diagonal of the lattice is one step. And
// the step of a denser check.
constexpr double step_spacings = 1.5, close_spacings = 0.5;
// Used share of a limit above which the ground `cross_track_margin_m` to either side is checked
// too; below it that ground is taken to be as good.
constexpr double near_limit = StanceFinder::far_share;
// Least share left of a limit in the cost of risk: nearer to the limit a metre costs no more.
constexpr double share_left_min = 0.05;

// Calls what(stance, at, step) along a straight piece until it returns false.
template <class What>
bool walk(GroundMap& map, const StanceFinder& finder, const Vec2& from_m, const Vec2& to_m,
          const What& what, double longest_spacings = step_spacings) {
  const Vec2 delta_m = to_m - from_m;
  const double length_m = delta_m.norm();
  if (length_m < 1e-9) return true;
  const Vec2 ahead = delta_m / length_m;
  const int steps =
      std::max(1, static_cast<int>(std::ceil(length_m / (longest_spacings * map.spacing_m()))));
  for (int k = 0; k < steps; ++k) {
    const Vec2 at_m = from_m + delta_m * ((k + 0.5) / steps);
    if (!what(finder.at(map, at_m, ahead), at_m, length_m / steps)) return false;
  }
  return true;
}

}  // namespace

double arc_speed_mps(const DriveCost& cost, double radius_m) {
  return std::min(arc_speed_mps(radius_m, cost.speed_mps, cost.acceleration_mps2),
                  side_slip_arc_speed_mps(radius_m, cost.side_slip_s2pm, cost.side_grip_mps2));
}

double ArcCost::of(double bend_rad) const {
  constexpr double straight_rad = 1e-3;
  return bend_rad < straight_rad ? 0 : slowing + per_rad * bend_rad;
}

ArcCost arc_cost_j(const DriveCost& cost, double radius_m) {
  const double share = arc_speed_mps(cost, radius_m) / cost.speed_mps;
  const double longer_spm = (1 / share - 1) / cost.speed_mps;
  const double powers_w = cost.load_w + cost.idle_w;
  return {cost.slow_j * (1 - share * share) + powers_w * cost.stop_s * (1 - share) * (1 - share),
          cost.arc_drag_jmprad * std::pow(share, 4) / radius_m + powers_w * radius_m * longer_spm};
}

ArcCost arc_price_m(const DriveCost& cost, double radius_m) {
  if (cost.soils.front().by_slope.empty()) return {};
  const double level_jpm = std::max(1e-9, cost.level_jpm());
  const ArcCost of_j = arc_cost_j(cost, radius_m);
  return {of_j.slowing / level_jpm, of_j.per_rad / level_jpm};
}

RouteCost::RouteCost(GroundMap& map, const StanceFinder& finder, RouteAim aim,
                     std::vector<Disc2> avoided)
    : map_(map), finder_(finder), aim_(aim), avoided_(std::move(avoided)) {
  find_least();
  border_m_ = finder.reach_m() + 2 * map.spacing_m();
  // For RouteAim::risk the energy of a corner counts as the distance that it would drive on the
  // level.
  if (aim_ == RouteAim::risk && !finder_.cost().soils.front().by_slope.empty()) {
    cost_per_j_ = 1 / std::max(1e-9, finder_.cost().level_jpm());
  }
}

RouteCost RouteCost::over(GroundMap& map) const {
  RouteCost costs(map, finder_, aim_, avoided_);
  costs.tight_ = tight_;
  costs.standing_ = standing_;
  costs.rover_at_rest_ = rover_at_rest_;
  costs.turn_room_ = turn_room_;
  costs.leaving_ = leaving_;
  costs.leaving_limits_ = leaving_limits_;
  costs.is_rounding_ = is_rounding_;
  costs.is_backing_ = is_backing_;
  return costs;
}

RouteCost RouteCost::of_rounded_corners() const {
  RouteCost costs = *this;
  costs.is_rounding_ = true;
  return costs;
}

Hazard RouteCost::hazard_at(const Stance& stance, const Vec2& at_m, const Vec2& ahead) {
  const auto holds = [&](const Disc2& disc) { return disc.holds(at_m); };
  if (std::ranges::any_of(avoided_, holds) || is_occupied(at_m, ahead)) return Hazard::avoided;
  if (finder_.is_far_from_limits(stance)) return Hazard::none;
  if (leaving_.holds(at_m)) return hazard(stance, finder_.cost(), leaving_limits_);
  const Hazard here = hazard(stance, finder_.cost());
  if (here != Hazard::none || limit_use(stance, finder_.cost()) < near_limit) return here;
  if (std::ranges::any_of(tight_, holds)) return here;
  const Vec2 left(-ahead.y(), ahead.x());
  for (const double side_m : {cross_track_margin_m, -cross_track_margin_m}) {
    const Hazard beside = hazard(finder_.at(map_, at_m + side_m * left, ahead), finder_.cost());
    if (beside != Hazard::none) return beside;
  }
  return Hazard::none;
}

// Finds a linear lower bound of the energy per metre over all slopes and soils:
//  E(slope) >= least + per_rise sin(slope).
// A route of some length and rise needs at least so much. With the share of the climb in it,
// `least` is a tight bound although going down costs next to nothing.
void RouteCost::find_least() {
  if (aim_ == RouteAim::risk) return;
  const auto least_with = [&](double per_rise) {
    double least = infinite;
    for (const SoilDrive& soil : finder_.cost().soils) {
      for (std::size_t k = 0; k < soil.by_slope.size(); ++k) {
        const double slope_rad = soil.first_rad + soil.step_rad * static_cast<double>(k);
        const SlopeDrive& drive = soil.by_slope[k];
        const double energy_jpm = drive.energy_jpm + finder_.cost().idle_w / drive.speed_mps;
        least = std::min(least, energy_jpm - per_rise * std::sin(slope_rad));
      }
    }
    return least;
  };
  double most_jpm = 0;
  for (const SoilDrive& soil : finder_.cost().soils) {
    for (const SlopeDrive& drive : soil.by_slope) most_jpm = std::max(most_jpm, drive.energy_jpm);
  }
  // The bound is concave in the share of the climb. Where energy is convex by slope its greatest
  // value is that of a level metre, so that on level ground the bound is exact.
  double low = 0, high = 4 * most_jpm;
  constexpr int thirds = 100;
  for (int k = 0; k < thirds; ++k) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    if (least_with(left) < least_with(right)) {
      low = left;
    } else {
      high = right;
    }
  }
  per_rise_ = (low + high) / 2;
  least_per_metre_ = least_with(per_rise_);
  least_per_metre_ = std::max(0.0, least_per_metre_);
  if (finder_.cost().soils.front().by_slope.empty()) return;
  steep_per_metre_ = std::max(0.0, finder_.cost().level_jpm()) +
                     per_rise_ * std::sin(finder_.cost().limits.slope_max_rad);
}

double RouteCost::rate(const Stance& stance) const {
  const DriveCost& cost = finder_.cost();
  const double ratio = is_backing_ ? backing_ratio : 1;
  if (aim_ == RouteAim::risk) return ratio / std::max(share_left_min, 1 - limit_use(stance, cost));
  return ratio * stance_drive(finder_.cost(), stance).energy_jpm;
}

double RouteCost::straight(const Vec2& from_m, const Vec2& to_m, double most) {
  double sum = 0;
  const Vec2 ahead = (to_m - from_m).normalized();
  const bool is_free =
      walk(map_, finder_, from_m, to_m, [&](const Stance& stance, const Vec2& at_m, double step_m) {
        if (hazard_at(stance, at_m, ahead) != Hazard::none) return false;
        sum += rate(stance) * step_m / std::cos(stance.pitch_rad);
        return sum <= most;
      });
  return is_free ? sum : infinite;
}

RouteCost::CornerCost RouteCost::corner_cost(const Vec2& before_m, const Vec2& at_m,
                                             const Vec2& after_m) const {
  const DriveCost& cost = finder_.cost();
  if (!cost.can_turn_on_spot && !is_rounding_) return {};
  const Vec2 in_m = at_m - before_m, out_m = after_m - at_m;
  const double bend_rad = std::abs(lsos::bend_rad(in_m, out_m));
  constexpr double straight_rad = 0.01;
  if (bend_rad < straight_rad) return {};
  const double room_m = std::min(in_m.norm(), out_m.norm()) / 2;
  if (is_rounding_) return rounding(bend_rad, room_m);
  const double radius_m = fillet_radius_m(bend_rad, room_m, fillet_offset_m);
  if (radius_m < cost.turning_radius_min_m) {
    const CornerCost turned = turning(bend_rad);
    return {cost.stop_j + cost.idle_w * cost.stop_s + turned.energy_j,
            cost.stop_s + turned.duration_s};
  }
  const double arc_mps = arc_speed_mps(cost, radius_m);
  const double share = arc_mps / cost.speed_mps, left = 1 - share;
  const double longer_s =
      cost.stop_s * left * left + radius_m * bend_rad * (1 / arc_mps - 1 / cost.speed_mps);
  return {cost.stop_j * (1 - share * share) +
              cost.arc_drag_jmprad * std::pow(share, 4) * bend_rad / radius_m +
              cost.idle_w * longer_s,
          longer_s};
}

// Cost of rounding a corner by an arc that begins `room_m` before it.
RouteCost::CornerCost RouteCost::rounding(double bend_rad, double room_m) const {
  const DriveCost& cost = finder_.cost();
  const double radius_m = room_m / std::tan(bend_rad / 2);
  const double arc_j = arc_cost_j(cost, radius_m).of(bend_rad);
  if (radius_m >= cost.turning_radius_min_m) return {arc_j, 0};
  // Where the tightest arc has no room, more than any arc costs, growing as the room shrinks; also
  // where slowing down is free because the soil's drag does it.
  const double radius_j = cost.level_jpm() * cost.turning_radius_min_m;
  return {arc_j + std::max(cost.slow_j, radius_j) * cost.turning_radius_min_m / radius_m, 0};
}

RouteCost::CornerCost RouteCost::turning(double by_rad) const {
  constexpr double straight_rad = 0.03;  // as in PathFollower
  const DriveCost& cost = finder_.cost();
  if (by_rad < straight_rad) return {};
  const double turning_s = cost.steer_s + cost.turn_sprad * by_rad;
  return {cost.turn_jprad * by_rad + cost.idle_w * turning_s, turning_s};
}

double RouteCost::corner(const Vec2& before_m, const Vec2& at_m, const Vec2& after_m) const {
  return cost_per_j_ * corner_cost(before_m, at_m, after_m).energy_j;
}

double RouteCost::along(const Line2& line, double most) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < line.size() && std::isfinite(sum); ++k) {
    sum += straight(line[k], line[k + 1], most - sum);
    if (k > 0) sum += corner(line[k - 1], line[k], line[k + 1]);
  }
  return sum <= most ? sum : infinite;
}

double RouteCost::driven(const Line2& line) {
  if (finder_.cost().can_turn_on_spot || is_rounding_) return along(line);
  ArcState speeds;
  return arcs(speeds, line) + along(line);
}

double RouteCost::price(const CornerCost& arcs) const {
  return cost_per_j_ * (arcs.energy_j + finder_.cost().load_w * arcs.duration_s);
}

RouteCost::CornerCost RouteCost::arc_driven(ArcState& speeds, double radius_m,
                                            double bend_rad) const {
  const DriveCost& cost = finder_.cost();
  const double was = speeds.share, now = arc_speed_mps(cost, radius_m) / cost.speed_mps;
  // Between two arcs the rover speeds up to a peak and slows down again.
  const double gained = speeds.free_m / (cost.stop_s * cost.speed_mps);
  const double reached = std::sqrt((was * was + now * now) / 2 + gained);
  const double peak = std::max({was, now, std::min(1.0, reached)});
  const double changing_m =
      cost.stop_s * cost.speed_mps * (2 * peak * peak - was * was - now * now) / 2;
  const double length_m = radius_m * bend_rad, free_m = speeds.free_m;
  speeds.share = now;
  speeds.free_m = 0;
  const double now2 = now * now;
  const double longer_s =
      cost.stop_s * (2 * peak - was - now) +
      ((free_m - changing_m) / peak - free_m + length_m / now - length_m) / cost.speed_mps;
  return {cost.slow_j * (peak * peak - now2) +
              cost.arc_drag_jmprad * now2 * now2 * bend_rad / radius_m + cost.idle_w * longer_s,
          longer_s};
}

RouteCost::CornerCost RouteCost::arcs_driven(ArcState& speeds, const Line2& line) const {
  CornerCost sum;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec2 out_m = line[k + 1] - line[k];
    if (out_m.isZero(0)) continue;
    const Vec2 in_m = std::exchange(speeds.in_m, out_m);
    if (in_m.isZero(0)) continue;
    speeds.free_m += in_m.norm();
    const double bend_rad = std::abs(lsos::bend_rad(in_m, out_m));
    constexpr double straight_rad = 0.01;  // driving_line() lays no arc there
    if (bend_rad < straight_rad) continue;
    const double length_m = std::min(in_m.norm(), out_m.norm());
    speeds.free_m = std::max(0.0, speeds.free_m - length_m / 2);
    const CornerCost arc = arc_driven(speeds, length_m / bend_rad, bend_rad);
    sum.energy_j += arc.energy_j;
    sum.duration_s += arc.duration_s;
    speeds.free_m = -length_m / 2;
  }
  return sum;
}

std::vector<Vec2> RouteCost::hazards(const Line2& line, double apart_m) {
  std::vector<Vec2> found;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    walk(
        map_, finder_, line[k], line[k + 1],
        [&](const Stance& stance, const Vec2& at_m, double) {
          const bool is_hazard =
              !finder_.is_far_from_limits(stance) && hazard(stance, finder_.cost()) != Hazard::none;
          if (is_hazard && (found.empty() || (at_m - found.back()).norm() > apart_m)) {
            found.push_back(at_m);
          }
          return true;
        },
        close_spacings);
  }
  return found;
}

bool RouteCost::can_stand(const Vec2& at_m, const Vec2& ahead) {
  const Stance stance = finder_.at(map_, at_m, ahead);
  return hazard_at(stance, at_m, ahead) == Hazard::none && can_stop(stance, finder_.cost());
}

LegSummary RouteCost::of(const Line2& line) {
  LegSummary sum;
  const DriveCost& cost = finder_.cost();
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec2 ahead = (line[k + 1] - line[k]).normalized();
    walk(map_, finder_, line[k], line[k + 1],
         [&](const Stance& stance, const Vec2& at_m, double step_m) {
           sum.hazard = hazard_at(stance, at_m, ahead);
           if (sum.hazard != Hazard::none) {
             sum.hazard_m = at_m;
             return false;
           }
           const SlopeDrive drive = stance_drive(finder_.cost(), stance);
           const double along_m = step_m / std::cos(stance.pitch_rad);
           sum.cost += rate(stance) * along_m;
           sum.length_m += along_m;
           sum.energy_j += drive.energy_jpm * along_m;
           sum.duration_s += along_m / drive.speed_mps;
           if (stance.slope_rad > sum.slope_max_rad) {
             sum.slope_max_rad = stance.slope_rad;
             sum.steepest_m = at_m;
           }
           return true;
         });
    if (sum.hazard != Hazard::none) {
      sum.cost = infinite;
      break;
    }
    if (k == 0) continue;
    const CornerCost corner = corner_cost(line[k - 1], line[k], line[k + 1]);
    sum.cost += cost_per_j_ * corner.energy_j;
    sum.energy_j += corner.energy_j;
    sum.duration_s += corner.duration_s;
  }
  if (!cost.can_turn_on_spot && sum.hazard == Hazard::none) {
    ArcState speeds;
    const CornerCost turned = arcs_driven(speeds, line);
    sum.cost += price(turned);
    sum.energy_j += turned.energy_j;
    sum.duration_s += turned.duration_s;
  }
  return sum;
}

}  // namespace lsos
