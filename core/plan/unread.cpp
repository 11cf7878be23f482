#include "plan/unread.h"
#include "base/quantity.h"

#include <fmt/format.h>

#include <algorithm>

namespace lsos {

namespace {

std::string field_text(const SourceData& data, const char* name) {
  const auto field = std::ranges::find(data.fields, name, &SourceField::name);
  return field == data.fields.end() ? "" : field->text;
}

DraftEvent read_event(const PlanPlacemark& ours, const ReadContext& context) {
  DraftEvent draft;
  draft.is_read = false;
  draft.subject = subject_of(ours, "Sequence", context).name;
  PlanEvent& event = draft.event;
  event.place = place_of(*ours.placemark, context);
  event.label = ours.placemark->name;
  draft.has_default_label = event.label.empty();
  event.rover_id = field_text(ours.data, "RoverId");
  const Parsed<std::int64_t> sequence = parse_integer(field_text(ours.data, "Sequence"));
  draft.is_sequence_known = static_cast<bool>(sequence);
  event.sequence = sequence.value.value_or(0);
  return draft;
}

}  // namespace

Unread read_unread(const std::vector<PlanPlacemark>& unread, const ReadContext& context,
                   PlanGaps& gaps) {
  Unread read;
  for (const PlanPlacemark& ours : unread) {
    const auto has = [&](const char* name) { return !field_text(ours.data, name).empty(); };
    if (has("RoverType")) {
      read.has_rover = true;
      if (has("RoverId")) {
        read.rover_ids.push_back(field_text(ours.data, "RoverId"));
        gaps.unread_ids.insert(read.rover_ids.back());
      } else {
        gaps.rover_ids = true;
      }
    } else if (has("AssetId")) {
      gaps.unread_ids.insert(field_text(ours.data, "AssetId"));
    } else if (has("AssetType")) {
      gaps.asset_ids = true;
    } else if (has("Planet") || has("Terrain")) {
      read.has_mission = true;
    } else {
      read.events.push_back(read_event(ours, context));
    }
  }
  return read;
}

}  // namespace lsos
