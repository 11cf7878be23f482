#include "lua/edit/verb_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "edit/editable_file.h"
#include "edit/plan_notes.h"
#include "lua/edit/verbs.h"

namespace lsos {

namespace {

struct Verb {
  const char* name;
  const char* what;
  const char* example;                    // what follows the plan
  std::vector<const char*> options;       // that it may be given
  std::vector<const char*> required;      // of these, or "" for arguments
  const char* arguments;                  // what stands behind it; nullptr: nothing
  std::string (*edit)(Editing& editing);  // returns what it did
};

const std::vector<Verb>& verbs() {
  static const std::vector<Verb> table{
      {"renumber",
       "sequences 10, 20, ... in order; references follow",
       "renumber --step 10",
       {"--step", "--rover"},
       {},
       nullptr,
       edit_renumber},
      {"shift",
       "all times of the plan, or from an event on, or of a rover",
       "shift --by '+1 d'",
       {"--by", "--from", "--rover"},
       {"--by"},
       nullptr,
       edit_shift},
      {"enable",
       "events that were left out take part again",
       "enable --label 'EVA 2'",
       {"--rover", "--label", "--day", "--type"},
       {},
       "ROVER/SEQUENCE or ROVER/FIRST..LAST",
       edit_enable},
      {"disable",
       "events are left out",
       "disable SEV1/20..40 SEV2/30",
       {"--rover", "--label", "--day", "--type"},
       {},
       "ROVER/SEQUENCE or ROVER/FIRST..LAST",
       edit_disable},
      {"merge",
       "rovers, assets and events of other plans of the mission are taken up",
       "merge OTHER.kml",
       {},
       {},
       "OTHER.kml",
       edit_merge},
      {"repeat",
       "a day's events again on the following days, also at other places",
       "repeat --day 1 --times 4 --places STOPS.kml",
       {"--day", "--times", "--places", "--rover"},
       {"--day", "--times"},
       nullptr,
       edit_repeat},
      {"split",
       "some days as a plan of their own, begun as the days before are estimated to end",
       "split --day 3..5 --charge SEV1=0.8",
       {"--day", "--charge"},
       {"--day"},
       nullptr,
       edit_split},
      {"mirror",
       "a rover's events for another rover too",
       "mirror --from SEV1 --to SEV2 --offset 20,0",
       {"--from", "--to", "--offset"},
       {"--from", "--to"},
       nullptr,
       edit_mirror},
  };
  return table;
}

// The options that were given.
std::vector<std::string> given(const EditOptions& options) {
  std::vector<std::string> names;
  const auto add = [&](const char* name, bool is_given) {
    if (is_given) names.emplace_back(name);
  };
  add("--step", options.step.has_value());
  add("--times", options.times.has_value());
  add("--rover", !options.rover.empty());
  add("--label", !options.label.empty());
  add("--type", !options.type.empty());
  add("--day", !options.day.empty());
  add("--by", !options.by.empty());
  add("--from", !options.from.empty());
  add("--to", !options.to.empty());
  add("--offset", !options.offset.empty());
  add("--places", !options.places.empty());
  add("--charge", !options.charges.empty());
  return names;
}

const Verb& verb_of(const EditOptions& options) {
  const auto found =
      std::ranges::find_if(verbs(), [&](const Verb& verb) { return options.verb == verb.name; });
  if (found != verbs().end()) return *found;
  std::vector<std::string> known;
  for (const Verb& verb : verbs()) known.emplace_back(verb.name);
  throw InputError({}, fmt::format("edit: there is no verb '{}'{}; there are {}", options.verb,
                                   did_you_mean(options.verb, known), fmt::join(known, ", ")));
}

}  // namespace

std::string verb_examples() {
  std::string examples = "Verbs, each with an example:\n";
  for (const Verb& verb : verbs()) {
    examples += fmt::format("  {:<9} {}\n            lsos-host edit PLAN.kml {} -o NEW.kml\n",
                            verb.name, verb.what, verb.example);
  }
  return examples;
}

void check_verb(const EditOptions& options) {
  const Verb& verb = verb_of(options);
  const std::vector<std::string> names = given(options);
  Faults faults;
  for (const std::string& name : names) {
    if (std::ranges::count(verb.options, name) > 0) continue;
    const std::string allowed = verb.options.empty()
                                    ? "it takes none but -o and --force"
                                    : fmt::format("it takes {}", fmt::join(verb.options, ", "));
    faults.error({}, fmt::format("edit {}: {} is not for it; {}", verb.name, name, allowed));
  }
  for (const char* name : verb.required) {
    if (std::ranges::count(names, name) > 0) continue;
    faults.error({},
                 fmt::format("edit {}: {} is wanted, as in '{}'", verb.name, name, verb.example));
  }
  if (verb.arguments == nullptr && !options.arguments.empty()) {
    faults.error({}, fmt::format("edit {}: '{}' is not for it; it is used as in '{}'", verb.name,
                                 options.arguments.front(), verb.example));
  }
  faults.throw_if_errors();
}

EditOutcome edited(const EditOptions& options, const MissionFiles& files) {
  const EditableFile file(files.plan_bytes, files.plan.file);
  const char* ending = file.is_kmz() ? ".kmz" : ".kml";
  if (!options.output.ends_with(ending)) {
    throw InputError({}, fmt::format("-o {}: the name must end in {}, as the plan is that",
                                     options.output, ending));
  }
  Editing editing{options, files, {file.kml(), files.plan, files.catalog->declarations()}, {}};
  // It would be that of another plan.
  if (erase_notes(editing.document)) {
    editing.warnings.push_back(
        fmt::format("the estimate in {} is left out, as the new plan has another; 'check --kml' "
                    "puts it in",
                    files.plan.file));
  }
  std::string what = verb_of(options).edit(editing);
  editing.document.follow_rasters(options.output);
  return {file.with(editing.document.text()), std::move(what), std::move(editing.warnings),
          std::move(editing.copies)};
}

}  // namespace lsos
