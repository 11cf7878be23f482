// Writes a plan as an outline.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/quantity.h"
#include "interchange/clock_text.h"
#include "interchange/columns.h"
#include "interchange/event_days.h"
#include "interchange/outline.h"
#include "interchange/outline_phrase.h"
#include "interchange/places.h"
#include "interchange/thing_fields.h"
#include "interchange/value_text.h"

namespace lsos {

namespace {

// The items of a rover on a day, in their order.
struct Run {
  int day = 0;  // 0: not known
  std::string rover_id, items;
};

// An id before a colon.
std::string id_text(const std::string& id) {
  return id.find(':') == std::string::npos ? value_text(id) : in_quotes(id);
}

// An id in the heading "Day 3, SEV A", in quotes where it would be read otherwise.
std::string heading_id(const std::string& id, int day) {
  const bool is_plain = id_text(id) == id && id.find_first_of("'-*") == std::string::npos &&
                        !date_of_day(id, Instant{}) && !id.empty();
  const bool is_word = id.find("over") == 1 || id.find("sset") == 1 || id.find("lace") == 1 ||
                       id.find("ission") == 1;
  return is_plain && (day > 0 || !is_word) ? id : in_quotes(id);
}

class OutlineWriter {
 public:
  OutlineWriter(const KmlSource& plan, const Declarations& declarations,
                const std::vector<Landmark>& landmarks)
      : plan_(plan),
        declarations_(declarations),
        places_(plan, declarations, landmarks),
        days_(event_days(plan, declarations)) {}

  std::string write() {
    std::string mission, owners, places;
    for (std::size_t i = 0; i < plan_.placemarks.size(); ++i) {
      if (declarations_.events.contains(thing_type(plan_.placemarks[i]))) {
        add_event(i);
      } else {
        (thing_type(plan_.placemarks[i]) == "MissionInfo" ? mission : owners) += thing_line(i);
      }
    }
    for (const BookedPlace& place : places_.used()) {
      places += fmt::format("Place {}: ({}, {})\n", place.name, place.lon, place.lat);
    }
    return mission + places + owners + events_text();
  }

 private:
  // The fields of a thing, its name and description.
  OutlineFields fields_of_thing(std::size_t i) const {
    const SourcePlacemark& thing = plan_.placemarks[i];
    const int day = days_.empty() ? 0 : days_[i].day;
    OutlineFields fields;
    for (const SourceField& field : thing.data.front().fields) {
      const FieldDeclaration* declared =
          declared_field(thing_type(thing), field.name, declarations_);
      std::string text = field.text;
      if (declared != nullptr) text = text_with_unit(text, *declared);
      const bool is_time = declared != nullptr && (declared->kind == FieldKind::utc ||
                                                   declared->kind == FieldKind::moment);
      if (is_time && day > 0) text = time_on_day(text, day, plan_);
      fields.emplace_back(field.name, std::move(text));
    }
    if (!thing.name.empty()) fields.emplace_back(column::name, thing.name);
    if (!thing.description.empty()) fields.emplace_back(column::description, thing.description);
    return fields;
  }

  // The text for the column Place: names, "lon, lat" or well-known text.
  std::string place_of(std::size_t i) const {
    const SourcePlacemark& thing = plan_.placemarks[i];
    if (thing.geometries.empty()) return "";
    if (!places_.text(i).empty()) return places_.text(i);
    const SourceGeometry& geometry = thing.geometries.front();
    if (geometry.kind != "Point") return wkt_of(geometry);
    const std::string& tuple = geometry.coordinates;
    const std::size_t comma = tuple.find(',');
    const std::size_t end = std::min(tuple.find(',', comma + 1), tuple.size());
    return fmt::format("{}, {}", tuple.substr(0, comma), tuple.substr(comma + 1, end - comma - 1));
  }

  std::string thing_line(std::size_t i) const {
    const std::string& type = thing_type(plan_.placemarks[i]);
    const OutlineFields fields = fields_of_thing(i);
    if (type == "MissionInfo") return fmt::format("Mission: {}\n", field_list(fields, {}));
    const std::string rest = field_list(fields, {type + "Id", type + "Type"});
    const auto text = [&](const std::string& name) {
      const std::string* found = thing_field(plan_.placemarks[i], name);
      return found == nullptr ? "" : *found;
    };
    const std::string place = place_of(i);
    const bool is_named = !places_.text(i).empty();
    return fmt::format("{} {}: {} at {}{}{}\n", type, id_text(text(type + "Id")),
                       text(type + "Type"), is_named ? place : fmt::format("({})", place),
                       rest.empty() ? "" : ", ", rest);
  }

  void add_event(std::size_t i) {
    const SourcePlacemark& thing = plan_.placemarks[i];
    const std::string* id = thing_field(thing, "RoverId");
    const std::string rover_id = id == nullptr ? "" : *id;
    OutlineFields fields = fields_of_thing(i);
    fields.emplace_back(column::type, thing_type(thing));
    if (const std::string place = place_of(i); !place.empty()) {
      fields.emplace_back(column::place, place);
    }
    std::erase_if(fields, [&](const auto& field) {
      return field.first == "RoverId" ||
             (field.first == "Sequence" && follows(rover_id, field.second));
    });
    const int day = days_.empty() ? 0 : days_[i].day;
    if (runs_.empty() || runs_.back().rover_id != rover_id || runs_.back().day != day) {
      runs_.push_back({day, rover_id, ""});
    }
    runs_.back().items += "  " + item_of(fields, declarations_) + "\n";
  }

  // Whether an event without a Sequence would have this one.
  bool follows(const std::string& rover_id, const std::string& text) {
    constexpr std::int64_t step = 10;
    const Parsed<std::int64_t> sequence = parse_integer(text);
    std::int64_t& last = sequence_[rover_id];
    const bool is_next = sequence && *sequence.value == last + step;
    if (sequence) last = *sequence.value;
    return is_next;
  }

  // Days together where no rover goes back to an earlier one.
  std::string events_text() {
    bool is_in_order = true;
    for (std::size_t i = 1; i < runs_.size(); ++i) {
      const bool is_back =
          runs_[i].rover_id == runs_[i - 1].rover_id && runs_[i].day < runs_[i - 1].day;
      is_in_order = is_in_order && !is_back;
    }
    if (is_in_order) std::ranges::stable_sort(runs_, {}, &Run::day);
    std::string text;
    for (const Run& run : runs_) {
      const std::string day = run.day > 0 ? fmt::format("Day {}, ", run.day) : "";
      text += fmt::format("\n{}{}:\n{}", day, heading_id(run.rover_id, run.day), run.items);
    }
    return text;
  }

  const KmlSource& plan_;
  const Declarations& declarations_;
  PlaceBook places_;
  std::vector<EventDay> days_;
  std::vector<Run> runs_;
  std::map<std::string, std::int64_t> sequence_;  // the last, by rover id
};

}  // namespace

std::string outline_of(const KmlSource& plan, const Declarations& declarations,
                       const std::vector<Landmark>& landmarks) {
  return OutlineWriter(plan, declarations, landmarks).write();
}

}  // namespace lsos
