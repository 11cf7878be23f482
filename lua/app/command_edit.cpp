// `lsos-host edit`: changes of a plan that would take an hour by hand; the rest of the document
// stays as it was.
#include <fmt/format.h>

#include "base/console.h"
#include "base/files.h"
#include "base/output_file.h"
#include "lua/app/commands.h"
#include "lua/edit/new_plan.h"
#include "lua/edit/verb_table.h"
#include "lua/host/mission_reader.h"

namespace lsos {

namespace {

void check_new_file(const EditOptions& options) {
  Faults faults;
  check_output("-o", options.output, {".kml", ".kmz"}, {}, faults);
  if (!options.is_forced) check_free("-o", options.output, "--force replaces it", faults);
  faults.throw_if_errors();
}

int edit_command(const EditOptions& options) {
  check_verb(options);
  check_new_file(options);
  const MissionFiles files = read_mission(options.plan);
  files.faults.throw_if_errors();
  const EditOutcome outcome = edited(options, files);
  const MissionFiles new_files = read_new_plan(outcome.bytes, options.output, outcome.copies);
  write_file(options.output, outcome.bytes);
  tell_new_warnings(files.faults, new_files.faults);
  for (const std::string& warning : outcome.warnings) print_message("warning: {}\n", warning);
  print_result("{}; wrote {}\n", outcome.what, options.output);
  return 0;
}

void add_options(CommandOptions& command, EditOptions& options) {
  command.add_option("PLAN", options.plan, "A plan: KML or KMZ").required();
  command.add_option("VERB", options.verb, "What to do, see below").required();
  command.add_option("ARGUMENT", options.arguments, "Events, or other plans");
  command.add_option("-o,--output", options.output, "The new plan, .kml or, of a KMZ, .kmz")
      .required();
  command.add_flag("--force", options.is_forced, "Replace the file if it is there");
  command.add_option("--rover", options.rover, "Events of this rover");
  command.add_option("--label", options.label, "Events with this label");
  command.add_option("--type", options.type, "Events of this type");
  command.add_option(
      "--day", options.day,
      "Events of a day, or of FIRST..LAST, counted from the mission's start, from 1");
  command.add_option("--step", options.step, "renumber: between two sequences (10)");
  command.add_option("--by", options.by, "shift: by how much, such as '+1 d' or --by='-90 min'");
  command.add_option(
      "--from", options.from,
      "shift: this event (label, or ROVER/SEQUENCE) and the later ones of its rover; "
      "mirror: the rover that has the events");
  command.add_option("--to", options.to, "mirror: the rover that gets them");
  command.add_option("--offset", options.offset,
                     "mirror: how far its places are moved, EAST,NORTH in m");
  command.add_option("--times", options.times, "repeat: how often");
  command.add_option("--places", options.places,
                     "repeat: a KML whose Points are gone to in their order, each once");
  command
      .add_option("--charge", options.charges,
                  "split: charge of a rover at the beginning, ROVER=0.8; else as estimated")
      .repeated();
  command.set_footer(verb_examples());
}

}  // namespace

std::function<int()> prepare_edit(CommandOptions& command) {
  const auto options = std::make_shared<EditOptions>();
  add_options(command, *options);
  return [options] { return edit_command(*options); };
}

}  // namespace lsos
