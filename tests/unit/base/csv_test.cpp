// Tables of separated values.
#include "base/csv.h"

#include <gmock/gmock.h>

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(Csv, has_rows_of_cells_and_the_lines_where_they_begin) {
  const CsvTable table = parse_csv("a,b\n1,2\n\n 3 , 4 \n");
  EXPECT_EQ(table.fault, "");
  ASSERT_THAT(table.rows, SizeIs(3));
  EXPECT_THAT(table.rows[0].cells, ElementsAre("a", "b"));
  EXPECT_THAT(table.rows[2].cells, ElementsAre("3", "4"));
  EXPECT_EQ(table.rows[2].line, 4);
}

TEST(Csv, is_separated_by_what_its_heading_has_most_of) {
  EXPECT_EQ(parse_csv("a;b;c,d\n").separator, ';');
  EXPECT_EQ(parse_csv("a\tb\n").separator, '\t');
  EXPECT_EQ(parse_csv("\"a;b;c\",d\n").separator, ',');
  EXPECT_EQ(parse_csv("alone\n").separator, ',');
  const CsvTable named = parse_csv("sep=;\na,b\n");
  EXPECT_EQ(named.separator, ';');
  EXPECT_THAT(named.rows[0].cells, ElementsAre("a,b"));
  EXPECT_EQ(named.rows[0].line, 2);
}

TEST(Csv, may_be_written_on_any_system) {
  for (const char* text : {"a,b\n1,2\n", "a,b\r\n1,2\r\n", "a,b\r1,2\r",
                           "\xef\xbb\xbf"
                           "a,b\n1,2",
                           "# of an instrument\n\na,b\n1,2"}) {
    const CsvTable table = parse_csv(text);
    ASSERT_THAT(table.rows, SizeIs(2)) << text;
    EXPECT_THAT(table.rows[0].cells, ElementsAre("a", "b")) << text;
    EXPECT_THAT(table.rows[1].cells, ElementsAre("1", "2")) << text;
  }
}

TEST(Csv, has_quotes_around_separators_line_ends_and_quotes) {
  const CsvTable table = parse_csv("a,b\n\"1,\"\"5\"\"\",\"two\r\nlines\"\n3,\n");
  ASSERT_THAT(table.rows, SizeIs(3));
  EXPECT_THAT(table.rows[1].cells, ElementsAre("1,\"5\"", "two\nlines"));
  EXPECT_THAT(table.rows[2].cells, ElementsAre("3", ""));
  EXPECT_EQ(table.rows[2].line, 4);
}

TEST(Csv, tells_where_a_quotation_mark_is_not_closed) {
  const CsvTable table = parse_csv("a,b\n1,2\n3,\"4\n5,6\n");
  EXPECT_THAT(table.fault, HasSubstr("not closed"));
  EXPECT_EQ(table.fault_line, 3);
  EXPECT_THAT(table.rows, SizeIs(2));
}

TEST(Csv, is_text_in_utf_8) {
  EXPECT_THAT(parse_csv("\xff\xfe"
                        "a")
                  .fault,
              HasSubstr("UTF-8 is allowed"));
  EXPECT_THAT(parse_csv(std::string_view("a,b\0c", 5)).fault, HasSubstr("no text"));
  EXPECT_THAT(parse_csv("").rows, IsEmpty());
  EXPECT_THAT(parse_csv("\n\n").rows, IsEmpty());
}

TEST(CsvCell, is_quoted_where_it_must_be) {
  EXPECT_EQ(csv_cell("To the ridge"), "To the ridge");
  EXPECT_EQ(csv_cell("A, \"B\""), "\"A, \"\"B\"\"\"");
  EXPECT_EQ(csv_cell("two\nlines"), "\"two\nlines\"");
}

TEST(CsvCell, is_no_formula) {
  EXPECT_EQ(csv_cell("=1+1"), "'=1+1");
  EXPECT_EQ(csv_cell("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csv_cell("+cmd|' /C calc'!A0"), "'+cmd|' /C calc'!A0");
  EXPECT_EQ(csv_cell("-2+3+cmd|' /C calc'!A0"), "'-2+3+cmd|' /C calc'!A0");
  EXPECT_EQ(csv_cell("=HYPERLINK(\"http://x\")"), "\"'=HYPERLINK(\"\"http://x\"\")\"");
}

TEST(CsvCell, has_numbers_as_they_are) {
  for (const char* text :
       {"-5", "+10 km/h", "-.5e-3", "-31.5,20.1; -31.4,20.2", "-5 °C", "5", "-"}) {
    EXPECT_EQ(guarded_text(text), text);
  }
}

TEST(CsvCell, comes_back_as_it_was) {
  for (const char* text : {"", "'", "''", "=", "'=1", "''=1", "-", "-x", "'-x", "'quoted'", "'-5",
                           "@a", "'@a", "don't", "=1\n=2"}) {
    EXPECT_EQ(unguarded_text(guarded_text(text)), text);
  }
  EXPECT_EQ(unguarded_text("'tis"), "'tis");
}

}  // namespace
}  // namespace lsos
