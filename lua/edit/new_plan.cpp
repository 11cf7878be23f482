#include "lua/edit/new_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/console.h"
#include "edit/event_names.h"
#include "lua/host/mission_reader.h"

namespace lsos {

namespace {

// The copy that a fault speaks of, by the line where its Placemark begins and its label; the end
// for none. On one line may stand many events: a copy is at fault, as what was copied was without.
CopyPlaces::const_iterator copy_of(const Fault& fault, const Plan& plan, const CopyPlaces& copies) {
  int line = 0;
  for (const PlanEvent& event : plan.events) {
    if (event.place.line <= fault.place.line) line = std::max(line, event.place.line);
  }
  for (const PlanEvent& event : plan.events) {
    const auto copy = copies.find(reference_to(event));
    const bool is_its = event.place.line == line && copy != copies.end() &&
                        fault.what.find("'" + event.label + "'") != std::string::npos;
    if (is_its) return copy;
  }
  return copies.end();
}

// Faults of copies told at what was copied.
Faults at_copied(const MissionFiles& edited, const CopyPlaces& copies) {
  Faults told;
  for (Fault fault : edited.faults.sorted()) {
    const auto copied = copy_of(fault, edited.plan, copies);
    if (copied != copies.end()) {
      fault.place = copied->second;
      fault.what = fmt::format("its copy {}: {}", reference_text(copied->first), fault.what);
    }
    told.add({fault});
  }
  return told;
}

}  // namespace

MissionFiles read_new_plan(const std::string& bytes, const std::string& file,
                           const CopyPlaces& copies) {
  const PlanSource source{file, parse_kml(bytes, file), "", bytes, true};
  MissionFiles edited = read_mission(source, read_catalog(source));
  if (edited.faults.has_errors()) {
    print_message(
        "{}: is not written, as the edited plan would have faults (lines are its own{}):\n", file,
        copies.empty() ? "" : ", but of copies those of what was copied");
    at_copied(edited, copies).throw_if_errors();
  }
  return edited;
}

std::vector<Fault> placing_faults(const MissionFiles& files) {
  if (files.faults.has_errors()) return {};
  SimulationSetup setup = simulation_setup(files);
  setup.plan.events.clear();
  try {
    const Simulation placed(std::move(setup));
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

void tell_new_warnings(const Faults& old_faults, const Faults& new_faults) {
  constexpr int most = 10;
  std::set<std::string> known;
  for (const Fault& fault : old_faults.sorted()) known.insert(fault.what);
  int count = 0;
  for (const Fault& fault : new_faults.sorted()) {
    if (known.contains(fault.what) || ++count > most) continue;
    print_message("{}\n", to_string(fault));
  }
  if (count > most) print_message("{} more warnings; 'check' tells them\n", count - most);
}

}  // namespace lsos
