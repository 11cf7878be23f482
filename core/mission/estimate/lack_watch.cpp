#include "mission/estimate/lack_watch.h"

#include <algorithm>

#include "mission/light/sight_watch.h"

namespace lsos {

namespace {

// Contact with others than Earth is looked for so often while there is none, s.
constexpr double contact_period_s = 600;
// An antenna that is up for less is hardly there to be talked through, s.
constexpr double contact_least_s = 600;
// Two stretches of the same condition so near to each other are one, s.
constexpr double same_lack_s = 60;

// Whether an event has just failed for an empty battery, which its own reason tells.
bool has_failed_empty(const EventRecord& record, double now_s) {
  return record.status == EventStatus::failed && record.end && seconds(*record.end) == now_s &&
         record.reason.find("battery is empty") != std::string::npos;
}

// Label of the first enabled event from `index` on whose turn has not come; "" when there is none.
std::string next_label(const EventSequence& sequence, std::size_t index) {
  for (std::size_t i = index; i < sequence.events().size(); ++i) {
    const EventRecord& record = sequence.records().all()[i];
    const bool is_to_come = !record.start && !record.end && !record.is_timed;
    if (is_to_come) return sequence.events()[i].event.label;
  }
  return "";
}

// The first stowable antenna that is up; absent: none is.
std::optional<std::size_t> raised_antenna(const RoverAgent& rover, double now_s) {
  const AntennaArray& antennas = rover.antennas();
  for (std::size_t i = 0; i < antennas.specs().size(); ++i) {
    if (antennas.specs()[i].is_stowable() && antennas.is_up(i, from_seconds(now_s))) return i;
  }
  return {};
}

// Whether it is linked to a rover or asset; absent: there is none.
std::optional<bool> is_linked_to_any(const Fleet& fleet, const RoverAgent& rover) {
  std::vector<std::string> others = fleet.rover_ids();
  std::erase(others, rover.id());
  for (const StandingAsset& asset : fleet.assets) others.push_back(asset.plan.id);
  if (others.empty()) return {};
  return std::ranges::any_of(others, [&](const std::string& id) {
    const std::optional<PairSight> sight = rover.sight_of(id);
    return sight && sight->is_linked;
  });
}

}  // namespace

void LackWatch::look(const Fleet& fleet, std::size_t index, std::optional<std::size_t> running,
                     const RoverSees& sees, double now_s) {
  const FleetRover& rover = fleet.rovers[index];
  // An antenna comes up as the event that raises it ends: that is the last that has begun so far.
  look_for_contact(fleet, rover, sees.is_earth, now_s);
  if (running) event_ = *running;
  look_for_sun(rover, sees.is_dark, now_s);
  look_for_energy(rover, !running, now_s);
  look_for_warnings(rover, now_s);
}

Lack LackWatch::begun(LackKind kind, const FleetRover& rover, double now_s) const {
  Lack lack;
  lack.kind = kind;
  lack.rover_id = rover.agent->id();
  const std::vector<EventMachine>& events = rover.sequence.events();
  if (event_ < events.size()) lack.sequence = events[event_].event.sequence;
  lack.begin_s = lack.end_s = now_s;
  return lack;
}

void LackWatch::look_for_sun(const FleetRover& rover, bool is_dark, double now_s) {
  const RoverPower& power = rover.agent->power();
  if (!power.has_battery()) return;
  const double charge = power.view().charge;
  const bool is_stowed = !power.panels().is_any_up();
  if (is_dark && !dark_) {
    dark_ = begun(LackKind::sunlight, rover, now_s);
    dark_->charge_begin = dark_->charge_min = charge;
    dark_->reserve = power.reserve();
    dark_->is_stowed = is_stowed;
  }
  if (!dark_) return;
  dark_->charge_min = std::min(dark_->charge_min, charge);
  dark_->is_stowed = dark_->is_stowed && (is_stowed || !is_dark);
  if (charge < dark_->reserve && !dark_->below_s) {
    dark_->below_s = now_s;
    dark_->below_sequence = begun(LackKind::sunlight, rover, now_s).sequence;
  }
  if (is_dark) return;
  if (matters(*dark_)) add(ended_, *dark_, now_s);
  dark_.reset();
}

void LackWatch::look_for_energy(const FleetRover& rover, bool is_idle, double now_s) {
  const bool is_empty = rover.agent->power().waits_for_reserve();
  if (is_empty == empty_.has_value()) return;
  if (!is_empty) {
    if (!empty_->is_told) add(ended_, *empty_, now_s);
    empty_.reset();
    return;
  }
  empty_ = begun(LackKind::energy, rover, now_s);
  empty_->reserve = rover.agent->power().reserve();
  empty_->is_idle = is_idle;
  const EventRecords& records = rover.sequence.records();
  empty_->is_told = std::ranges::any_of(
      records.all(), [&](const EventRecord& record) { return has_failed_empty(record, now_s); });
  empty_->next = next_label(rover.sequence, event_);
}

void LackWatch::look_for_contact(const Fleet& fleet, const FleetRover& rover, bool sees_earth,
                                 double now_s) {
  const RoverAgent& agent = *rover.agent;
  const std::optional<std::size_t> raised = raised_antenna(agent, now_s);
  if (!raised) {
    if (contact_ && is_missed(*contact_, now_s)) add(ended_, contact_->lack, now_s);
    contact_.reset();
    return;
  }
  const AntennaSpec& antenna = agent.antennas().specs()[*raised];
  const bool is_first = !contact_;
  if (is_first) {
    contact_ = Contact{begun(LackKind::contact, rover, now_s), false, now_s};
    contact_->lack.what = antenna.name;
  }
  if (contact_->is_made) return;
  if (sees_earth && antenna.reaches_earth) contact_->is_made = true;
  if (contact_->is_made || (!is_first && now_s - contact_->asked_s < contact_period_s)) return;
  contact_->asked_s = now_s;
  const std::optional<bool> is_linked = is_linked_to_any(fleet, agent);
  // Nobody is there to be reached where Earth is not in the sky.
  const bool is_alone = !is_linked && !agent.sight_of(earth_id);
  contact_->is_made = is_alone || is_linked.value_or(false);
}

void LackWatch::look_for_warnings(const FleetRover& rover, double now_s) {
  const bool holds = rover.sequence.does_warn();
  const std::string text =
      holds ? rover.sequence.events()[event_].event.warn_when.text : std::string();
  if (warned_ && (!holds || warned_->what != text)) {
    add(ended_, *warned_, now_s);
    warned_.reset();
  }
  if (!holds || warned_) return;
  warned_ = begun(LackKind::condition, rover, now_s);
  warned_->what = text;
}

bool LackWatch::matters(const Lack& dark) {
  const bool falls_below =
      dark.below_s && dark.charge_begin >= dark.reserve && *dark.below_s > dark.begin_s;
  return falls_below || dark.charge_begin - dark.charge_min >= dark_loss_told;
}

bool LackWatch::is_missed(const Contact& contact, double now_s) {
  return !contact.is_made && now_s - contact.lack.begin_s >= contact_least_s;
}

void LackWatch::add(std::vector<Lack>& lacks, Lack lack, double end_s) {
  lack.end_s = end_s;
  if (lack.kind == LackKind::condition) {
    const auto same = std::ranges::find_if(lacks, [&](const Lack& other) {
      return other.kind == lack.kind && other.what == lack.what &&
             lack.begin_s - other.end_s <= same_lack_s;
    });
    if (same != lacks.end()) {
      same->end_s = end_s;
      return;
    }
  }
  lacks.push_back(std::move(lack));
}

std::vector<Lack> LackWatch::lacks(double now_s) const {
  std::vector<Lack> lacks = ended_;
  if (dark_ && matters(*dark_)) add(lacks, *dark_, now_s);
  if (contact_ && is_missed(*contact_, now_s)) add(lacks, contact_->lack, now_s);
  if (empty_ && !empty_->is_told) add(lacks, *empty_, now_s);
  if (warned_) add(lacks, *warned_, now_s);
  return lacks;
}

}  // namespace lsos
