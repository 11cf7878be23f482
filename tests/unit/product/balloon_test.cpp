// What balloons say of events, in units that people read.
#include "product/balloon.h"

#include <gmock/gmock.h>

namespace lsos {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const Instant start = *parse_utc("2026-07-01T06:00:00Z").value;

EventEstimate pause() {
  EventEstimate event;
  event.status = EventStatus::completed;
  event.start_s = 0;
  event.end_s = 526;
  event.energy_used_j = 2.8445 * 3.6e6;
  event.charge_end = 0.6149;
  return event;
}

TEST(Balloon, rounds_what_it_shows_and_not_what_it_converts) {
  const std::string html = balloon(pause(), start);
  // 10.24 MJ would be 10.2 MJ, and that 2.833 kWh.
  EXPECT_THAT(html, HasSubstr("<td>Energy used<td>2.84 kWh"));
  EXPECT_THAT(html, HasSubstr("<td>Takes<td>8 min 46 s"));
  EXPECT_THAT(html, HasSubstr("<td>Charge at its end<td>61.5 %"));
  EXPECT_THAT(html, Not(HasSubstr("Expected")));
}

TEST(Balloon, says_ranges) {
  EventEstimate event = pause();
  event.start_range_s = Expected{-5, 35};
  event.end_range_s = Expected{520, 580};
  event.energy_range_j = Expected{2.7e6, 3.9e6};
  event.charge_end_range = Expected{0.6, 0.62};
  const std::string html = balloon(event, start);
  EXPECT_THAT(html, HasSubstr("<td>Begins<td>2026-07-01 05:59:55 to 06:00:35 UTC"));
  EXPECT_THAT(html, HasSubstr("<td>Ends<td>2026-07-01 06:08:40 to 06:09:40 UTC"));
  EXPECT_THAT(html, HasSubstr("<td>Energy used<td>750 Wh to 1.08 kWh"));
  EXPECT_THAT(html, HasSubstr("<td>Charge at its end<td>60 to 62 %"));
}

TEST(Balloon, says_what_becomes_of_an_event) {
  EventEstimate event = pause();
  event.status = EventStatus::failed;
  event.reason = "timed out after 526 s";
  EXPECT_THAT(balloon(event, start),
              HasSubstr("<td>Expected<td>failed<tr><td>Why<td>timed out after 526 s"));
}

TEST(Balloon, says_long_times_in_hours_and_days) {
  EventRow row;
  row.start = SimTime{};
  row.end = from_seconds(3 * 3600 + 299);
  EXPECT_THAT(balloon(row, start), HasSubstr("<td>Took<td>3 h 05 min"));
  row.end = from_seconds(26 * 3600);
  EXPECT_THAT(balloon(row, start), HasSubstr("<td>Took<td>1 d 02 h"));
  row.end = from_seconds(12.5);
  EXPECT_THAT(balloon(row, start), HasSubstr("<td>Took<td>12.5 s"));
}

TEST(Balloon, of_a_note_is_in_words) {
  NoteRow note;
  note.rover_id = "A";
  note.name = "warn_when";
  note.fields_json = R"({"condition":"slip > 0.05"})";
  const std::string html = balloon(note, start);
  EXPECT_THAT(html, HasSubstr("<td>Rover<td>A"));
  EXPECT_THAT(html, HasSubstr("<td>Condition<td>slip &gt; 0.05"));
  EXPECT_THAT(html, Not(HasSubstr("{")));
}

}  // namespace
}  // namespace lsos
