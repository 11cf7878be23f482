// Ways to a foreign file past GDAL's file systems: grids and inits of PROJ, servers that are files,
// and what libraries look up in the user's home.
#include "system/foreign_ground.h"

#include <gmock/gmock.h>

#include <fmt/format.h>
#include <filesystem>

#include "system/plan_text.h"
#include "system/process.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string plan_on(const std::string& terrain) {
  return kml(
      {{"MissionInfo", {{"Planet", "Moon"}, {"StartTime", "2026-07-01"}, {"Terrain", terrain}}, ""},
       sev("A", "31,20"),
       event("Pause", "A", 1, {{"Duration", "5 s"}})});
}

std::string vrt_in(const std::string& crs) {
  return fmt::format(
      "<VRTDataset rasterXSize='40' rasterYSize='40'><SRS>{}</SRS>"
      "<GeoTransform>30.98, 0.001, 0, 20.02, 0, -0.001</GeoTransform>"
      "<VRTRasterBand dataType='Float32' band='1'><SimpleSource>"
      "<SourceFilename relativeToVRT='1'>dem.asc</SourceFilename><SourceBand>1</SourceBand>"
      "</SimpleSource></VRTRasterBand></VRTDataset>",
      crs);
}

std::string warped_vrt(const std::string& from, const std::string& to,
                       const std::string& options = "") {
  return fmt::format(
      "<VRTDataset rasterXSize='40' rasterYSize='40' subClass='VRTWarpedDataset'><SRS>{0}</SRS>"
      "<GeoTransform>30.98, 0.001, 0, 20.02, 0, -0.001</GeoTransform><VRTRasterBand "
      "dataType='Float32' band='1' subClass='VRTWarpedRasterBand'/><GDALWarpOptions>"
      "<SourceDataset relativeToVRT='1'>dem.asc</SourceDataset><Transformer>"
      "<GenImgProjTransformer><SrcGeoTransform>30.98,0.001,0,20.02,0,-0.001</SrcGeoTransform>"
      "<SrcInvGeoTransform>-30980,1000,0,20020,0,-1000</SrcInvGeoTransform>"
      "<DstGeoTransform>30.98,0.001,0,20.02,0,-0.001</DstGeoTransform>"
      "<DstInvGeoTransform>-30980,1000,0,20020,0,-1000</DstInvGeoTransform>"
      "<ReprojectTransformer><ReprojectionTransformer><SourceSRS>{1}</SourceSRS>"
      "<TargetSRS>{2}</TargetSRS>{3}</ReprojectionTransformer></ReprojectTransformer>"
      "</GenImgProjTransformer></Transformer><BandList><BandMapping src='1' dst='1'/></BandList>"
      "</GDALWarpOptions></VRTDataset>",
      crs_of_moon, from, to, options);
}

// In WKT, as GDAL writes the +nadgrids of a PROJ string.
std::string wkt_with_grid(const std::string& grid) {
  std::string wkt = crs_of_moon;
  return wkt.insert(wkt.find("]],PRIMEM") + 1,
                    fmt::format(",EXTENSION[\"PROJ4_GRIDS\",\"{}\"]", grid));
}

struct Projection {
  std::string name;
  std::string (*ground)(const std::string& grid);  // contents of a VRT
};

class ForeignGrids : public ::testing::TestWithParam<Projection> {};

TEST_P(ForeignGrids, are_not_opened) {
  const TempFolder folder, elsewhere;
  write_raster(folder, "dem");
  const std::string grid = elsewhere.write("grid", "no grid");
  const Watched watched(grid);
  folder.write("ground.vrt", GetParam().ground(grid));
  const std::string plan = folder.write("plan.kml", plan_on("ground.vrt"));
  const Outcome outcome = run({"check", plan});
  EXPECT_NE(outcome.exit_code, 3) << outcome.err;
  EXPECT_FALSE(watched.was_opened()) << outcome.out << outcome.err;
}

const std::vector<Projection> projections = {
    {"of_a_crs",
     [](const std::string& grid) {
       return vrt_in("+proj=longlat +R=1737400 +nadgrids=" + grid + " +no_defs");
     }},
    {"of_a_crs_that_may_lack_them",
     [](const std::string& grid) {
       return vrt_in("+proj=longlat +R=1737400 +nadgrids=@" + grid + ",null +no_defs");
     }},
    {"of_an_init", [](const std::string& grid) { return vrt_in("+init=" + grid + ":x"); }},
    {"of_wkt", [](const std::string& grid) { return vrt_in(wkt_with_grid(grid)); }},
    {"of_a_warped_raster",
     [](const std::string& grid) {
       return warped_vrt("+proj=longlat +R=1737400 +nadgrids=" + grid + " +no_defs", crs_of_moon);
     }},
    {"of_a_warped_raster_in_wkt",
     [](const std::string& grid) { return warped_vrt(wkt_with_grid(grid), "EPSG:4326"); }},
    {"of_an_init_of_a_warped_raster",
     [](const std::string& grid) { return warped_vrt("+init=" + grid + ":x", crs_of_moon); }},
    {"of_an_operation",
     [](const std::string& grid) {
       return warped_vrt(crs_of_moon, crs_of_moon,
                         "<Options><Option key='COORDINATE_OPERATION'>+proj=pipeline +step "
                         "+proj=hgridshift +grids=" +
                             grid + "</Option></Options>");
     }},
};

INSTANTIATE_TEST_SUITE_P(, ForeignGrids, ::testing::ValuesIn(projections),
                         [](const auto& tested) { return tested.param.name; });

TEST(ForeignGrid, of_a_file_beside_a_raster_or_of_a_map_is_not_opened) {
  const TempFolder folder, elsewhere;
  const std::string grid = elsewhere.write("grid", "no grid");
  const Watched watched(grid);
  write_raster(folder, "dem");
  folder.write("dem.prj", wkt_with_grid(grid));
  run({"check", folder.write("plan.kml", plan_on("dem.asc"))});
  EXPECT_FALSE(watched.was_opened());
  folder.write(
      "map.geojson",
      "{\"type\":\"FeatureCollection\",\"crs\":{\"type\":\"name\",\"properties\":{\"name\":"
      "\"+proj=longlat +R=1737400 +nadgrids=" +
          grid +
          "\"}},\"features\":[{\"type\":"
          "\"Feature\",\"properties\":{\"Type\":\"Rover\",\"RoverId\":\"A\",\"RoverType\":"
          "\"SEV\"},\"geometry\":{\"type\":\"Point\",\"coordinates\":[31,20]}}]}");
  run({"import", folder / "map.geojson", "-o", folder / "map.kml"});
  EXPECT_FALSE(watched.was_opened());
}

TEST(ForeignGrid, is_opened_where_the_user_allows_its_folder) {
  const TempFolder folder, elsewhere;
  write_raster(folder, "dem");
  const std::string grid = elsewhere.write("grid", "no grid");
  const Watched watched(grid);
  folder.write("ground.vrt", vrt_in("+init=" + grid + ":x"));
  run({"check", folder.write("plan.kml", plan_on("ground.vrt")), "--allow-files",
       elsewhere.path()});
  EXPECT_TRUE(watched.was_opened());
}

std::string service_of(const std::string& server, const std::string& kind = "TMS") {
  return fmt::format(
      "<GDAL_WMS><Service name='{}'><ServerUrl>{}</ServerUrl></Service><DataWindow>"
      "<UpperLeftX>30.98</UpperLeftX><UpperLeftY>20.02</UpperLeftY><LowerRightX>31.02</LowerRightX>"
      "<LowerRightY>19.98</LowerRightY><TileLevel>0</TileLevel><TileCountX>1</TileCountX>"
      "<TileCountY>1</TileCountY></DataWindow><BlockSizeX>40</BlockSizeX><BlockSizeY>40</"
      "BlockSizeY>"
      "<Projection>IAU_2015:30100</Projection><BandsCount>1</BandsCount><DataType>Float32</"
      "DataType>"
      "</GDAL_WMS>",
      kind, server);
}

void expect_refused(const TempFolder& folder, const std::string& description) {
  folder.write("service.xml", description);
  const Outcome outcome =
      run({"check", folder.write("plan.kml", plan_on("service.xml")), "--allow-network"});
  EXPECT_EQ(outcome.exit_code, 2) << description;
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("names a service that is not opened"))
      << description;
}

TEST(ForeignFile, is_no_server_of_tiles) {
  const TempFolder folder, elsewhere;
  const std::string tile = elsewhere.write("tile", "no tile");
  const Watched watched(tile);
  for (const std::string& description :
       {service_of("file://" + tile), service_of("f&#105;le://" + tile),
        service_of("<![CDATA[ file://" + tile + "]]>"), service_of(tile),
        service_of("FILE://" + tile), service_of("file://" + tile, "TiledWMS")}) {
    expect_refused(folder, description);
    EXPECT_FALSE(watched.was_opened()) << description;
  }
}

// GDAL takes attributes for elements.
TEST(ForeignFile, is_no_server_of_tiles_in_an_attribute) {
  const TempFolder folder, elsewhere;
  const std::string tile = elsewhere.write("tile", "no tile");
  const Watched watched(tile);
  const std::string element = fmt::format("<Service name='TMS'><ServerUrl>file://{}", tile);
  for (const std::string& service :
       {fmt::format("<Service name='TMS' ServerUrl='file://{}'><x>", tile),
        fmt::format("<Service name='TMS' SERVERURL='file://{}'><x>", tile),
        fmt::format("<Service name='TMS' serverurl=' file://{}'><ServerUrl>http://x/", tile)}) {
    std::string description = service_of("file://" + tile);
    const bool has_url = service.ends_with("http://x/");
    if (!has_url) {
      const std::size_t end = description.find("</ServerUrl>");
      description.replace(end, 12, "</x>");
    }
    description.replace(description.find(element), element.size(), service);
    expect_refused(folder, description);
    EXPECT_FALSE(watched.was_opened()) << description;
  }
}

// GDAL removes old files of a cache, whatever they are.
TEST(ForeignFile, is_in_no_cache_of_a_service) {
  const TempFolder folder;
  const Listener listener;
  const std::string server = fmt::format("http://127.0.0.1:{}/", listener.port());
  for (const char* cache :
       {"<Cache><Path>.</Path><Expires>0</Expires></Cache>", "<Cache path='.' Expires='0'/>"}) {
    std::string description = service_of(server);
    description.insert(description.find("<DataWindow>"), cache);
    folder.write("service.xml", description);
    const Outcome outcome =
        run({"check", folder.write("plan.kml", plan_on("service.xml")), "--allow-network"},
            {.folder = folder.path()});
    EXPECT_EQ(outcome.exit_code, 2) << description;
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("and no Path of a cache")) << description;
  }
  EXPECT_EQ(listener.calls(), 0);
}

TEST(ForeignFile, is_named_by_no_service_that_describes_itself) {
  const TempFolder folder;
  const Listener listener;
  const std::string server = fmt::format("http://127.0.0.1:{}/", listener.port());
  for (const std::string& name :
       {"WMTS:" + server, "WCS:" + server, "WMS:" + server + "?request=GetMap"}) {
    const Outcome outcome = run({"terrain", name, "--at", "31,20", "--allow-network"});
    EXPECT_EQ(outcome.exit_code, 2) << name << outcome.out;
  }
  EXPECT_EQ(listener.calls(), 0);
}

// What libraries look up in the user's home is no business of a plan's server.
TEST(Credentials, of_the_user_are_not_read_for_a_plan) {
  const TempFolder folder, home;
  const Listener listener;
  const Watched netrc(home.write(".netrc", "default login user password secret\n"));
  const Watched amazon(
      home.write(".aws/credentials", "[default]\naws_access_key_id=A\naws_secret_access_key=S\n"));
  const std::string server = fmt::format("127.0.0.1:{}", listener.port());
  const Words environment{"HOME=" + home.path().string(), "AWS_S3_ENDPOINT=" + server,
                          "AWS_HTTPS=NO"};
  for (const std::string& raster :
       {"/vsicurl/http://" + server + "/dem.tif", std::string("/vsis3/bucket/dem.tif")}) {
    run({"check", folder.write("plan.kml", plan_on(raster)), "--allow-network"},
        {.environment = environment});
    EXPECT_FALSE(netrc.was_opened()) << raster;
    EXPECT_FALSE(amazon.was_opened()) << raster;
  }
  EXPECT_GT(listener.calls(), 0);
  Words with_names = environment;
  with_names.emplace_back("GDAL_HTTP_NETRC=YES");
  run({"check", folder.write("plan.kml", plan_on("/vsicurl/http://" + server + "/dem.tif")),
       "--allow-network"},
      {.environment = with_names});
  EXPECT_TRUE(netrc.was_opened());
}

}  // namespace
}  // namespace lsos::test
