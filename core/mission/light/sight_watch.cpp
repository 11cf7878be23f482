#include "mission/light/sight_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/segment.h"
#include "mission/light/sun_watch.h"
#include "planet/sky.h"

namespace lsos {

namespace {

constexpr double speed_of_light_mps = 299792458;
// Least time between two evaluations of an estimate because something else moves near an end:
// panels that follow the Sun move often, and little at a time.
constexpr SimTime estimate_least{60'000'000};

}  // namespace

SimTime earth_interval(const Body& body) { return from_seconds(body.earth_interval_s); }

SightWatch::SightWatch(const Ground& ground, Renderer& renderer, std::size_t ends, bool is_estimate)
    : ground_(&ground),
      sight_(ground, renderer),
      earth_over_end_(ground, "Earth"),
      pairs_over_end_(ground, "another antenna"),
      earth_(ends),
      is_estimate_(is_estimate) {
  const bool has_earth = ground.site().body().name != earth_id;
  for (std::size_t from = 0; from < ends; ++from) {
    for (std::size_t to = from + 1; to < ends + (has_earth ? 1 : 0); ++to) {
      Pair& pair = pairs_.emplace_back();
      pair.from = from;
      pair.to = to;
    }
  }
}

bool SightWatch::is_near(const Pair& pair, const SightEnd& other,
                         const std::vector<SightEnd>& ends) const {
  const Vec3& from_S_m = ends[pair.from].antenna_S_m;
  if (pair.to == earth_) return (other.p_S_m - from_S_m).norm() < shading_reach_m + other.reach_m;
  return point_distance_m(from_S_m, ends[pair.to].antenna_S_m, other.p_S_m) <
         other.reach_m + beyond_reach_m;
}

// How long a result between parked ends holds.
SimTime SightWatch::interval(const Pair& pair) const {
  const Body& body = ground_->site().body();
  if (pair.to == earth_) return (is_estimate_ ? estimate_steps : 1) * earth_interval(body);
  return pair.is_near_turning ? sun_interval(body) : SimTime::max() / 2;
}

bool SightWatch::is_due(const Pair& pair, SimTime now, const std::vector<SightEnd>& ends) const {
  if (!pair.time) return true;
  const bool is_to_earth = pair.to == earth_;
  if (now >= *pair.time + interval(pair)) return true;
  Motion motion = ends[pair.from].motion;
  if (!is_to_earth) motion = std::max(motion, ends[pair.to].motion);
  const bool is_of_others = motion == Motion::none;
  for (const SightEnd& other : ends) {
    if (other.motion == Motion::none) continue;
    if (is_near(pair, other, ends)) motion = std::max(motion, other.motion);
  }
  if (is_estimate_ && is_of_others && now < *pair.time + estimate_least) return false;
  if (motion == Motion::has_ended) return true;
  const SimTime period = is_estimate_ ? estimate_turn_period : moving_update_period;
  return motion == Motion::goes_on && now > *pair.time && now % period == SimTime{};
}

void SightWatch::evaluate(Pair& pair, SimTime now, Instant utc, const std::vector<SightEnd>& ends,
                          const SolidsBetween& solids) {
  const SightEnd& from = ends[pair.from];
  if (pair.to == earth_) {
    const SiteFrame& site = ground_->site();
    const Sighting earth =
        sighting(site.body(), site.p_F_m(from.antenna_S_m), CelestialBody::earth, utc);
    const Vec3 direction_S = site.R_FS().transpose() * earth.direction_F;
    const std::vector<NamedMesh> near = solids(from.antenna_S_m, from.antenna_S_m);
    const Sight::Disc seen =
        is_estimate_ ? sight_.marched_disc(from.antenna_S_m, direction_S, earth.disc_rad, near)
                     : sight_.disc(from.antenna_S_m, direction_S, earth.disc_rad, near);
    pair.is_visible = seen.is_centre_seen;
    pair.fraction = seen.fraction;
    pair.hidden_by = seen.hidden_by;
    pair.is_linked = pair.is_visible && from.has_link && from.reaches_earth;
    if (!pair.is_visible) return;
    earth_over_end_.add_towards(from.antenna_S_m, direction_S, earth.disc_rad, from.id, now);
    return;
  }
  const SightEnd& to = ends[pair.to];
  const Sight::Line seen =
      sight_.line(from.antenna_S_m, to.antenna_S_m, solids(from.antenna_S_m, to.antenna_S_m));
  pair.is_visible = seen.is_seen;
  pair.hidden_by = seen.hidden_by;
  if (pair.is_visible) {
    pairs_over_end_.add_between(from.antenna_S_m, to.antenna_S_m,
                                fmt::format("{} to {}", from.id, to.id), now);
  }
  const double away_m = (to.antenna_S_m - from.antenna_S_m).norm();
  pair.is_linked = pair.is_visible && from.has_link && to.has_link &&
                   away_m <= std::min(from.range_max_m, to.range_max_m);
}

double SightWatch::distance_m(const Pair& pair, Instant utc,
                              const std::vector<SightEnd>& ends) const {
  const SightEnd& from = ends[pair.from];
  if (pair.to != earth_) return (ends[pair.to].p_S_m - from.p_S_m).norm();
  const SiteFrame& site = ground_->site();
  return sighting(site.body(), site.p_F_m(from.p_S_m), CelestialBody::earth, utc).distance_m;
}

std::string SightWatch::id(std::size_t end, const std::vector<SightEnd>& ends) const {
  return end == earth_ ? earth_id : ends[end].id;
}

std::vector<SightIntervalRow> SightWatch::look(SimTime now, Instant utc,
                                               const std::vector<SightEnd>& ends,
                                               const SolidsBetween& solids) {
  std::vector<SightIntervalRow> ended;
  bool have_links_changed = false;
  for (Pair& pair : pairs_) {
    if ((is_estimate_ && pair.to != earth_) || !is_due(pair, now, ends)) continue;
    const bool was_linked = pair.is_linked, is_first = !pair.time;
    count_own_way(pair, now, ends);
    evaluate(pair, now, utc, ends, solids);
    pair.time = now;
    pair.is_near_turning = std::ranges::any_of(ends, [&](const SightEnd& other) {
      return other.turns_with_sun && is_near(pair, other, ends);
    });
    have_links_changed |= is_first || was_linked != pair.is_linked;
    if (!have_links_changed) follow(pair, now, utc, ends, ended);
  }
  if (!have_links_changed) return ended;
  for (Pair& pair : pairs_) {
    if (pair.time) follow(pair, now, utc, ends, ended);
  }
  return ended;
}

std::array<std::pair<const char*, std::optional<OpenInterval>*>, 4> SightWatch::intervals(
    Pair& pair) {
  return {{{"visible", &pair.visible},
           {"hidden", &pair.hidden},
           {"link", &pair.linked},
           {"relayed", &pair.relayed}}};
}

void SightWatch::follow(Pair& pair, SimTime now, Instant utc, const std::vector<SightEnd>& ends,
                        std::vector<SightIntervalRow>& ended) const {
  const std::string relays = pair.is_linked ? "" : relay(pair, ends);
  const std::array states{pair.is_visible, !pair.is_visible, pair.is_linked, !relays.empty()};
  const std::array<std::string, 4> by{"", pair.hidden_by, "", relays};
  const auto all = intervals(pair);
  for (std::size_t k = 0; k < all.size(); ++k) {
    auto& [kind, interval] = all[k];
    if (*interval && (!states[k] || (*interval)->by != by[k])) {
      ended.push_back(row(pair, kind, **interval, now, ends));
      interval->reset();
    }
    if (!states[k] || *interval) continue;
    *interval = OpenInterval{now, distance_m(pair, utc, ends) / speed_of_light_mps, by[k]};
  }
}

SightIntervalRow SightWatch::row(const Pair& pair, const char* kind, const OpenInterval& interval,
                                 SimTime end, const std::vector<SightEnd>& ends) const {
  return {id(pair.from, ends),   id(pair.to, ends), kind, interval.start, end,
          interval.light_time_s, interval.by};
}

std::vector<SightIntervalRow> SightWatch::finish(SimTime now, const std::vector<SightEnd>& ends) {
  std::vector<SightIntervalRow> ended;
  for (Pair& pair : pairs_) {
    for (const auto& [kind, interval] : intervals(pair)) {
      if (!*interval) continue;
      ended.push_back(row(pair, kind, **interval, now, ends));
      interval->reset();
    }
  }
  return ended;
}

void SightWatch::count_own_way(Pair& pair, SimTime now, const std::vector<SightEnd>& ends) const {
  if (pair.to != earth_ || !pair.time || pair.is_visible) return;
  const SightEnd& from = ends[pair.from];
  if (pair.hidden_by == from.id && from.has_link && from.reaches_earth) {
    pair.in_own_way += now - *pair.time;
  }
}

std::vector<std::string> SightWatch::warnings_of_own_way(const std::vector<SightEnd>& ends) const {
  constexpr SimTime worth_telling{3600 * 1'000'000LL};
  std::vector<std::string> warnings;
  for (const Pair& pair : pairs_) {
    if (pair.in_own_way < worth_telling) continue;
    warnings.push_back(
        fmt::format("{}: its own body or panels hid Earth from its antenna for {:.1f} h in all; "
                    "sight_intervals says when",
                    id(pair.from, ends), seconds(pair.in_own_way) / 3600));
  }
  return warnings;
}

void SightWatch::ask(std::size_t one, std::size_t other, SimTime now, Instant utc,
                     const std::vector<SightEnd>& ends, const SolidsBetween& solids) {
  constexpr SimTime holds{60'000'000};
  for (Pair& pair : pairs_) {
    if (std::minmax(pair.from, pair.to) != std::minmax(one, other)) continue;
    if (pair.to == earth_ || (pair.time && now < *pair.time + holds)) return;
    evaluate(pair, now, utc, ends, solids);
    pair.time = now;
  }
}

std::optional<PairSight> SightWatch::last(std::size_t one, std::size_t other) const {
  for (const Pair& pair : pairs_) {
    const bool is_it = std::minmax(pair.from, pair.to) == std::minmax(one, other);
    if (is_it && pair.time) return PairSight{pair.is_visible, pair.is_linked, pair.fraction};
  }
  return {};
}

std::vector<PairRow> SightWatch::rows(SimTime now, Instant utc, const std::vector<SightEnd>& ends,
                                      std::size_t from) const {
  std::vector<PairRow> rows;
  for (const Pair& pair : pairs_) {
    if (pair.from != from || !pair.time) continue;
    PairRow row;
    row.time = now;
    row.from_id = id(pair.from, ends);
    row.to_id = id(pair.to, ends);
    row.distance_m = distance_m(pair, utc, ends);
    row.visible = pair.is_visible ? 1 : 0;
    row.visible_fraction = pair.fraction;
    row.link = pair.is_linked ? 1 : 0;
    if (!pair.is_linked) row.relay = relay(pair, ends);
    rows.push_back(row);
  }
  return rows;
}

// Route over the fewest links; of several, the first in the order of ends. The search is breadth
// first from the destination, so that each end knows its next hop.
std::string SightWatch::relay(const Pair& pair, const std::vector<SightEnd>& ends) const {
  std::vector<std::optional<std::size_t>> next(earth_ + 1);
  next[pair.to] = pair.to;
  std::vector<std::size_t> reached{pair.to};
  for (std::size_t i = 0; i < reached.size() && !next[pair.from]; ++i) {
    std::vector<std::size_t> found;
    for (const Pair& link : pairs_) {
      if (!link.is_linked || (link.from != reached[i] && link.to != reached[i])) continue;
      const std::size_t other = link.from == reached[i] ? link.to : link.from;
      // Earth is a destination, not a relay.
      if (next[other] || other == earth_) continue;
      next[other] = reached[i];
      found.push_back(other);
    }
    std::ranges::sort(found);
    reached.insert(reached.end(), found.begin(), found.end());
  }
  if (!next[pair.from]) return "";
  std::string ids;
  for (std::size_t at = *next[pair.from]; at != pair.to; at = *next[at]) {
    ids += (ids.empty() ? "" : ",") + id(at, ends);
  }
  return ids;
}

std::optional<SimTime> SightWatch::wake() const {
  std::optional<SimTime> wake;
  for (const Pair& pair : pairs_) {
    if ((pair.to != earth_ && !pair.is_near_turning) || !pair.time) continue;
    const SimTime due = round_up_to_exchange(*pair.time + interval(pair));
    wake = std::min(wake.value_or(due), due);
  }
  return wake;
}

}  // namespace lsos
