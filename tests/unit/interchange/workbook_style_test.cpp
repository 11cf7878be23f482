// How sheets look that are written as XLSX.
#include "interchange/workbook_style.h"

#include <gmock/gmock.h>

#include "interchange/table_writer.h"
#include "plan/kmz_archive.h"
#include "planet/body.h"

namespace lsos {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

Table sheet(const std::string& name, const std::string& long_text) {
  Table table;
  table.name = name;
  table.header = {"Type", "Speed (km/h)", "Notes"};
  table.rows = {{2, {"Route", "5", long_text}}, {3, {"Type"}}};
  return table;
}

TEST(WorkbookStyle, has_columns_as_wide_as_their_texts_and_a_bold_header_that_stays) {
  const std::vector<Table> tables{sheet("Events", std::string(30, 'x')),
                                  sheet("Rovers", std::string(500, 'y'))};
  std::string xlsx = tables_as(".xlsx", tables, *find_body("Moon"), "plan.xlsx");
  KmzArchive archive(xlsx, "plan.xlsx");
  const std::string events = archive.unpacked("xl/worksheets/sheet1.xml");
  EXPECT_THAT(events, AllOf(HasSubstr("<col min=\"1\" max=\"1\" width=\"8\""),
                            HasSubstr("<col min=\"2\" max=\"2\" width=\"14\""),
                            HasSubstr("<col min=\"3\" max=\"3\" width=\"32\""),
                            Not(HasSubstr("max=\"1024\""))));
  EXPECT_THAT(events, HasSubstr("<pane ySplit=\"1\" topLeftCell=\"A2\""));
  EXPECT_THAT(events,
              AllOf(HasSubstr("<c r=\"A1\" s=\"6\" t=\"s\">"),
                    HasSubstr("<c r=\"C1\" s=\"6\" t=\"s\">"), HasSubstr("<c r=\"A2\" t=\"s\">")));
  const std::string styles = archive.unpacked("xl/styles.xml");
  EXPECT_THAT(styles, AllOf(HasSubstr("<fonts count=\"2\">"), HasSubstr("<cellXfs count=\"7\">"),
                            HasSubstr("fontId=\"1\"")));
  EXPECT_THAT(archive.unpacked("xl/worksheets/sheet2.xml"),
              HasSubstr("<col min=\"3\" max=\"3\" width=\"60\""));
}

}  // namespace
}  // namespace lsos
