#include "mission/estimate/estimate_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/rounding.h"
#include "mission/estimate/event_ranges.h"
#include "mission/light/sight_watch.h"
#include "mission/light/sun_watch.h"

namespace lsos {

namespace {

// Share of its light from which a panel surely is in the Sun; less may be a sliver of its disc.
constexpr double clear_share = 0.25;
// Visible shares of Earth's disc between which its centre is within a third of its radius of the
// horizon: it moves about as far between two looks of an estimate.
constexpr double earth_surely = 0.7, earth_perhaps = 0.3;

// Greatest share of a panel that is up which the Sun reaches; absent without a panel.
std::optional<double> lit_share(const RoverAgent& rover) {
  const std::optional<PanelSunlight>& sun = rover.power().sun();
  if (!sun || sun->panels.empty()) return {};
  double most = 0;
  for (const PanelSunlight::Panel& panel : sun->panels) {
    if (panel.cosine > 0) most = std::max(most, panel.sun_fraction);
  }
  return most;
}

// Adds a span, which may continue the last one.
void extend(std::vector<ShadeSpan>& spans, double begin_s, double end_s) {
  if (end_s <= begin_s) return;
  if (!spans.empty() && spans.back().end_s == begin_s) {
    spans.back().end_s = end_s;
  } else {
    spans.push_back({begin_s, end_s});
  }
}

Expected share(const HeldSums& sums, double all_s) {
  return {std::clamp(sums.surely_s / all_s, 0.0, 1.0),
          std::clamp(sums.perhaps_s / all_s, 0.0, 1.0)};
}

// The other rover that stands where this one is, "" without any. Drives of an estimate go through
// each other, while those of a run end before they touch.
std::string standing_at(const Fleet& fleet, std::size_t k) {
  const Footprint footprint = fleet.rovers[k].agent->motion().footprint();
  for (std::size_t other = 0; other < fleet.rovers.size(); ++other) {
    const RoverAgent& agent = *fleet.rovers[other].agent;
    if (other == k || agent.drive().is_carried()) continue;
    if (overlap(footprint, agent.motion().footprint())) return agent.id();
  }
  return "";
}

}  // namespace

void EstimateWatch::look(const Fleet& fleet, SimTime now) {
  rovers_.resize(fleet.rovers.size());
  const double passed_s = seconds(now - last_);
  for (std::size_t k = 0; k < fleet.rovers.size(); ++k) {
    const RoverAgent& agent = *fleet.rovers[k].agent;
    const EventRecords& records = fleet.rovers[k].sequence.records();
    Watched& rover = rovers_[k];
    rover.sums.resize(records.size());
    rover.days.add({seconds(now), agent.view().distance_m, agent.power().energy_used_j(),
                    agent.power().solar_j(), agent.power().view().charge});
    pass(rover, agent, passed_s);
    Sums none;
    Sums& sums = rover.running ? rover.sums[*rover.running] : none;
    if (rover.running && records[*rover.running].end) {
      const EventRecord& ended = records[*rover.running];
      if (ended.distance_m > 0) sums.meets = standing_at(fleet, k);
      const bool is_at_charge = rover.awaited_charge && ended.charge_end >= *rover.awaited_charge;
      if (is_at_charge) sums.charging_w = std::max(0.0, rover.energy_rate_w);
    }
    if (rover.lit == 0) {
      extend(rover.is_stowed ? rover.shade.stowed : rover.shade.dark, seconds(last_), seconds(now));
    }
    if (rover.seen == 0) extend(rover.shade.unseen, seconds(last_), seconds(now));
    find_sun(rover, agent, sums);
    find_earth(rover, agent, now, sums);
    rover.is_driving = agent.drive().is_carried();
    rover.is_turning = agent.power().is_panel_turning();
    rover.awaited_charge = agent.power().claims().charge_awaited;
    rover.energy_rate_w = agent.power().has_battery() ? agent.power().flows().energy_rate_w : 0;
    const std::optional<std::size_t> was_running = std::exchange(rover.running, {});
    while (rover.first < records.size() && records[rover.first].end) ++rover.first;
    for (std::size_t i = rover.first; i < records.size() && !rover.running; ++i) {
      if (records[i].status == EventStatus::running) rover.running = i;
    }
    if (rover.running != was_running) {
      rover.held_lit.end_event(sums.lit);
      rover.held_seen.end_event(sums.seen);
    }
    rover.lacks.look(fleet, k, rover.running, {rover.lit == 0, rover.seen > 0}, seconds(now));
  }
  last_ = now;
  const bool is_running =
      std::ranges::any_of(rovers_, [](const Watched& rover) { return rover.running.has_value(); });
  if (is_running) {
    idle_since_.reset();
  } else if (!idle_since_) {
    idle_since_ = now;
  }
}

void EstimateWatch::pass(Watched& rover, const RoverAgent& agent, double passed_s) {
  const double charge = agent.power().view().charge;
  const DriveDoubt drives = agent.drive().doubt();
  Sums of_none;
  Sums& running = rover.running ? rover.sums[*rover.running] : of_none;
  running.all_s += passed_s;
  running.charge_min = std::fmin(running.charge_min, charge);
  const bool is_moving = rover.is_driving || rover.is_turning;
  rover.held_lit.pass(passed_s, is_moving, running.lit);
  rover.held_seen.pass(passed_s, is_moving, running.seen);
  if (!std::isnan(rover.seen)) running.sight_s += passed_s;
  running.loads_less_j += rover.loads_less.used_w * passed_s;
  running.loads_more_j += rover.loads_more.used_w * passed_s;
  running.drives += drives - rover.drives;
  rover.drives = drives;
  const std::size_t at = rover.running.value_or(rover.first);
  if (at >= rover.sums.size()) return;
  Sums& sums = rover.sums[at];
  sums.sun_less_j += (rover.sun_less_w + rover.loads_more.stored_w) * passed_s;
  sums.sun_more_j += (rover.sun_more_w + rover.loads_less.stored_w) * passed_s;
  if (charge >= full_charge) {
    sums.sun_less_j = sums.sun_more_j = 0;
    sums.was_full = true;
  }
}

void EstimateWatch::find_sun(Watched& rover, const RoverAgent& agent, Sums& sums) {
  const RoverPower& power = agent.power();
  const std::optional<double> lit = lit_share(agent);
  const std::optional<PanelSunlight>& sun = power.sun();
  const bool is_anew = sun && rover.sun_time != sun->time;
  rover.lit = lit ? *lit > 0 : not_modelled;
  rover.held_lit.find(lit >= clear_share, lit > 0.0, is_anew, is_anew ? sun->ahead_s : 0, sums.lit);
  rover.is_stowed = lit && !power.panels().is_any_up();
  rover.loads_less = rover.loads_more = {};
  if (sun && sun->is_dark && sun->may_be_lit) {
    rover.loads_less = power.load_doubt(false, agent.is_parked());
  }
  if (sun && !sun->is_dark && sun->may_be_dark) {
    rover.loads_more = power.load_doubt(true, agent.is_parked());
  }
  if (!is_anew) return;
  rover.sun_time = sun->time;
  rover.sun_less_w = sun->less_w;
  rover.sun_more_w = sun->more_w;
}

void EstimateWatch::find_earth(Watched& rover, const RoverAgent& agent, SimTime now, Sums& sums) {
  const std::optional<PairSight> earth = agent.sight_of(earth_id);
  rover.seen = earth ? earth->is_visible : not_modelled;
  bool surely = rover.seen > 0, perhaps = surely;
  if (earth && earth->is_visible) surely = earth->fraction >= earth_surely;
  // A disc that a body hides counts as hidden whole.
  if (earth && !earth->is_visible) perhaps = earth->fraction >= earth_perhaps;
  // It is looked at as panels turn, at whole multiples of the period, and as they arrive.
  const bool is_turn_seen = rover.is_turning && (now % estimate_turn_period == SimTime{} ||
                                                 !agent.power().is_panel_turning());
  const bool is_anew = agent.drive().has_passed_mark() || is_turn_seen;
  rover.held_seen.find(surely, perhaps, is_anew, 0, sums.seen);
}

std::vector<RoverShade> EstimateWatch::shades(const Fleet& fleet) const {
  std::vector<RoverShade> shades;
  for (std::size_t k = 0; k < rovers_.size(); ++k) {
    shades.push_back(rovers_[k].shade);
    shades.back().rover_id = fleet.rovers[k].agent->id();
  }
  return shades;
}

std::vector<DayEstimate> EstimateWatch::days(const Fleet& fleet) const {
  std::vector<DayEstimate> days;
  for (std::size_t k = 0; k < rovers_.size(); ++k) {
    for (DayEstimate& day : rovers_[k].days.days()) {
      day.rover_id = fleet.rovers[k].agent->id();
      days.push_back(std::move(day));
    }
  }
  return days;
}

std::vector<Lack> EstimateWatch::lacks() const {
  std::vector<Lack> lacks;
  for (const Watched& rover : rovers_) {
    for (Lack& lack : rover.lacks.lacks(seconds(last_))) lacks.push_back(std::move(lack));
  }
  return lacks;
}

std::vector<EventEstimate> EstimateWatch::events(const Fleet& fleet, Instant mission_start) const {
  std::vector<EventEstimate> events;
  std::vector<DoubtedEvent> doubted;
  std::vector<std::size_t> doubted_at;  // places of their estimates
  for (std::size_t k = 0; k < fleet.rovers.size(); ++k) {
    const EventSequence& sequence = fleet.rovers[k].sequence;
    const bool has_panels = !fleet.rovers[k].agent->power().panels().specs().empty();
    for (std::size_t i = 0; i < sequence.events().size(); ++i) {
      const PlanEvent& planned = sequence.events()[i].event;
      if (!planned.is_enabled) continue;
      const EventRecord& record = sequence.records()[i];
      EventEstimate& event = events.emplace_back();
      event.rover_id = planned.rover_id;
      event.sequence = planned.sequence;
      event.type = planned.type;
      event.label = planned.label;
      event.status = sequence.row(i).status;
      event.reason = record.reason;
      event.waits_in_vain = record.has_waited_in_vain();
      event.meets = rovers_[k].sums[i].meets;
      if (record.ready) event.ready_s = seconds(*record.ready);
      if (record.start) event.start_s = seconds(*record.start);
      if (record.end) event.over_s = seconds(*record.end);
      if (!record.start || !record.end) continue;
      event.end_s = seconds(*record.end);
      event.distance_m = if_known(record.distance_m);
      event.energy_used_j = if_known(record.energy_used_j);
      event.solar_j = if_known(record.solar_j);
      event.charge_end = if_known(record.charge_end);
      const Sums& sums = rovers_[k].sums[i];
      const RoverPower& power = fleet.rovers[k].agent->power();
      DoubtedEvent& doubt = doubted.emplace_back();
      doubt.planned = &planned;
      doubt.drives = sums.drives;
      doubt.capacity_j = power.has_battery() ? power.capacity_j() : 0;
      doubt.sun_less_j = sums.sun_less_j;
      doubt.sun_more_j = sums.sun_more_j;
      doubt.loads_less_j = sums.loads_less_j;
      doubt.loads_more_j = sums.loads_more_j;
      doubt.was_full = sums.was_full;
      doubt.charging_w = sums.charging_w;
      doubted_at.push_back(events.size() - 1);
      event.charge_min =
          if_known(std::fmin(sums.charge_min, std::fmin(record.charge_start, record.charge_end)));
      if (sums.all_s <= 0) continue;
      if (has_panels) event.sunlit_share = share(sums.lit, sums.all_s);
      if (sums.sight_s > 0) event.earth_visible_share = share(sums.seen, sums.sight_s);
    }
  }
  for (std::size_t n = 0; n < doubted.size(); ++n) doubted[n].estimate = &events[doubted_at[n]];
  add_ranges(doubted, mission_start);
  return events;
}

}  // namespace lsos
