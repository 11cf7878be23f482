// What headers of sheets mean.
#include "interchange/columns.h"

#include <gmock/gmock.h>

#include "unit/plan/plan_fixture.h"

namespace lsos::test {
namespace {

// Fields of a plan come before everyday words, so none of the fields that every plan has may be
// called as one of them.
TEST(ColumnMeant, is_what_everyday_words_mean) {
  const Declarations known = declarations();
  const std::map<std::string, std::vector<std::string>> words{
      {column::type, {"Event", "Task", "Activity", "Kind"}},
      {column::name, {"Label", "Title", "Names"}},
      {column::description, {"Notes", "Note", "Comment", "Remarks", "desc"}},
      {column::day, {"Date", "Days"}},
      {column::place, {"Location", "Where", "Site", "SITE", "Places", "Waypoints", "via"}},
      {column::lon, {"Longitude", "long", "lng", "Lon deg"}},
      {column::lat, {"Latitude", "Lat deg"}},
      {column::wkt, {"Geometry", "geom"}},
      {"RoverId", {"Rover", "Vehicle", "Rover ID"}},
      {"Sequence", {"Seq", "No", "Nr"}},
      {"StartTime", {"Start", "Time", "Begin", "Start time"}},
      {"SiteOrigin", {"Site origin", "siteorigin"}},
  };
  for (const auto& [meant, headers] : words) {
    for (const std::string& header : headers) {
      EXPECT_EQ(column_meant(header, known), meant) << header;
    }
  }
}

}  // namespace
}  // namespace lsos::test
