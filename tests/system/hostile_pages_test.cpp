// What people read of a plan is text: in pages, balloons and tables none of it is markup or a
// formula.
#include <gmock/gmock.h>
#include <tinyxml2.h>

#include <nlohmann/json.hpp>

#include "system/browser.h"
#include "system/hostile_plan.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

class HostilePages : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TempFolder;
    plan_ = write_hostile_plan(*folder_);
    const Outcome outcome = run({plan_, "-o", *folder_ / "run", "--quiet"});
    ASSERT_EQ(outcome.exit_code, 1) << outcome.err;
  }
  static void TearDownTestSuite() { delete folder_; }
  void SetUp() override {
    if (browser().empty()) GTEST_SKIP() << "no Chromium";
  }

  // Opens a page, waits for what its markup would do, and clicks all that can be clicked.
  static nlohmann::json hacked(const std::string& page) {
    return in_browser(*folder_, page, R"js(
      for (const element of document.querySelectorAll('button, tr, summary, .surface')) {
        element.dispatchEvent(new MouseEvent('click', {bubbles: true}));
      }
      await rest(); await rest();
      return {hacked: typeof hacked !== 'undefined' || typeof window.hacked !== 'undefined',
              images: document.querySelectorAll('img[onerror], img[src="x"]').length,
              text: document.body.textContent.includes('<scr' + 'ipt>hacked=1')};
    )js");
  }

  static inline TempFolder* folder_ = nullptr;
  static inline std::string plan_;
};

// All that the Placemarks and Folders of a KML file say in their balloons, as a viewer puts it
// into a page.
std::string balloons_of(const std::string& kml_file) {
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.LoadFile(kml_file.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  std::string page = "<!doctype html><html><head><meta charset=\"utf-8\"></head><body>";
  const auto add = [&](const auto& self, const tinyxml2::XMLElement* element) -> void {
    for (; element != nullptr; element = element->NextSiblingElement()) {
      const bool is_balloon = std::string(element->Name()) == "description";
      if (is_balloon && element->GetText() != nullptr) {
        page += "<div>" + std::string(element->GetText()) + "</div>";
      }
      self(self, element->FirstChildElement());
    }
  };
  add(add, document.RootElement());
  return page + "</body></html>";
}

TEST_F(HostilePages, run_no_script_in_a_report) {
  const nlohmann::json seen = hacked(*folder_ / "run/report.html");
  EXPECT_FALSE(seen.value("hacked", true)) << seen;
  EXPECT_EQ(seen.value("images", -1), 0) << seen;
  EXPECT_TRUE(seen.value("text", false)) << seen;
}

TEST_F(HostilePages, run_no_script_in_a_page_of_several_runs) {
  const Outcome outcome =
      run({"report", *folder_ / "run", *folder_ / "run", "-o", *folder_ / "both.html"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const nlohmann::json seen = hacked(*folder_ / "both.html");
  EXPECT_FALSE(seen.value("hacked", true)) << seen;
  EXPECT_EQ(seen.value("images", -1), 0) << seen;
}

TEST_F(HostilePages, run_no_script_in_balloons_of_an_overlay) {
  const std::string page = balloons_of(*folder_ / "run/overlay.kml");
  const nlohmann::json seen = hacked(folder_->write("balloons.html", page));
  EXPECT_FALSE(seen.value("hacked", true)) << seen;
  EXPECT_EQ(seen.value("images", -1), 0) << seen;
  EXPECT_TRUE(seen.value("text", false)) << seen;
}

TEST_F(HostilePages, run_no_script_in_balloons_of_an_annotated_or_imported_plan) {
  // A stranger's own descriptions stay in a copy of his plan; those of ours are looked at.
  std::string plan = read_text(plan_);
  plan.erase(plan.find("<Folder>"), plan.find("</Folder>") + 9 - plan.find("<Folder>"));
  // An editor of XML takes no control characters, in whatever way they are said.
  for (std::size_t at = 0; (at = plan.find("&#", at)) != std::string::npos;) {
    const int code = std::stoi(plan.substr(at + 2));
    plan.erase(at, plan.find(';', at) + 1 - at);
    if (code >= 0x20 && code != 0x7f) {
      plan.insert(at, code == '<'   ? "&lt;"
                      : code == '>' ? "&gt;"
                      : code == '&' ? "&amp;"
                                    : "&quot;");
      ++at;
    }
  }
  folder_->write("plain.kml", plan);
  const std::string annotated = *folder_ / "annotated.kml";
  const Outcome checked = run({"check", *folder_ / "plain.kml", "--kml", annotated});
  ASSERT_EQ(checked.exit_code, 0) << checked.out << checked.err;
  const std::string sheet = folder_->write("<script>hacked=1<!--.csv",
                                           "Type,RoverId,RoverType,Lon,Lat\nRover,A,SEV,0,0\n");
  const std::string imported = *folder_ / "imported.kml";
  ASSERT_THAT(run({"import", sheet, "--planet", "Moon", "--start", "2026-01-01", "--terrain",
                   "Flat", "-o", imported})
                  .exit_code,
              AnyOf(0, 2));
  for (const std::string& file : {annotated, imported}) {
    if (!std::filesystem::exists(file)) continue;
    const nlohmann::json seen = hacked(folder_->write("balloons.html", balloons_of(file)));
    EXPECT_FALSE(seen.value("hacked", true)) << file << seen;
    EXPECT_EQ(seen.value("images", -1), 0) << file << seen;
  }
}

TEST_F(HostilePages, are_xml_and_json_that_others_read) {
  for (const std::string file : {"overlay.kml"}) {
    EXPECT_EQ(run_command({"xmllint", "--noout", *folder_ / "run" / file}).exit_code, 0) << file;
  }
  ASSERT_EQ(run_command({"unzip", "-o", "-q", *folder_ / "run/mission.qgz", "-d", *folder_ / "qgz"})
                .exit_code,
            0);
  EXPECT_EQ(run_command({"xmllint", "--noout", "--nonet", *folder_ / "qgz/mission.qgs"}).exit_code,
            0);
  EXPECT_FALSE(nlohmann::json::parse(read_text(*folder_ / "run/summary.json"), nullptr, false)
                   .is_discarded());
  const Outcome dot = run({"fsm", plan_});
  folder_->write("machine.dot", dot.out);
  EXPECT_EQ(run_command({"dot", "-Tsvg", *folder_ / "machine.dot", "-o", *folder_ / "machine.svg"})
                .exit_code,
            0);
  EXPECT_EQ(run_command({"xmllint", "--noout", *folder_ / "machine.svg"}).exit_code, 0);
}

TEST_F(HostilePages, are_tables_without_formulas_that_come_back) {
  std::vector<Mark> marks{mission(), sev("A", "0,0")};
  int sequence = 10;
  for (const char* label : {"=HYPERLINK(&quot;http://x&quot;)", "+cmd|' /C calc'!A0", "-2+3",
                            "@SUM(1)", "'=1", "of:=1+1", "=1"}) {
    marks.push_back(event("Pause", "A", sequence += 10, {{"Duration", "5 s"}}));
    marks.back().name = label;
  }
  const std::string plan = folder_->write("formulas.kml", kml(marks));
  const auto hash_of = [&](const std::string& file) {
    const Outcome outcome = run({"check", file, "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    return nlohmann::json::parse(outcome.out)["plan_sha256"].get<std::string>();
  };
  const std::string before = hash_of(plan);
  for (const std::string ending : {"csv", "xlsx", "ods", "geojson", "gpkg"}) {
    const std::string sheet = *folder_ / ("formulas." + ending),
                      back = *folder_ / (ending + ".kml");
    ASSERT_EQ(run({"export", plan, "-o", sheet}).exit_code, 0) << ending;
    const Outcome imported = run({"import", sheet, "-o", back});
    ASSERT_EQ(imported.exit_code, 0) << ending << imported.err;
    EXPECT_EQ(hash_of(back), before) << ending;
  }
  const std::string csv = read_text(*folder_ / "formulas.csv");
  for (const char* cell :
       {"\"'=HYPERLINK(\"\"http://x\"\")\"", "'@SUM(1)", "''=1", "'+cmd|' /C calc'!A0"}) {
    EXPECT_THAT(csv, HasSubstr(cell));
  }
  // A workbook says what a formula is; none of the cells is one.
  run_command({"unzip", "-o", "-q", *folder_ / "formulas.ods", "-d", *folder_ / "ods"});
  EXPECT_EQ(read_text(*folder_ / "ods/content.xml").find("table:formula"), std::string::npos);
  run_command({"unzip", "-o", "-q", *folder_ / "formulas.xlsx", "-d", *folder_ / "xlsx"});
  for (const auto& sheet : std::filesystem::directory_iterator(*folder_ / "xlsx/xl/worksheets")) {
    if (sheet.is_regular_file()) {
      EXPECT_EQ(read_text(sheet.path()).find("<f>"), std::string::npos) << sheet.path();
    }
  }
}

}  // namespace
}  // namespace lsos::test
