// Spreadsheets as programs save them: encodings, formulas, merged cells, dates, archives that would
// burst.
#include "interchange/sheets.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "interchange/workbook_archive.h"
#include "plan/kml_writer.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Writes the bytes to a file and removes it at the end.
class SheetFile {
 public:
  SheetFile(const std::string& name, const std::string& bytes)
      : path_((fs::temp_directory_path() / fmt::format("{}_{}", ::getpid(), name)).string()),
        bytes_(bytes) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~SheetFile() { fs::remove(path_); }
  std::vector<Table> tables() const { return read_workbook(bytes_, path_); }
  std::string error() const {
    try {
      tables();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  std::string path_, bytes_;
};

// A workbook with one sheet, whose rows are XML.
std::string xlsx(const std::string& rows, const std::string& after_rows = "",
                 const std::string& properties = "") {
  const std::string head = R"(<?xml version="1.0" encoding="UTF-8"?>)";
  const std::string main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
  const std::string office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
  const std::string package = "http://schemas.openxmlformats.org/package/2006/";
  return pack_zip(
      {{"[Content_Types].xml",
        head + "<Types xmlns=\"" + package +
            "content-types\"><Default Extension=\"xml\" ContentType=\"application/xml\"/><Default "
            "Extension=\"rels\" "
            "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Override "
            "PartName=\"/xl/workbook.xml\" "
            "ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+"
            "xml\"/><Override PartName=\"/xl/worksheets/sheet1.xml\" "
            "ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+"
            "xml\"/></Types>"},
       {"_rels/.rels", head + "<Relationships xmlns=\"" + package +
                           "relationships\"><Relationship Id=\"rId1\" Type=\"" + office +
                           "/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"},
       {"xl/workbook.xml", head + "<workbook xmlns=\"" + main + "\" xmlns:r=\"" + office + "\">" +
                               properties +
                               "<sheets><sheet name=\"Events\" sheetId=\"1\" "
                               "r:id=\"rId1\"/></sheets></workbook>"},
       {"xl/_rels/workbook.xml.rels",
        head + "<Relationships xmlns=\"" + package +
            "relationships\"><Relationship Id=\"rId1\" Type=\"" + office +
            "/worksheet\" Target=\"worksheets/sheet1.xml\"/><Relationship Id=\"rId2\" Type=\"" +
            office + "/styles\" Target=\"styles.xml\"/></Relationships>"},
       {"xl/styles.xml",
        head + "<styleSheet xmlns=\"" + main +
            "\"><numFmts count=\"1\"><numFmt numFmtId=\"164\" formatCode=\"0.0&quot; "
            "km/h&quot;\"/><numFmt numFmtId=\"165\" formatCode=\"0.0 %\"/><numFmt numFmtId=\"166\" "
            "formatCode=\"0&quot; % &quot;\"/></numFmts><cellXfs count=\"8\"><xf "
            "numFmtId=\"0\"/><xf numFmtId=\"22\"/><xf numFmtId=\"14\"/><xf numFmtId=\"46\"/><xf "
            "numFmtId=\"164\"/><xf numFmtId=\"9\"/><xf numFmtId=\"165\"/><xf "
            "numFmtId=\"166\"/></cellXfs></styleSheet>"},
       {"xl/worksheets/sheet1.xml", head + "<worksheet xmlns=\"" + main + "\"><sheetData>" + rows +
                                        "</sheetData>" + after_rows + "</worksheet>"}});
}

std::string text_cell(const std::string& at, const std::string& text) {
  return "<c r=\"" + at + "\" t=\"inlineStr\"><is><t>" + text + "</t></is></c>";
}

const std::string header = "<row r=\"1\">" + text_cell("A1", "Type") + text_cell("B1", "Day") +
                           text_cell("C1", "Start") + "</row>";

TEST(Workbook, keeps_row_numbers_and_values_of_formulas) {
  const SheetFile file("formula.xlsx", xlsx(header + "<row r=\"4\">" + text_cell("A4", "Pause") +
                                            "<c r=\"B4\"><f>1+2</f><v>3</v></c></row>"));
  const Table table = file.tables().at(0);
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(table.rows[0].number, 4);
  EXPECT_EQ(cell(table.rows[0], 0), "Pause");
  EXPECT_EQ(cell(table.rows[0], 1), "3");
  EXPECT_THAT(table.file, HasSubstr(".xlsx/Events"));
}

TEST(Workbook, fills_merged_cells) {
  const SheetFile file("merged.xlsx",
                       xlsx(header + "<row r=\"2\">" + text_cell("A2", "Pause") +
                                "<c r=\"B2\"><v>2</v></c></row><row r=\"3\">" +
                                text_cell("A3", "EVA") + "<c r=\"B3\"/></row><row r=\"4\">" +
                                text_cell("A4", "Pause") + "<c r=\"B4\"/></row>",
                            "<mergeCells count=\"1\"><mergeCell ref=\"B2:B3\"/></mergeCells>"));
  const Table table = file.tables().at(0);
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(cell(table.rows[1], 1), "2");
  EXPECT_EQ(cell(table.rows[2], 1), "");
}

// Excel's serial number 46204.25 is 2026-07-01 06:00 counted from 1900 (ECMA-376, 18.17.4.1), and
// 44742.25 counted from 1904.
TEST(Workbook, reads_dates_counted_from_1900_and_1904) {
  const auto start = [](const std::string& serial, const std::string& properties) {
    const SheetFile file(
        "dates.xlsx", xlsx(header + "<row r=\"2\">" + text_cell("A2", "Wait") +
                               "<c r=\"B2\"/><c r=\"C2\" s=\"1\"><v>" + serial + "</v></c></row>",
                           "", properties));
    return cell(file.tables().at(0).rows.at(0), 2);
  };
  EXPECT_THAT(start("46204.25", ""), HasSubstr("2026/07/01 06:00:00"));
  EXPECT_THAT(start("44742.25", "<workbookPr date1904=\"1\"/>"), HasSubstr("2026-07-01 06:00:00"));
}

TEST(Workbook, has_spans_and_units_that_number_formats_show) {
  const SheetFile file("formats.xlsx", xlsx(header + "<row r=\"2\">" + text_cell("A2", "Pause") +
                                            "<c r=\"B2\" s=\"3\"><v>1.0833333333333333</v></c><c "
                                            "r=\"C2\" s=\"4\"><v>5.5</v></c></row>"));
  const TableRow row = file.tables().at(0).rows.at(0);
  EXPECT_EQ(cell(row, 1), "26:00:00");
  EXPECT_EQ(cell(row, 2), "5.5 km/h");
}

// A cell that shows 75 % holds 0.75 (ECMA-376-1, 18.8.30).
TEST(Workbook, has_percents_as_they_are_seen) {
  const auto cell_of = [](int style, const std::string& number) {
    const SheetFile file(
        "percent.xlsx",
        xlsx(header + "<row r=\"2\">" + text_cell("A2", "Recharge") +
             fmt::format("<c r=\"B2\" s=\"{}\"><v>{}</v></c></row>", style, number)));
    return cell(file.tables().at(0).rows.at(0), 1);
  };
  EXPECT_EQ(cell_of(5, "0.75"), "75 %");
  EXPECT_EQ(cell_of(6, "0.07"), "7 %");
  EXPECT_EQ(cell_of(5, "1"), "100 %");
  EXPECT_EQ(cell_of(0, "0.75"), "0.75");
}

TEST(Workbook, has_the_shortest_digits_of_a_number) {
  const SheetFile file("digits.xlsx", xlsx(header + "<row r=\"2\">" + text_cell("A2", "Place") +
                                           "<c r=\"B2\"><v>80.11781499999999</v></c></row>"));
  EXPECT_EQ(cell(file.tables().at(0).rows.at(0), 1), "80.117815");
}

// An ODS archive whose cells B2 and, by its column, C2 show km/h.
std::string ods() {
  const std::string names = R"(xmlns:office="urn:oasis:names:tc:opendocument:xmlns:office:1.0" )"
                            R"(xmlns:table="urn:oasis:names:tc:opendocument:xmlns:table:1.0" )"
                            R"(xmlns:text="urn:oasis:names:tc:opendocument:xmlns:text:1.0" )"
                            R"(xmlns:style="urn:oasis:names:tc:opendocument:xmlns:style:1.0" )"
                            R"(xmlns:number="urn:oasis:names:tc:opendocument:xmlns:datastyle:1.0")";
  const auto text = [](const char* words) {
    return fmt::format(
        R"(<table:table-cell office:value-type="string"><text:p>{}</text:p></table:table-cell>)",
        words);
  };
  const auto number = [](const char* value, const char* style) {
    return fmt::format(R"(<table:table-cell {} office:value-type="float" office:value="{}"/>)",
                       style, value);
  };
  return pack_zip(
      {{"mimetype", "application/vnd.oasis.opendocument.spreadsheet"},
       {"styles.xml", "<office:document-styles " + names + "/>"},
       {"content.xml",
        "<office:document-content " + names + "><office:automatic-styles>" +
            R"(<number:number-style style:name="N1"><number:number number:decimal-places="1"/>)" +
            "<number:text> km/h</number:text></number:number-style>" +
            R"(<style:style style:name="ce1" style:family="table-cell" )" +
            R"(style:data-style-name="N1"/></office:automatic-styles><office:body>)" +
            R"(<office:spreadsheet><table:table table:name="Events">)" +
            R"(<table:table-column table:number-columns-repeated="2"/>)" +
            R"(<table:table-column table:default-cell-style-name="ce1"/><table:table-row>)" +
            text("Type") + text("Speed") + text("Limit") + text("No") + text("Share") +
            text("Notes") + "</table:table-row><table:table-row>" + text("Route") +
            number("5.5", R"(table:style-name="ce1")") + number("7", "") + number("3", "") +
            R"(<table:table-cell office:value-type="percentage" office:value="0.75">)" +
            "<text:p>75%</text:p></table:table-cell>" +
            R"(<table:table-cell office:value-type="string"><office:annotation><text:p>ask Ann)" +
            "</text:p></office:annotation><text:p>two<text:s/> words</text:p><text:p>on lines" +
            "</text:p></table:table-cell><table:table-cell><office:annotation><text:p>empty?" +
            "</text:p></office:annotation></table:table-cell>" +
            "</table:table-row></table:table></office:spreadsheet></office:body>" +
            "</office:document-content>"}});
}

TEST(Workbook, has_units_that_number_formats_of_ods_show) {
  const SheetFile file("formats.ods", ods());
  const TableRow row = file.tables().at(0).rows.at(0);
  EXPECT_EQ(cell(row, 1), "5.5 km/h");
  EXPECT_EQ(cell(row, 2), "7 km/h");
  EXPECT_EQ(cell(row, 3), "3");
  EXPECT_EQ(cell(row, 4), "75 %");
}

TEST(Workbook, has_texts_of_ods_without_comments) {
  const SheetFile file("comments.ods", ods());
  const TableRow row = file.tables().at(0).rows.at(0);
  EXPECT_EQ(cell(row, 5), "two  words\non lines");
  EXPECT_EQ(cell(row, 6), "");
}

TEST(Workbook, is_judged_by_its_directory_before_it_is_opened) {
  const std::string bytes = xlsx(header + std::string(3'000'000, ' '));
  EXPECT_LT(bytes.size(), 20'000u);
  try {
    workbook_facts(bytes, "bomb.xlsx", 1'000'000);
    ADD_FAILURE() << "a bomb was opened";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("bomb.xlsx: unpacks to 2 MiB; a spreadsheet of a plan has "
                                        "at most 0 MiB"));
  }
}

TEST(Workbook, that_is_damaged_or_none_is_told) {
  const std::string bytes = xlsx(header);
  EXPECT_THAT(SheetFile("cut.xlsx", bytes.substr(0, bytes.size() / 2)).error(),
              HasSubstr("the spreadsheet is cut short or damaged"));
  EXPECT_THAT(SheetFile("other.xlsx", pack_zip({{"a.txt", "text"}})).error(),
              HasSubstr("is an archive, but no spreadsheet (XLSX or ODS) is in it"));
  EXPECT_THAT(SheetFile("empty.xlsx", xlsx("")).error(), HasSubstr("has no cell with text in it"));
}

TEST(Csv, is_read_in_utf_8_utf_16_and_windows_1252) {
  const std::string utf8 =
      "Type;Place\nRoute;Gr\xc3\xb6\xc3\x9f"
      "e\n";
  std::string utf16 = "\xff\xfe";
  for (const char c : std::string("Type;Place\nRoute;Gr")) utf16 += std::string{c, '\0'};
  utf16 += std::string("\xf6\0\xdf\0e\0\n\0", 8);
  for (const std::string& bytes : {utf8, utf16,
                                   std::string("Type;Place\nRoute;Gr\xf6\xdf"
                                               "e\n")}) {
    const Table table = read_csv(bytes, "tasks.csv").at(0);
    EXPECT_EQ(cell(table.rows.at(0), 1),
              "Gr\xc3\xb6\xc3\x9f"
              "e");
    EXPECT_TRUE(table.has_commas);
  }
}

TEST(Csv, below_a_title_is_separated_as_its_header) {
  const Table table = read_csv("Plan of the week\n\nType;Rover\nPause;A\n", "tasks.csv").at(0);
  EXPECT_EQ(table.header_number, 3);
  EXPECT_EQ(table.header.size(), 2u);
  EXPECT_EQ(read_csv("Name\nRidge\n", "tasks.csv").at(0).header.at(0), "Name");
}

TEST(Csv, without_text_is_told) {
  EXPECT_THROW(read_csv(";;\n;;\n", "tasks.csv"), InputError);
  EXPECT_THROW(read_csv(std::string("a\0b", 3), "tasks.csv"), InputError);
}

}  // namespace
}  // namespace lsos
