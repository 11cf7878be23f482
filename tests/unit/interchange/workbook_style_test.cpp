// How sheets look that are written as XLSX.
#include "interchange/workbook_style.h"

#include <gmock/gmock.h>

#include "interchange/table_writer.h"
#include "plan/kml_writer.h"
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

TEST(WorkbookStyle, leaves_a_file_as_it_is_that_lacks_a_part) {
  const std::vector<Table> tables{sheet("Events", "x")};
  const std::string xlsx = tables_as(".xlsx", tables, *find_body("Moon"), "plan.xlsx");
  const std::vector<std::string> names{"xl/styles.xml", "xl/workbook.xml",
                                       "xl/worksheets/sheet1.xml"};
  for (const std::string& missing : names) {
    std::vector<PackedFile> parts;
    KmzArchive archive(xlsx, "plan.xlsx");
    for (const std::string& name : names) {
      if (name != missing) parts.push_back({name, archive.unpacked(name)});
    }
    const std::string without = pack_zip(parts);
    EXPECT_EQ(styled_workbook(without, tables), without) << missing;
  }
}

TEST(WorkbookStyle, is_the_same_at_any_time) {
  const std::vector<Table> tables{sheet("Events", "x")};
  const std::string xlsx = tables_as(".xlsx", tables, *find_body("Moon"), "plan.xlsx");
  // Every entry has a header in the directory, with its time and date at bytes 12 to 15.
  int entries = 0;
  const std::string head("PK\x01\x02");
  for (std::size_t at = xlsx.find(head); at != std::string::npos; at = xlsx.find(head, at + 1)) {
    const auto word = [&](std::size_t of) {
      return static_cast<unsigned char>(xlsx[at + of]) +
             256 * static_cast<unsigned char>(xlsx[at + of + 1]);
    };
    ++entries;
    EXPECT_EQ(word(12), 0) << entries;
    EXPECT_EQ(word(14) >> 9, 0) << entries;  // years since 1980
  }
  EXPECT_GT(entries, 5);
}

}  // namespace
}  // namespace lsos
