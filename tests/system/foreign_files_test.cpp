// What a plan from elsewhere may open: nothing beyond its folder, and no connection, unless the
// user says so.
#include <gmock/gmock.h>

#include <fmt/format.h>
#include <filesystem>

#include "system/foreign_ground.h"
#include "system/plan_text.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string vrt_of(const std::string& source) {
  return fmt::format(
      "<VRTDataset rasterXSize='40' rasterYSize='40'><SRS>{}</SRS>"
      "<GeoTransform>30.98, 0.001, 0, 20.02, 0, -0.001</GeoTransform>"
      "<VRTRasterBand dataType='Float32' band='1'><SimpleSource>"
      "<SourceFilename relativeToVRT='{}'>{}</SourceFilename><SourceBand>1</SourceBand>"
      "</SimpleSource></VRTRasterBand></VRTDataset>",
      crs_of_moon, source.find_first_of("/<") == 0 ? 0 : 1, source);
}

std::string plan_on(const std::string& terrain) {
  return kml(
      {{"MissionInfo", {{"Planet", "Moon"}, {"StartTime", "2026-07-01"}, {"Terrain", terrain}}, ""},
       sev("A", "31,20"),
       event("Pause", "A", 1, {{"Duration", "5 s"}})});
}

std::string script_of(const std::string& raster) {
  return "local lsos = require 'lsos'\nreturn lsos.terrain { api = 1, doc = 'Level ground.', "
         "planet = "
         "'Moon', soil = 'ApolloDense', surface = lsos.raster " +
         raster + " }\n";
}

struct ForeignFile {
  std::string name;      // of the case
  std::string terrain;   // as the plan names it; {} is the foreign folder
  std::string contents;  // of the file that the plan names, "" where it is the foreign one
};

// Each "{}" replaced.
std::string filled(std::string text, const std::string& value) {
  for (std::size_t at = 0; (at = text.find("{}", at)) != std::string::npos;) {
    text.replace(at, 2, value);
  }
  return text;
}

// Writes what a case names, a script or a file, and returns the plan's Terrain.
std::string write_terrain(const TempFolder& folder, const ForeignFile& of,
                          const std::string& value) {
  std::string terrain = filled(of.terrain, value);
  if (of.contents.empty()) return terrain;
  const std::string contents = filled(of.contents, value);
  const bool is_script = terrain.find_first_of("./") == std::string::npos;
  folder.write(is_script ? "terrain/" + terrain + ".lua" : terrain,
               is_script ? script_of(contents) : contents);
  return terrain;
}

class ForeignFiles : public ::testing::TestWithParam<ForeignFile> {};

TEST_P(ForeignFiles, are_not_opened_unless_the_user_allows_them) {
  const TempFolder folder, elsewhere;
  write_raster(elsewhere, "dem");
  const Watched watched(elsewhere / "dem.asc");
  const std::string terrain = write_terrain(folder, GetParam(), elsewhere.path());
  fs::create_symlink(elsewhere / "dem.asc", folder / "linked.asc");
  fs::create_symlink(elsewhere / "dem.prj", folder / "linked.prj");
  fs::create_directory_symlink(elsewhere.path(), folder / "maps");
  const std::string plan = folder.write("plan.kml", plan_on(terrain));

  const Outcome refused = run({"check", plan});
  EXPECT_EQ(refused.exit_code, 2) << refused.out << refused.err;
  EXPECT_THAT(refused.out + refused.err, HasSubstr("lies outside the plan's folder"));
  EXPECT_THAT(refused.out + refused.err, HasSubstr("--allow-files '"));
  EXPECT_FALSE(watched.was_opened());

  const Outcome allowed = run({"check", plan, "--allow-files", elsewhere.path()});
  EXPECT_EQ(allowed.exit_code, 0) << allowed.out << allowed.err;
  EXPECT_TRUE(watched.was_opened());
  const Outcome by_variable =
      run({"check", plan}, {.environment = {"LSOS_ALLOW_FILES=/usr:" + elsewhere.path().string()}});
  EXPECT_EQ(by_variable.exit_code, 0) << by_variable.out << by_variable.err;
}

const std::vector<ForeignFile> foreign_files = {
    {"by_its_path", "{}/dem.asc", ""},
    {"through_a_link", "linked.asc", ""},
    {"through_a_linked_folder", "maps/dem.asc", ""},
    {"in_a_vrt", "ground.vrt", vrt_of("{}/dem.asc")},
    {"in_a_vrt_through_a_link", "ground.vrt", vrt_of("maps/dem.asc")},
    {"in_a_vrt_with_bytes_of_a_file", "ground.vrt", vrt_of("/vsisubfile/0,{}/dem.asc")},
    {"in_a_script", "Ground", "{ file = '{}/dem.asc' }"},
    {"in_a_script_with_bytes_of_a_file", "Ground",
     "{ file = '/vsisubfile/0,{}/dem.asc', crs = 'IAU_2015:30100' }"},
};

INSTANTIATE_TEST_SUITE_P(, ForeignFiles, ::testing::ValuesIn(foreign_files),
                         [](const auto& tested) { return tested.param.name; });

// Whether `check` refuses a plan on ground of that VRT, and opens the watched file.
void expect_refused(const TempFolder& folder, const std::string& vrt, const Watched& watched,
                    const Words& options = {}) {
  folder.write("ground.vrt", vrt);
  Words words{"check", folder.write("plan.kml", plan_on("ground.vrt"))};
  words.insert(words.end(), options.begin(), options.end());
  const Outcome outcome = run(words, {.folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 2) << vrt << outcome.out;
  EXPECT_FALSE(watched.was_opened()) << vrt;
}

TEST(ForeignFile, is_not_reached_by_libraries_that_open_files_themselves) {
  const TempFolder folder, elsewhere;
  const std::string database = elsewhere / "maps.gpkg", made = elsewhere / "made.db";
  ASSERT_EQ(run_command({"sqlite3", database, "create table t (a)"}).exit_code, 0);
  ASSERT_EQ(run_command({"sqlite3", folder / "own.gpkg", "create table t (a)"}).exit_code, 0);
  const Watched watched(database);
  for (const std::string& name :
       {fmt::format("GPKG:{}:t", database),
        fmt::format("GPKG:\"{}/\"../{}:t", folder.path().string(),
                    fs::relative(database, folder.path().parent_path()).string()),
        fmt::format("GPKG:\"file:{}?x=1\":t", database), fmt::format("NETCDF:\"{}\":t", database),
        fmt::format("SQLITE:{}", database)}) {
    expect_refused(folder, vrt_of(name), watched);
  }
  for (const std::string& statement : {fmt::format("ATTACH DATABASE '{}' AS x", database),
                                       fmt::format("VACUUM INTO '{}'", made)}) {
    std::string vrt = vrt_of("own.gpkg");
    vrt.insert(vrt.find("<SourceBand>"),
               fmt::format("<OpenOptions><OOI key='PRELUDE_STATEMENTS'>{}</OOI></OpenOptions>",
                           statement));
    expect_refused(folder, vrt, watched);
  }
  EXPECT_FALSE(fs::exists(made));
}

TEST(ForeignFile, is_no_address_of_the_network) {
  const TempFolder folder, elsewhere;
  write_raster(elsewhere, "dem");
  const Watched watched(elsewhere / "dem.asc");
  for (const char* prefix :
       {"/vsicurl/file://", "/vsicurl/FILE%3A//", "/vsicurl_streaming/file://"}) {
    expect_refused(folder, vrt_of(prefix + (elsewhere / "dem.asc").string()), watched,
                   {"--allow-network"});
  }
}

TEST(ForeignFile, in_an_archive_is_named_by_the_user_or_refused_by_name) {
  const TempFolder folder, elsewhere;
  write_raster(elsewhere, "dem");
  ASSERT_EQ(run_command(
                {"tar", "-C", elsewhere.path(), "-cf", elsewhere / "all.tar", "dem.asc", "dem.prj"})
                .exit_code,
            0);
  const std::string name = fmt::format("/vsitar/{}/dem.asc", (elsewhere / "all.tar").string());
  const Outcome named = run({"terrain", name, "--at", "31,20"});
  EXPECT_EQ(named.exit_code, 0) << named.out << named.err;
  const Outcome refused = run({"check", folder.write("plan.kml", plan_on(name))});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.out + refused.err,
              HasSubstr("--allow-files '" + elsewhere.path().string() + "'"));
}

TEST(ForeignFile, is_the_users_in_the_working_folder) {
  const TempFolder folder;
  write_raster(folder, "dem");
  folder.write("terrain/Ground.lua", script_of("{ file = '../dem.asc' }"));
  for (const std::string terrain : {"dem.asc", "Ground"}) {
    const Outcome outcome = run({"new", "plan", terrain == "Ground" ? "by_script" : "by_file",
                                 "--terrain", terrain, "--site", "31,20"},
                                {.folder = folder.path()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  }
}

TEST(ForeignFile, that_is_no_raster_is_not_even_read) {
  const TempFolder folder, elsewhere;
  const Watched watched(elsewhere.write("passwd", "root:x:0:0\n"));
  for (const std::string& terrain :
       {(elsewhere / "passwd").string(), fmt::format("GPKG:{}:t", (elsewhere / "passwd").string()),
        fmt::format("NETCDF:{}:z", (elsewhere / "passwd").string())}) {
    folder.write("terrain/Ground.lua", script_of(fmt::format("{{ file = '{}' }}", terrain)));
    const std::string plan = folder.write("plan.kml", plan_on("Ground"));
    const Outcome outcome = run({"check", plan});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_FALSE(watched.was_opened()) << terrain;
  }
}

TEST(ForeignFile, is_named_by_the_user_on_the_command_line) {
  const TempFolder elsewhere;
  write_raster(elsewhere, "dem");
  elsewhere.write("all.vrt", vrt_of("dem.asc"));
  for (const char* name : {"dem.asc", "all.vrt"}) {
    const Outcome outcome =
        run({"terrain", elsewhere / name, "--at", "31,20"}, {.folder = fs::temp_directory_path()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  }
}

TEST(ForeignFile, that_projections_would_read_is_refused) {
  const TempFolder elsewhere;
  write_raster(elsewhere, "dem");
  const Watched watched(elsewhere.write("grid", "no grid"));
  const Outcome outcome =
      run({"terrain", elsewhere / "dem.asc", "--at", "31,20", "--crs",
           fmt::format("+proj=longlat +R=1737400 +nadgrids={}", (elsewhere / "grid").string())});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err + outcome.out, HasSubstr("reads a file of its own"));
  EXPECT_FALSE(watched.was_opened());
}

TEST(ForeignFile, of_a_run_stays_readable_where_the_plan_lies_beside_it) {
  const TempFolder folder, output;
  write_raster(folder, "dem");
  const std::string plan = folder.write("plan.kml", plan_on("dem.asc"));
  const std::string out = output / "run";
  ASSERT_EQ(run({plan, "-o", out, "--quiet"}).exit_code, 0);
  for (const std::string command : {"report", "overlay"}) {
    const Outcome outcome = run({command, out, "--quiet"}, {.folder = output.path()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.err.find("allow-files"), std::string::npos) << outcome.err;
  }
}

class Connections : public ::testing::TestWithParam<ForeignFile> {};

TEST_P(Connections, are_not_made_unless_the_user_allows_them) {
  const TempFolder folder;
  const Listener listener;
  const std::string server = fmt::format("127.0.0.1:{}", listener.port());
  const std::string terrain = write_terrain(folder, GetParam(), server);
  write_raster(folder, "dem");
  folder.write(
      "service.xml",
      filled("<GDAL_WMS><Service name='TMS'><ServerUrl>http://{}/${z}</ServerUrl></Service>"
             "<DataWindow><UpperLeftX>30.98</UpperLeftX><UpperLeftY>20.02</UpperLeftY>"
             "<LowerRightX>31.02</LowerRightX><LowerRightY>19.98</LowerRightY>"
             "<TileLevel>0</TileLevel><TileCountX>1</TileCountX><TileCountY>1</TileCountY>"
             "</DataWindow><BlockSizeX>40</BlockSizeX><BlockSizeY>40</BlockSizeY>"
             "<Projection>IAU_2015:30100</Projection><BandsCount>1</BandsCount>"
             "<DataType>Float32</DataType></GDAL_WMS>",
             server));
  const std::string plan = folder.write("plan.kml", plan_on(terrain));
  const Surroundings where{.environment = {"PROJ_NETWORK=ON"}};

  const Outcome refused = run({"check", plan}, where);
  EXPECT_EQ(refused.exit_code, 2) << refused.out << refused.err;
  EXPECT_EQ(listener.calls(), 0);
  if (GetParam().name.starts_with("database")) return;  // no driver, whatever the user says
  EXPECT_THAT(refused.out + refused.err, HasSubstr("--allow-network"));
  run({"check", plan, "--allow-network"}, where);
  EXPECT_GT(listener.calls(), 0);
}

const std::vector<ForeignFile> connections = {
    {"for_a_raster", "/vsicurl/http://{}/dem.tif", ""},
    {"for_a_streamed_raster", "/vsicurl_streaming/http://{}/dem.tif", ""},
    {"for_a_file_in_an_archive", "/vsizip//vsicurl/http://{}/dem.zip/dem.tif", ""},
    {"for_a_script_s_raster", "Ground", "{ file = '/vsicurl/http://{}/dem.tif' }"},
    {"for_a_source_of_a_vrt", "ground.vrt", vrt_of("/vsicurl/http://{}/dem.tif")},
    {"for_a_service", "service.xml", ""},
    {"for_a_service_in_a_vrt", "ground.vrt", vrt_of("service.xml")},
    {"for_a_crs_of_a_warped_vrt", "ground.vrt",
     "<VRTDataset rasterXSize='40' rasterYSize='40' "
     "subClass='VRTWarpedDataset'><SRS>EPSG:4326</SRS>"
     "<GeoTransform>30.98, 0.001, 0, 20.02, 0, -0.001</GeoTransform><VRTRasterBand "
     "dataType='Float32' "
     "band='1' subClass='VRTWarpedRasterBand'/><GDALWarpOptions><SourceDataset relativeToVRT='1'>"
     "dem.asc</"
     "SourceDataset><Transformer><GenImgProjTransformer><SrcGeoTransform>30.98,0.001,0,20.02,"
     "0,-0.001</SrcGeoTransform><DstGeoTransform>30.98,0.001,0,20.02,0,-0.001</DstGeoTransform>"
     "<ReprojectTransformer><ReprojectionTransformer><SourceSRS>http://{}/srs</SourceSRS>"
     "<TargetSRS>EPSG:4326</TargetSRS></ReprojectionTransformer></ReprojectTransformer>"
     "</GenImgProjTransformer></Transformer><BandList><BandMapping src='1' dst='1'/></BandList>"
     "</GDALWarpOptions></VRTDataset>"},
    {"for_a_crs", "Ground", "{ file = '../dem.asc', crs = 'http://{}/crs' }"},
    {"database", "Ground", "{ file = 'PG:host={} dbname=x' }"},
};

INSTANTIATE_TEST_SUITE_P(, Connections, ::testing::ValuesIn(connections),
                         [](const auto& tested) { return tested.param.name; });

TEST(AllowedFolder, that_does_not_exist_is_a_mistake) {
  const Outcome outcome = run({"list", "events", "--allow-files", "/no/such/folder"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err + outcome.out,
              HasSubstr("--allow-files: there is no folder '/no/such/folder'"));
}

}  // namespace
}  // namespace lsos::test
