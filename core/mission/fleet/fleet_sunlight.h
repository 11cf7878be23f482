// Sunlight on the panels of rovers and assets: evaluated when it is due, else it holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mission/fleet/fleet.h"
#include "mission/light/light.h"
#include "mission/light/sight_over_end.h"
#include "mission/light/sun_watch.h"
#include "planet/sunlight.h"

namespace lsos {

class FleetSunlight {
 public:
  static constexpr int estimate_steps = 8;

  // Ground and renderer must outlive it. `optical_depth`: of the air's dust, straight up; `albedo`:
  // share of sunlight that the ground reflects; absent: what the body assumes.
  // `is_estimate`: evaluates it for parked rovers alone, when the Sun has moved `estimate_steps`
  // times as far, and each estimate_turn_period while panels turn.
  FleetSunlight(const Ground& ground, Renderer& renderer, std::optional<double> optical_depth,
                std::optional<double> albedo, bool is_estimate = false);

  // Evaluates the rovers that are due.
  void update(Fleet& fleet, const Moment& moment);
  // Evaluates an asset's panels when it is due.
  void update(StandingAsset& asset, const Fleet& fleet, const Moment& moment);
  // When a parked rover, or the asset that it is plugged into, is next due if nothing else happens;
  // absent: never.
  std::optional<SimTime> wake(const RoverAgent& rover, const Fleet& fleet, SimTime now) const;

  // Sights of the Sun over the end of the known ground.
  const SightOverEnd& over_end() const { return over_end_; }
  std::vector<std::string> assumptions() const;

  void archive(Archive& a) { LSOS_ARCHIVE(a, over_end_); }

 private:
  const Body& body() const { return ground_->site().body(); }
  SimTime interval() const { return (is_estimate_ ? estimate_steps : 1) * sun_interval(body()); }
  // Panels turn a long way in one go, so that what they give meanwhile counts. While an estimate
  // carries a rover along its line, it is looked at at the marks of that.
  bool follows_turns(const RoverAgent& rover) const {
    return rover.power().is_panel_turning() && !(is_estimate_ && rover.drive().is_carried());
  }
  SimTime turn_period() const { return is_estimate_ ? estimate_turn_period : moving_update_period; }
  bool is_due(const RoverAgent& rover, SimTime now, Motion near) const;
  bool is_due(const StandingAsset& asset, SimTime now, Motion near) const;
  Sunlight sunlight_at(const Geodetic& place, const Moment& moment) const;

  const Ground* ground_;
  Light light_;
  SightOverEnd over_end_;
  double optical_depth_ = 0, albedo_ = 0;
  bool is_depth_assumed_ = false;
  bool is_estimate_ = false;
};

}  // namespace lsos
