// Plans, logs, projects and overlays in other programs' viewers, QGIS and CesiumJS. The tests are
// skipped when `script/bootstrap long` has not installed them.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "system/browser.h"
#include "system/run_folder.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const Surroundings screenless{.environment = {"QT_QPA_PLATFORM=offscreen"}};

TEST(Qgis, draws_plans_and_opens_the_project_of_a_run) {
  // Debian's Python has QGIS; another one may come first in PATH.
  const std::string python = "/usr/bin/python3";
  if (run_command({python, "-c", "import qgis.core"}, screenless).exit_code != 0) {
    GTEST_SKIP() << "QGIS is not installed: script/bootstrap long";
  }
  const TempFolder folder;
  ASSERT_EQ(run({"schema", "-o", folder / "form.gpkg"}).exit_code, 0);
  ASSERT_EQ(run({repository() / "plans/two_rovers.kml", "-o", folder / "run", "--quiet"}).exit_code,
            0);
  const Outcome outcome = run_command(
      {python, repository() / "tests/system/qgis_viewer.py", folder / "form.gpkg", folder / "run"},
      screenless);
  const json seen = json::parse(outcome.out, nullptr, false);
  ASSERT_TRUE(seen.is_object()) << outcome.out << outcome.err;
  EXPECT_EQ(seen["sequences"], json({10, 20, 30, 40}));
  EXPECT_EQ(seen["tabs"], json({"What", "When, and if it fails"}));
  EXPECT_EQ(seen["is_read"], true);
  for (const char* layer : {"Samples", "Events", "Planned paths", "SEV1 drawn", "SEV2 drawn"}) {
    EXPECT_EQ(seen["layers"][layer]["is_valid"], true) << layer;
    EXPECT_EQ(seen["layers"][layer]["crs"], "IAU_2015:30100") << layer;
  }
  EXPECT_EQ(seen["layers"]["Hillshade"]["is_valid"], true);
  for (const char* layer : {"Samples", "Events"}) {
    EXPECT_EQ(seen["layers"][layer]["is_temporal"], true) << layer;
  }
  EXPECT_EQ(seen["step_s"], 30);
  EXPECT_EQ(seen["begin"], "2026-01-02T00:00:00Z");
  EXPECT_GT(seen["colours"], 50) << "a hillshade and what lies on it";
}

TEST(Cesium, reads_an_overlay_without_a_warning) {
  if (browser().empty()) GTEST_SKIP() << "no Chromium is installed";
  const fs::path cesium = repository() / "build/viewers/node_modules/cesium/Build/Cesium";
  if (!fs::exists(cesium)) GTEST_SKIP() << "CesiumJS is not installed: script/bootstrap long";
  const TempFolder folder;
  ASSERT_EQ(
      run({repository() / "plans/two_rovers.kml", "-o", folder / "run", "--quiet", "--no-report"})
          .exit_code,
      0);
  std::string overlay = read_text(folder / "run/overlay.kml");
  for (std::size_t at = 0; (at = overlay.find("</script", at)) != std::string::npos; at += 9) {
    overlay.insert(at + 1, "\\");
  }
  const std::string page =
      folder.write("page.html",
                   "<!doctype html><html><head><meta charset=\"utf-8\"><script>window.told = []; "
                   "console.warn = (...words) => told.push(words.join(' '));</script>"
                   "<script src=\"file://" +
                       (cesium / "Cesium.js").string() +
                       "\"></script></head><body><script type=\"text/plain\" id=\"kml\">" +
                       overlay + "</script></body></html>");
  const json seen = in_browser(folder, page, R"js(
    const moon = Cesium.Ellipsoid.MOON;
    Cesium.Ellipsoid.default = moon;
    const text = document.getElementById('kml').textContent;
    const source = await Cesium.KmlDataSource.load(new Blob([text]),
      {ellipsoid: moon});
    const all = source.entities.values;
    const end = Cesium.JulianDate.fromIso8601('2026-01-02T01:00:00Z');
    return {told, name: source.name, lines: all.filter(e => e.polyline).length,
            icons: all.filter(e => e.billboard).length, tracks: all.filter(e => e.path).length,
            balloons: all.filter(e => (e.description?.getValue(end) || '').includes('<table')).length};
  )js");
  ASSERT_FALSE(seen.contains("error")) << seen;
  // Balloons show their own HTML; Cesium reads values from Data only, not from SchemaData.
  EXPECT_EQ(seen["told"], json({"KML - SchemaData is unsupported"}));
  EXPECT_THAT(seen["name"].get<std::string>(), ::testing::HasSubstr("two_rovers"));
  EXPECT_GE(seen["lines"], 6);
  EXPECT_GT(seen["icons"], 50);
  EXPECT_EQ(seen["tracks"], 2);
  EXPECT_GT(seen["balloons"], 50);
}

}  // namespace
}  // namespace lsos::test
