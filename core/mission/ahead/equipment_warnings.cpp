#include "mission/ahead/equipment_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "mission/ahead/expected_time.h"
#include "plan/field_reader.h"
#include "plan/suggestions.h"
#include "planet/sunlight.h"

namespace lsos {

namespace {

// Elevation below which the Sun is surely not visible: its radius, and the difference in its
// elevation across a site some 40 km wide on the Moon.
constexpr double surely_below_rad = -1.5 * std::numbers::pi / 180;

enum class Position { up, down, unknown };

struct Equipment {
  bool is_panel = false, is_stowable = false, turns = false;
  Position position = Position::unknown;
  std::string since;  // what brought it there
};

// As the rover has it at the start.
std::map<std::string, Equipment> equipment_of(const RoverAgent& rover) {
  std::map<std::string, Equipment> all;
  const auto position = [](bool is_up) { return is_up ? Position::up : Position::down; };
  const PanelArray& panels = rover.power().panels();
  for (std::size_t i = 0; i < panels.specs().size(); ++i) {
    const PanelSpec& panel = panels.specs()[i];
    all[panel.name] = {true, panel.is_stowable, panel.can_turn(), position(!panels.is_stowed(i)),
                       "from the start"};
  }
  const AntennaArray& antennas = rover.antennas();
  for (std::size_t i = 0; i < antennas.specs().size(); ++i) {
    const AntennaSpec& antenna = antennas.specs()[i];
    all[antenna.name] = {false, antenna.is_stowable(), false, position(antennas.is_up(i, {})),
                         "from the start"};
  }
  return all;
}

class EquipmentPass {
 public:
  EquipmentPass(const RoverMachine& machine, const MissionInfo& mission, const RoverAgent& rover,
                ScriptHost& host, const SiteFrame& site)
      : mission_(mission),
        host_(host),
        site_(site),
        vehicle_(rover.motion().config()),
        at_(machine.rover.start),
        equipment_(equipment_of(rover)) {}

  void pass(const EventMachine& machine) {
    const PlanEvent& event = machine.event;
    const EventDeclaration& declaration = machine.declaration;
    begin(event);
    try {
      look(machine);
      end(machine);
    } catch (const ScriptError& error) {
      faults_.push_back({Severity::error, event.place,
                         fmt::format("{} '{}': {}", event.type, event.label, error.what())});
    }
    const bool is_certain = event.skip_when.text.empty();
    const std::string since = fmt::format("by '{}'", event.label);
    move(machine, declaration.deploys, Position::up, is_certain, since);
    move(machine, declaration.stows, Position::down, is_certain, since);
    if (declaration.may_deploy_unsaid && !says_what_it_does(declaration)) forget_positions();
    for (const EventDeclaration::Phase& phase : declaration.phases) {
      if (!phase.sub_event.empty() && may_deploy(phase.sub_event)) forget_positions();
    }
  }

  std::vector<Fault> take() { return std::move(faults_); }

 private:
  EventArguments arguments(const PlanEvent& event) const { return {event.params, {}}; }

  static bool says_what_it_does(const EventDeclaration& d) {
    return !d.deploys.empty() || !d.stows.empty() || !d.needs_deployed.empty();
  }

  bool may_deploy(const std::string& type) const {
    const auto found = host_.declarations().events.find(type);
    return found == host_.declarations().events.end() || found->second.may_deploy_unsaid;
  }

  void begin(const PlanEvent& event) {
    if (!event.start_after.empty() || !event.start_when.text.empty()) now_.reset();
    if (!event.start_time) return;
    const SimTime start = *event.start_time - mission_.start_time;
    now_ = now_ ? std::max(*now_, start) : start;
  }

  void end(const EventMachine& machine) {
    const PlanEvent& event = machine.event;
    const bool is_anywhere = machine.declaration.drives &&
                             event.geometry.kind != GeometryKind::point &&
                             event.geometry.kind != GeometryKind::line;
    const bool is_known = event.skip_when.text.empty() && event.stop_when.text.empty() &&
                          !is_anywhere &&
                          !host_.is_open_ended(event.type, arguments(event), mission_.start_time);
    if (is_known && now_) {
      now_ = expected_end(machine, vehicle_, *now_, mission_.start_time, site_.body(), at_);
      return;
    }
    now_ = until(machine);
    if (!event.geometry.points.empty()) at_ = event.geometry.points.back();
  }

  // End time that one of its fields gives, whenever it begins; absent: none does.
  std::optional<SimTime> until(const EventMachine& machine) const {
    for (const FieldDeclaration& field : machine.declaration.fields) {
      if (field.kind != FieldKind::utc) continue;
      const auto* until = find_value<Instant>(machine.event.params, field.key);
      if (until != nullptr) return *until - mission_.start_time;
    }
    return {};
  }

  // Visits the equipment that the field `key` of an event names; a field left out names all that
  // can be stowed.
  template <class Visit>
  void for_each_named(const EventMachine& machine, const std::string& key, const Visit& visit) {
    if (key.empty()) return;
    const auto& fields = machine.declaration.fields;
    const auto field = std::ranges::find(fields, key, &FieldDeclaration::key);
    const auto* name = find_value<std::string>(machine.event.params, key);
    const bool is_panel = field != fields.end() && field->names != NameOf::antenna;
    for (auto& [own_name, equipment] : equipment_) {
      const bool is_named = name == nullptr ? equipment.is_stowable : *name == own_name;
      if (is_named && equipment.is_panel == is_panel) visit(own_name, equipment);
    }
  }

  void look(const EventMachine& machine) {
    look_for_vain_moves(machine, machine.declaration.deploys, Position::up, "up");
    look_for_vain_moves(machine, machine.declaration.stows, Position::down, "stowed");
    look_for_needed(machine);
    const PlanEvent& event = machine.event;
    if (!host_.awaits_sunlight(event.type, arguments(event), mission_.start_time)) return;
    look_for_panels(machine);
    look_for_sun(machine);
  }

  void look_for_vain_moves(const EventMachine& machine, const std::string& key, Position position,
                           const char* word) {
    std::vector<std::string> names, since;
    bool all_are = true;
    for_each_named(machine, key, [&](const std::string& name, const Equipment& equipment) {
      all_are = all_are && equipment.position == position;
      names.push_back(quoted(name));
      since.push_back(equipment.since);
    });
    if (names.empty() || !all_are) return;
    warn(machine.event, fmt::format("{} {} {} already {}: nothing is done", fmt::join(names, ", "),
                                    names.size() == 1 ? "is" : "are", word, since.front()));
  }

  void look_for_needed(const EventMachine& machine) {
    const std::string& key = machine.declaration.needs_deployed;
    std::vector<std::string> names, since;
    bool is_any_left = false;
    for_each_named(machine, key, [&](const std::string& name, const Equipment& equipment) {
      is_any_left = is_any_left || equipment.position != Position::down;
      names.push_back(quoted(name));
      since.push_back(equipment.since);
    });
    if (names.empty() || is_any_left) return;
    // A field left out also names panels that turn and cannot be stowed.
    const bool is_named = find_value<std::string>(machine.event.params, key) != nullptr;
    const auto turns_always = [](const auto& entry) {
      return entry.second.turns && !entry.second.is_stowable;
    };
    if (!is_named && std::ranges::any_of(equipment_, turns_always)) return;
    warn(machine.event,
         fmt::format("{} {} stowed {}, and must be deployed first", fmt::join(names, ", "),
                     names.size() == 1 ? "is" : "are", since.front()));
  }

  void look_for_panels(const EventMachine& machine) {
    const Equipment* stowed = nullptr;
    for (const auto& [name, equipment] : equipment_) {
      if (!equipment.is_panel) continue;
      if (equipment.position != Position::down) return;
      stowed = &equipment;
    }
    if (stowed == nullptr) return;  // no panels: the event's own check reports that
    warn(machine.event,
         fmt::format("it waits for the Sun, and no panel is up: stowed {}", stowed->since));
  }

  void look_for_sun(const EventMachine& machine) {
    if (!now_) return;
    constexpr int looks = 8;
    Geodetic place = at_;
    const SimTime end =
        expected_end(machine, vehicle_, *now_, mission_.start_time, site_.body(), place);
    const SimTime wait = end > *now_ ? end - *now_ : from_seconds(86400);
    double highest_rad = -std::numbers::pi;
    for (int k = 0; k <= looks; ++k) {
      const Instant at = mission_.start_time + *now_ + wait * k / looks;
      highest_rad = std::max(highest_rad, sunlight(site_.body(), at_, at, 0).seen.elevation_rad);
    }
    if (highest_rad >= surely_below_rad) return;
    warn(machine.event,
         fmt::format("it waits for the Sun, which from about {} on stands {:.3g} deg below the "
                     "horizon or lower{}",
                     format_utc(mission_.start_time + *now_), -highest_rad * 180 / std::numbers::pi,
                     end > *now_ ? "" : " for a day"));
  }

  void move(const EventMachine& machine, const std::string& key, Position position, bool is_certain,
            const std::string& since) {
    for_each_named(machine, key, [&](const std::string&, Equipment& equipment) {
      equipment.position = is_certain ? position : Position::unknown;
      equipment.since = since;
    });
  }

  void forget_positions() {
    for (auto& [name, equipment] : equipment_) {
      if (equipment.is_stowable) equipment.position = Position::unknown;
    }
  }

  void warn(const PlanEvent& event, const std::string& what) {
    faults_.push_back({Severity::warning, event.place,
                       fmt::format("{} '{}': {}", event.type, event.label, what)});
  }

  const MissionInfo& mission_;
  ScriptHost& host_;
  const SiteFrame& site_;
  const VehicleConfig& vehicle_;
  std::optional<SimTime> now_ = SimTime{};  // when the next event begins; absent: not known
  Geodetic at_;
  std::map<std::string, Equipment> equipment_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> equipment_warnings(const RoverMachine& machine, const MissionInfo& mission,
                                      const RoverAgent& rover, ScriptHost& host,
                                      const SiteFrame& site) {
  EquipmentPass ahead(machine, mission, rover, host, site);
  for (const EventMachine& event : machine.events) {
    if (event.event.is_enabled && !event.event.at) ahead.pass(event);
  }
  return ahead.take();
}

}  // namespace lsos
