#include "lua/edit/new_plan.h"

#include <fmt/format.h>

#include <set>

#include "base/console.h"
#include "edit/event_names.h"
#include "lua/host/mission_reader.h"

namespace lsos {

namespace {

// Faults of copies told at what was copied.
Faults at_copied(const MissionFiles& edited, const CopyPlaces& copies) {
  Faults told;
  for (Fault fault : edited.faults.sorted()) {
    const PlanEvent* its = nullptr;
    for (const PlanEvent& event : edited.plan.events) {
      const bool is_before = event.place.line <= fault.place.line;
      if (is_before && (its == nullptr || event.place.line > its->place.line)) its = &event;
    }
    const bool is_its =
        its != nullptr && fault.what.find("'" + its->label + "'") != std::string::npos;
    const auto copied = is_its ? copies.find(reference_to(*its)) : copies.end();
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
