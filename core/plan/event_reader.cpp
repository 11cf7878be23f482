#include "plan/event_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "base/visible_text.h"
#include "plan/far_places.h"
#include "plan/geometry.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

class EventsReader {
 public:
  EventsReader(const ReadContext& context, const std::vector<std::string>& rover_ids,
               const PlanGaps& gaps)
      : context_(context),
        gaps_(gaps),
        suggestions_(rover_ids),
        rover_ids_(rover_ids.begin(), rover_ids.end()) {}

  DraftEvent read(const PlanPlacemark& ours) {
    const EventDeclaration& declaration = *ours.event;
    FieldReader fields(subject_of(ours, "Sequence", context_), ours.data, context_.faults);
    fields.check_names({event_identity_fields(), common_event_fields(), declaration.fields});
    const bool has_known_names = fields.fault_count() == 0;

    DraftEvent draft;
    draft.subject = fields.subject().name;
    draft.drives = declaration.drives;
    draft.start_after = fields.find("StartAfter");
    draft.on_failure = fields.find("OnFailure");
    draft.takes_default_on_failure = draft.on_failure == nullptr;
    PlanEvent& event = draft.event;
    event.place = fields.subject().place;
    event.type = declaration.name;
    read_identity(fields, draft);
    draft.has_default_label = ours.placemark->name.empty();
    event.label = draft.has_default_label ? fmt::format("{} {}", event.type, event.sequence)
                                          : one_line(ours.placemark->name);
    read_common(fields, draft);
    const int faults_before = fields.fault_count();
    event.params = fields.read(declaration.fields, &draft.defaults);
    event.has_all_params = has_known_names && fields.fault_count() == faults_before;
    const auto geometry =
        read_geometry(*ours.placemark, declaration.geometries, fields.subject(), context_.faults);
    if (geometry) {
      event.geometry = *geometry;
      if (!event.geometry.points.empty()) {
        draft.comma_places = with_decimal_commas(ours.placemark->geometries.front().coordinates);
      }
    } else {
      draft.is_drive_known = false;
    }
    return draft;
  }

 private:
  void read_identity(FieldReader& fields, DraftEvent& draft) {
    PlanEvent& event = draft.event;
    const FieldValues values = fields.read(event_identity_fields(), nullptr);
    const auto* sequence = find_value<std::int64_t>(values, "sequence");
    const auto* rover_id = find_value<std::string>(values, "rover_id");
    draft.is_sequence_known = sequence != nullptr;
    if (sequence != nullptr) event.sequence = *sequence;
    if (rover_id == nullptr) return;
    event.rover_id = *rover_id;
    draft.is_rover_known = rover_ids_.contains(event.rover_id);
    draft.is_placed = draft.is_rover_known && draft.is_sequence_known;
    // When there is no rover at all, that fault is mended first, and it has been reported.
    if (draft.is_rover_known || rover_ids_.empty()) return;
    // The id may belong to a rover whose RoverId cannot be read.
    if (gaps_.rover_ids) return;
    std::string hint = suggestions_(event.rover_id);
    if (hint.empty()) hint = fmt::format("; there are {}", listed(suggestions_.known()));
    fields.error("RoverId", fmt::format("there is no such rover{}", hint));
  }

  void read_common(FieldReader& fields, DraftEvent& draft) {
    PlanEvent& event = draft.event;
    const FieldValues values = fields.read(common_event_fields(), nullptr);
    if (const bool* enabled = find_value<bool>(values, "enabled")) {
      event.is_enabled = *enabled;
    } else {
      event.is_enabled = draft.is_drive_known = false;
    }
    if (const auto* start = find_value<Instant>(values, "start_time")) event.start_time = *start;
    if (const auto* timeout_s = find_value<double>(values, "timeout_s")) {
      event.timeout = from_seconds(*timeout_s);
    }
    const auto read = [&](const char* name, PlanEvent::Condition& condition) {
      const SourceField* field = fields.find(name);
      if (field != nullptr) condition = {field->text, field->line};
    };
    read("StartWhen", event.start_when);
    read("SkipWhen", event.skip_when);
    read("StopWhen", event.stop_when);
    read("WarnWhen", event.warn_when);
  }

  const ReadContext& context_;
  const PlanGaps& gaps_;
  Suggestions suggestions_;
  std::set<std::string> rover_ids_;
};

void check_sequences(std::vector<DraftEvent>& drafts, const ReadContext& context) {
  const DraftEvent* first = nullptr;  // first event with the current rover and sequence
  for (DraftEvent& draft : drafts) {
    if (!draft.is_placed) continue;
    const PlanEvent& event = draft.event;
    if (first == nullptr || first->event.rover_id != event.rover_id ||
        first->event.sequence != event.sequence) {
      first = &draft;
      continue;
    }
    draft.is_placed = false;
    context.faults.error(event.place,
                         fmt::format("{}: Sequence = {}: rover {} has an event with it at {}",
                                     draft.subject, event.sequence, quoted(event.rover_id),
                                     line_text(first->event.place, event.place.file)));
  }
}

}  // namespace

std::vector<DraftEvent> read_events(const std::vector<PlanPlacemark>& events,
                                    const ReadContext& context,
                                    const std::vector<std::string>& rover_ids,
                                    const PlanGaps& gaps) {
  EventsReader reader(context, rover_ids, gaps);
  std::vector<DraftEvent> drafts;
  drafts.reserve(events.size());
  for (const PlanPlacemark& ours : events) drafts.push_back(reader.read(ours));
  std::ranges::stable_sort(drafts, {}, [](const DraftEvent& draft) {
    const PlanEvent& event = draft.event;
    return std::tuple<const std::string&, std::int64_t, const std::string&, int>(
        event.rover_id, event.sequence, event.place.file, event.place.line);
  });
  check_sequences(drafts, context);
  return drafts;
}

std::vector<std::string> common_defaults(const std::vector<PlanPlacemark>& events,
                                         const std::vector<DraftEvent>& drafts) {
  std::vector<std::string> defaults;
  for (const FieldDeclaration& declaration : common_event_fields()) {
    if (!declaration.default_value) continue;
    const auto lacks_it = [&](const PlanPlacemark& ours) {
      return std::ranges::none_of(ours.data.fields, [&](const SourceField& field) {
        return field.name == declaration.name && !field.text.empty();
      });
    };
    const auto count =
        declaration.name == "OnFailure"  // of some events their Rover or the mission says it
            ? std::ranges::count_if(drafts, &DraftEvent::takes_default_on_failure)
            : std::ranges::count_if(events, lacks_it);
    if (count == 0) continue;
    defaults.push_back(fmt::format("{} = {} ({} of {} events)", declaration.name,
                                   format_value(declaration, *declaration.default_value), count,
                                   events.size()));
  }
  return defaults;
}

}  // namespace lsos
