#include "lua/edit/verbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/quantity.h"
#include "base/text.h"
#include "base/units.h"
#include "edit/editable_file.h"
#include "edit/enable.h"
#include "edit/event_names.h"
#include "edit/merge.h"
#include "edit/mirror.h"
#include "edit/plan_notes.h"
#include "edit/renumber.h"
#include "edit/repeat.h"
#include "edit/shift.h"
#include "edit/split.h"
#include "lua/edit/day_begins.h"
#include "lua/edit/kept_ground.h"
#include "lua/host/mission_reader.h"
#include "mission/ahead/expected_begins.h"
#include "plan/suggestions.h"
#include "product/rover_days.h"

namespace lsos {

namespace {

std::map<PlanEvent::Reference, SimTime> begins_of(const MissionFiles& files) {
  return expected_begins(synthesise(files.plan, files.catalog->declarations()), files.rover_models);
}

EventDays days_by(const std::map<PlanEvent::Reference, SimTime>& begins) {
  EventDays days;
  for (const auto& [event, begin] : begins) days[event] = 1 + static_cast<int>(begin / day_length);
  return days;
}

EventDays days_of(const MissionFiles& files) { return days_by(begins_of(files)); }

// Days as if all events took part, so that `enable --day` means those that `disable --day` did.
EventDays days_of_all(const MissionFiles& files) {
  Plan plan = files.plan;
  for (PlanEvent& event : plan.events) event.is_enabled = true;
  return days_by(
      expected_begins(synthesise(plan, files.catalog->declarations()), files.rover_models));
}

// "2" or "2..4".
void read_days(const std::string& text, EventChoice& choice) {
  if (text.empty()) return;
  const std::size_t dots = text.find("..");
  const Parsed<std::int64_t> first = parse_integer(text.substr(0, dots));
  const Parsed<std::int64_t> last =
      dots == std::string::npos ? first : parse_integer(text.substr(dots + 2));
  constexpr std::int64_t most = 1'000'000;
  if (!first || !last || *first.value < 1 || *last.value < *first.value || *last.value > most) {
    throw InputError({}, fmt::format("--day {}: a day or FIRST..LAST is wanted, counted from the "
                                     "mission's start, from 1",
                                     text));
  }
  choice.first_day = static_cast<int>(*first.value);
  choice.last_day = static_cast<int>(*last.value);
}

EventChoice choice_of(const EditOptions& options) {
  EventChoice choice{options.arguments, options.rover, options.label, options.type};
  read_days(options.day, choice);
  return choice;
}

SimTime read_span(const std::string& text) {
  const bool is_back = text.starts_with('-');
  const std::string unsigned_text = text.substr(is_back || text.starts_with('+') ? 1 : 0);
  if (parse_quantity(unsigned_text, *find_unit("1"))) {
    throw InputError(
        {}, fmt::format("--by {}: its unit is wanted, as in '{} d', '{} h' or '{} min'", text, text,
                        text, text));
  }
  const Parsed<double> span_s = parse_quantity(unsigned_text, *find_unit("s"));
  if (!span_s || !(*span_s.value > 0)) {
    throw InputError({}, fmt::format("--by {}: a span is wanted, such as '+1 d', '-90 min' or "
                                     "'PT12H'{}",
                                     text, span_s ? "; this one moves nothing" : ""));
  }
  return from_seconds(is_back ? -*span_s.value : *span_s.value);
}

bool says_time(const PlanEvent& event) {
  return event.start_time || event.at || std::ranges::any_of(event.params, [](const auto& param) {
           return std::holds_alternative<Instant>(param.second);
         });
}

std::string set_enabled(Editing& editing, bool is_enabled) {
  const EventChoice choice = choice_of(editing.options);
  if (!choice.is_given()) {
    throw InputError({},
                     fmt::format("{}: which events? ROVER/SEQUENCE, ROVER/FIRST..LAST, --label, "
                                 "--day, --type and --rover say it",
                                 editing.options.verb));
  }
  const auto events = chosen_events(editing.files.plan, choice, days_of_all(editing.files));
  const auto changed =
      static_cast<std::size_t>(lsos::set_enabled(editing.document, events, is_enabled));
  std::string what =
      fmt::format("{} {}", counted(changed, "event"), is_enabled ? "enabled" : "disabled");
  if (changed < events.size()) {
    what += fmt::format(", {} {} so already", events.size() - changed,
                        events.size() - changed == 1 ? "was" : "were");
  }
  return what;
}

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

// Coordinates of the Points in a KML, in its order.
std::vector<std::string> points_of(const std::string& file) {
  std::vector<std::string> points;
  for (const SourcePlacemark& placemark : read_kml(file).placemarks) {
    for (const SourceGeometry& geometry : placemark.geometries) {
      if (geometry.kind == "Point") points.push_back(geometry.coordinates);
    }
  }
  return points;
}

// "SEV1=0.8".
std::map<std::string, double> read_charges(const EditOptions& options, const Plan& plan) {
  std::map<std::string, double> charges;
  for (const std::string& text : options.charges) {
    const std::size_t equals = text.rfind('=');
    const Parsed<double> charge = equals == std::string::npos
                                      ? Parsed<double>{}
                                      : parse_quantity(text.substr(equals + 1), *find_unit("1"));
    if (!charge || *charge.value < 0 || *charge.value > 1) {
      throw InputError(
          {}, fmt::format("--charge {}: ROVER=SHARE is wanted, 0 to 1, such as SEV1=0.8", text));
    }
    const std::string id = text.substr(0, equals);
    check_rover(plan, "--charge", id);
    charges[id] = *charge.value;
  }
  return charges;
}

Vec2 read_offset(const std::string& text) {
  if (text.empty()) return Vec2::Zero();
  const std::size_t comma = text.find(',');
  const auto length = [&](std::size_t from, std::size_t count) {
    return comma == std::string::npos ? Parsed<double>{}
                                      : parse_quantity(text.substr(from, count), *find_unit("m"));
  };
  const Parsed<double> east = length(0, comma), north = length(comma + 1, std::string::npos);
  if (!east || !north) {
    throw InputError(
        {}, fmt::format("--offset {}: EAST,NORTH in metres is wanted, such as 20,-5", text));
  }
  return {*east.value, *north.value};
}

}  // namespace

std::string edit_renumber(Editing& editing) {
  const int step = editing.options.step.value_or(10);
  if (step < 1) throw InputError({}, fmt::format("--step {}: must be at least 1", step));
  check_rover(editing.files.plan, "--rover", editing.options.rover);
  const int count = renumber(editing.document, step, editing.options.rover);
  return counted(count, "event") + " renumbered";
}

std::string edit_shift(Editing& editing) {
  const EditOptions& options = editing.options;
  const SimTime by = read_span(options.by);
  check_rover(editing.files.plan, "--rover", options.rover);
  const EventNames names(editing.files.plan);
  ShiftedPart part{options.rover, nullptr};
  if (!options.from.empty()) part.from = &names.named("--from", options.from, options.rover);
  if (part.from != nullptr && !says_time(*part.from)) {
    editing.warnings.push_back(fmt::format(
        "{}: {} {} says no time of its own: it begins when what is before it ends, which "
        "has not moved",
        options.from, part.from->type, quoted(part.from->label)));
  }
  const int count = shift_times(editing.document, by, part);
  if (count == 0) {
    editing.warnings.push_back("none of the events meant says a time, so nothing moved");
  }
  return fmt::format("{} moved by {}", counted(count, "time"), options.by);
}

std::string edit_enable(Editing& editing) { return set_enabled(editing, true); }

std::string edit_disable(Editing& editing) { return set_enabled(editing, false); }

namespace {

// "; SiteOrigin = 31,20 keeps the ground where it was", or "".
std::string kept_text(Editing& editing) {
  const std::string kept = keep_ground(editing.document, editing.files);
  return kept.empty() ? "" : "; " + kept;
}

}  // namespace

std::string edit_merge(Editing& editing) {
  const EditOptions& options = editing.options;
  if (options.arguments.empty()) {
    throw InputError({}, "edit merge: other plans are wanted, as in 'merge OTHER.kml'");
  }
  std::vector<std::unique_ptr<MissionFiles>> files;
  std::vector<std::unique_ptr<PlanDocument>> documents;
  std::vector<PlanDocument*> others;
  for (const std::string& file : options.arguments) {
    files.push_back(std::make_unique<MissionFiles>(read_mission(file)));
    files.back()->faults.throw_if_errors();
    const MissionFiles& other = *files.back();
    documents.push_back(std::make_unique<PlanDocument>(EditableFile(other.plan_bytes, file).kml(),
                                                       other.plan, other.catalog->declarations()));
    erase_notes(*documents.back());
    others.push_back(documents.back().get());
    if (std::string moved = moved_ground(other, editing.files.plan); !moved.empty()) {
      editing.warnings.push_back(std::move(moved));
    }
  }
  const Merged merged = Merger(editing.document, others).run();
  append(editing.warnings, merged.warnings);
  return fmt::format("{} and {} of {} merged{}", counted(merged.rovers, "rover"),
                     counted(merged.events, "event"), counted(others.size(), "plan"),
                     kept_text(editing));
}

std::string edit_repeat(Editing& editing) {
  const EditOptions& options = editing.options;
  const EventDays days = days_of(editing.files);
  EventChoice choice;
  choice.rover_id = options.rover;
  read_days(options.day, choice);
  Repetition repetition;
  repetition.events = chosen_events(editing.files.plan, choice, days);
  repetition.first_day = choice.first_day;
  repetition.last_day = choice.last_day;
  repetition.times = *options.times;
  repetition.begins = begins_of(editing.files);
  if (repetition.times < 1 || repetition.times > 1000) {
    throw InputError({}, fmt::format("--times {}: 1..1000 is allowed", repetition.times));
  }
  if (!options.places.empty()) repetition.places = points_of(options.places);
  repetition.places_file = options.places;
  const Repeated repeated = repeat(editing.document, repetition, days);
  append(editing.warnings, repeated.warnings);
  editing.copies = repeated.copies;
  return fmt::format("{} of day {} repeated {}, {} added",
                     counted(repetition.events.size(), "event"), options.day,
                     counted(repetition.times, "time"), counted(repeated.count, "event"));
}

namespace {

// Begins by the estimate of the days before; none where there is no estimate, which is warned of.
std::map<std::string, DayBegin> begins_of_day(Editing& editing, int day, const EventDays& days) {
  try {
    return day_begins(editing.files, day, days);
  } catch (const InputError& error) {
    editing.warnings.push_back(
        fmt::format("the days before cannot be estimated: {}", error.faults().front().what));
    return {};
  }
}

// "; by the estimate SEV1 begins at 0.012,0.004 heading 90 with 84.2 %".
std::string begins_text(const SplitDays& days) {
  std::string text;
  for (const auto& [id, begin] : days.begins) {
    text += fmt::format("{} {} at {:.6f},{:.6f}, heading {:.0f}", text.empty() ? ";" : ",", id,
                        lon_deg(begin.place), lat_deg(begin.place),
                        std::fmod(degrees(begin.heading_rad) + 360, 360));
    if (const auto given = days.charge.find(id); given != days.charge.end()) {
      text += fmt::format(", with {:.1f} % (--charge)", 100 * given->second);
    } else if (begin.charge) {
      text += fmt::format(", with {:.1f} %", 100 * *begin.charge);
    }
  }
  return text.empty() ? text : text + ", by the estimate of the days before";
}

}  // namespace

std::string edit_split(Editing& editing) {
  const EditOptions& options = editing.options;
  const EventDays days = days_of(editing.files);
  EventChoice choice;
  read_days(options.day, choice);
  SplitDays wanted{choice.first_day, chosen_events(editing.files.plan, choice, days),
                   read_charges(options, editing.files.plan)};
  if (choice.first_day > 1) wanted.begins = begins_of_day(editing, choice.first_day, days);
  const Split split = lsos::split(editing.document, wanted, days);
  append(editing.warnings, split.warnings);
  return fmt::format("{} of day {} kept, {} left out{}{}", counted(wanted.events.size(), "event"),
                     options.day, split.left_out, begins_text(wanted), kept_text(editing));
}

std::string edit_mirror(Editing& editing) {
  const EditOptions& options = editing.options;
  check_rover(editing.files.plan, "--from", options.from);
  check_rover(editing.files.plan, "--to", options.to);
  if (options.from == options.to) {
    throw InputError({},
                     fmt::format("--to {}: another rover than --from is wanted; 'repeat' copies "
                                 "a rover's own events",
                                 options.to));
  }
  const Mirrored mirrored =
      mirror(editing.document, {options.from, options.to, read_offset(options.offset)});
  append(editing.warnings, mirrored.warnings);
  editing.copies = mirrored.copies;
  return fmt::format("{} of {} copied for {}", counted(mirrored.count, "event"), options.from,
                     options.to);
}

}  // namespace lsos
