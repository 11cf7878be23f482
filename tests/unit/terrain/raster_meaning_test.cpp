// Meaning of a raster's samples, and the questions where that cannot be known.
#include <cmath>

#include "ground_fixture.h"
#include "terrain/raster/raster_reader.h"

namespace lsos {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr char moon_crs[] = "+proj=laea +lat_0=0 +lon_0=0 +R=1737400 +units=m";
constexpr char transform[] = "-10, 1, 0, 10, 0, -1";
const Geodetic cell_10_9{0.5 / 1737400, 0.5 / 1737400, 0};

std::vector<std::vector<double>> samples(double value) {
  return rows_of(20, 20, [=](int, int) { return value; });
}

RasterSurface raster(const std::string& name, const std::vector<std::vector<double>>& rows,
                     const std::string& band = "", const std::string& type = "Float64") {
  const std::string file = TextRaster{moon_crs, transform, band, rows}.write(name);
  std::string text;
  std::getline(std::ifstream(file), text, '\0');
  const std::string was = "dataType='Float64'";
  text.replace(text.find(was), was.size(), "dataType='" + type + "'");
  std::ofstream(file) << text;
  return {file};
}

std::optional<double> read_height_m(const RasterSurface& surface) {
  return RasterReader(surface, {"x.lua", 1}).at(cell_10_9)->height_m;
}

std::string refusal_of_surface(const RasterSurface& surface) {
  try {
    const RasterReader reader(surface, {"x.lua", 1});
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

double lone_height_m(double sample, const std::string& band) {
  static int number = 0;
  return read_height_m(raster("r" + std::to_string(++number), samples(sample), band)).value();
}

TEST(RasterUnit, of_the_file_is_known_by_many_names) {
  EXPECT_NEAR(lone_height_m(2, "<UnitType>Kilometers</UnitType>"), 2000, 1e-9);
  EXPECT_NEAR(lone_height_m(100, "<UnitType>ft</UnitType>"), 30.48, 1e-12);
  EXPECT_NEAR(lone_height_m(100, "<UnitType>US survey foot</UnitType>"), 30.480060960121922, 1e-12);
  EXPECT_NEAR(lone_height_m(250, "<UnitType>cm</UnitType>"), 2.5, 1e-12);
  EXPECT_NEAR(lone_height_m(25, "<UnitType>METER</UnitType>"), 25, 1e-12);
  EXPECT_NEAR(lone_height_m(25, "<UnitType>unknown</UnitType>"), 25, 1e-12);
}

TEST(RasterUnit, may_be_said_instead) {
  RasterSurface surface = raster("r", samples(100), "<UnitType>m</UnitType>");
  surface.unit = "ft";
  EXPECT_NEAR(*read_height_m(surface), 30.48, 1e-12);
  surface.unit = "feat";
  EXPECT_THAT(refusal_of_surface(surface),
              AllOf(HasSubstr("x.lua:1: raster '" + surface.file + "' is said to be in 'feat', "),
                    HasSubstr("no unit of length: m, km, dm, cm, mm, ft, us-ft are allowed"),
                    HasSubstr("unit in lsos.raster, or --unit"), HasSubstr("did you mean 'ft'?")));
}

TEST(RasterUnit, of_a_band_that_is_no_height_is_refused) {
  EXPECT_THAT(refusal_of_surface(raster("r", samples(10), "<UnitType>degree</UnitType>")),
              AllOf(HasSubstr("has a band 1 in 'degree', which is no unit of length"),
                    HasSubstr("choose another band")));
}

TEST(RasterRadii, show_in_the_offset_or_in_the_samples_and_in_kilometres_too) {
  EXPECT_NEAR(lone_height_m(182, "<Scale>0.5</Scale><Offset>1737400</Offset>"), 91, 1e-9);
  EXPECT_NEAR(lone_height_m(-1.25, "<Offset>1737.4</Offset>"), -1250, 1e-6);
  EXPECT_NEAR(lone_height_m(1736150, ""), -1250, 1e-9);
  EXPECT_NEAR(lone_height_m(1736.15, "<UnitType>km</UnitType>"), -1250, 1e-6);
}

TEST(RasterRadii, may_be_said_or_denied) {
  RasterSurface surface = raster("r", samples(1736150));
  surface.is_radius = true;
  EXPECT_NEAR(*read_height_m(surface), -1250, 1e-9);
  surface.is_radius = false;
  EXPECT_THAT(refusal_of_surface(surface), HasSubstr("no ground of Moon is farther than 25000 m"));
}

TEST(RasterRadii, in_kilometres_without_a_unit_are_asked_for) {
  RasterSurface surface = raster("r", samples(1738.2));
  EXPECT_THAT(refusal_of_surface(surface),
              AllOf(HasSubstr("holds 1738.2 to 1738.2 and names no unit: radii of Moon in km, or "
                              "heights in m?"),
                    HasSubstr("unit in lsos.raster, or --unit")));
  surface.unit = "km";
  EXPECT_NEAR(*read_height_m(surface), 800, 1e-6);
  surface.unit = "m";
  EXPECT_NEAR(*read_height_m(surface), 1738.2, 1e-9);
}

// One cell has the mark, in the south-western corner; the others are 5 m.
std::vector<std::vector<double>> marked(double mark) {
  auto rows = samples(5);
  rows[19][0] = mark;
  return rows;
}
const Geodetic corner{-9.5 / 1737400, -9.5 / 1737400, 0};

std::optional<double> corner_m(const RasterSurface& surface) {
  return RasterReader(surface, {"x.lua", 1}).at(corner)->height_m;
}

TEST(RasterMarks, of_missing_samples_are_known_without_a_tag) {
  EXPECT_FALSE(corner_m(raster("a", marked(-32768), "", "Int16")));
  EXPECT_FALSE(corner_m(raster("b", marked(-32767), "", "Int16")));
  EXPECT_FALSE(corner_m(raster("c", marked(-32768), "", "Float32")));
  EXPECT_FALSE(corner_m(raster("d", marked(-32767), "", "Int32")));
  EXPECT_FALSE(corner_m(raster("e", marked(-3.4028235e38), "", "Float32")));
  EXPECT_FALSE(corner_m(raster("f", marked(-3.4028227e38), "", "Float32")));
  EXPECT_FALSE(corner_m(raster("g", marked(NAN), "", "Float32")));
  EXPECT_FALSE(corner_m(raster("h", marked(-1234), "<NoDataValue>-1234</NoDataValue>", "Float32")));
  // The value is millimetres, where it is a height.
  EXPECT_EQ(corner_m(raster("i", marked(-32768), "<UnitType>mm</UnitType>", "Int32")), -32.768);
}

TEST(RasterMarks, that_are_said_replace_all_others) {
  RasterSurface surface = raster("a", marked(-77), "", "Float32");
  surface.nodata = -77;
  EXPECT_FALSE(corner_m(surface));
  surface = raster("b", marked(-32768), "<Scale>0.01</Scale>", "Int16");
  EXPECT_FALSE(corner_m(surface));
  surface.nodata = -1;
  EXPECT_NEAR(*corner_m(surface), -327.68, 1e-9);
  surface = raster("c", marked(-9999), "<NoDataValue>5</NoDataValue>");
  surface.nodata = 12;
  EXPECT_EQ(corner_m(surface), -9999);
  surface = raster("d", marked(0.1), "", "Float32");
  surface.nodata = 0.1;
  EXPECT_FALSE(corner_m(surface));
}

TEST(RasterMarks, that_cannot_be_known_are_asked_for) {
  RasterSurface surface = raster("a", marked(-9999));
  EXPECT_THAT(refusal_of_surface(surface),
              AllOf(HasSubstr("holds -9999 and else nothing below 5, as if"),
                    HasSubstr("say nodata = -9999, or another value"),
                    HasSubstr("nodata in lsos.raster, or --nodata")));
  surface.nodata = -9999;
  EXPECT_EQ(refusal_of_surface(surface), "accepted");
  // A valley that leads there is real.
  auto slope = samples(-9990);
  slope[3][3] = -9999;
  EXPECT_EQ(refusal_of_surface(raster("b", slope)), "accepted");
  EXPECT_THAT(refusal_of_surface(raster("c", marked(-32000))),
              AllOf(HasSubstr("holds samples from -32000 to 5, heights of -32000 to 5 m; no ground "
                              "of Moon is farther than 25000 m from its reference surface"),
                    HasSubstr("--nodata"), HasSubstr("--unit"), HasSubstr("--radius")));
}

TEST(RasterMarks, alone_are_no_raster) {
  EXPECT_THAT(refusal_of_surface(raster("r", samples(7), "<NoDataValue>7</NoDataValue>")),
              HasSubstr("holds no heights: all samples are missing"));
}

TEST(RasterCrsOption, places_a_raster_that_does_not_say_where_it_lies) {
  RasterSurface surface{TextRaster{"", transform, "", samples(5)}.write("r")};
  EXPECT_THAT(refusal_of_surface(surface), HasSubstr("crs in lsos.raster, or --crs"));
  surface.crs = moon_crs;
  EXPECT_NEAR(*read_height_m(surface), 5, 1e-12);
  EXPECT_EQ(RasterReader(surface, {}).own_body().name, "Moon");
  surface.crs = "IAU_2015:30101010";
  EXPECT_THAT(refusal_of_surface(surface),
              AllOf(HasSubstr("is said to be in the CRS 'IAU_2015:30101010', "
                              "which GDAL does not know"),
                    HasSubstr("IAU_2015:30135")));
}

std::string three_bands(const std::string& first, const std::string& second,
                        const std::string& colour = "Undefined") {
  const std::string one = TextRaster{moon_crs, transform, "", samples(1)}.write("one");
  const std::string two = TextRaster{moon_crs, transform, "", samples(2)}.write("two");
  const std::string file = one.substr(0, one.size() - 7) + "bands.vrt";
  std::ofstream vrt(file);
  vrt << "<VRTDataset rasterXSize='20' rasterYSize='20'><SRS>" << moon_crs << "</SRS><GeoTransform>"
      << transform << "</GeoTransform>";
  int number = 0;
  for (const std::string& description : {first, second, std::string("slope")}) {
    ++number;
    vrt << "<VRTRasterBand dataType='Float64' band='" << number << "'><Description>" << description
        << "</Description><ColorInterp>" << colour
        << "</ColorInterp><SimpleSource><SourceFilename relativeToVRT='1'>"
        << (number == 1 ? "one.vrt" : "two.vrt")
        << "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand>";
  }
  vrt << "</VRTDataset>";
  return file;
}

TEST(RasterBand, is_chosen_by_number_or_description) {
  RasterSurface surface{three_bands("rock", "height")};
  EXPECT_EQ(read_height_m(surface), 1);
  surface.band = 2;
  EXPECT_EQ(read_height_m(surface), 2);
  surface.band = "height";
  EXPECT_EQ(read_height_m(surface), 2);
  surface.band = "heigth";
  EXPECT_THAT(refusal_of_surface(surface),
              HasSubstr("has no band 'heigth': there is 1 'rock', 2 'height', 3 'slope'; did you "
                        "mean 'height'?"));
  surface.band = 4;
  EXPECT_THAT(refusal_of_surface(surface),
              HasSubstr("has no band 4: 1..3 is allowed (1 'rock', 2 'height'"));
}

TEST(RasterBand, descriptions_must_be_clear_and_colours_are_no_heights) {
  RasterSurface surface{three_bands("height", "height")};
  surface.band = "height";
  EXPECT_THAT(refusal_of_surface(surface),
              HasSubstr("describes bands 1 and 2 as 'height': give the number (band in"));
  EXPECT_THAT(refusal_of_surface({three_bands("a", "b", "Green")}),
              HasSubstr("is a picture: band 1 holds its colours (Green), heights are wanted"));
}

TEST(RasterFile, that_is_the_samples_of_a_label_is_told_so) {
  const std::string folder = ::testing::TempDir() + "lsos_label";
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/a.img") << "samples";
  std::ofstream(folder + "/a.xml") << "label";
  EXPECT_THAT(refusal_of_surface({folder + "/a.img"}),
              AllOf(HasSubstr("cannot be opened: "),
                    HasSubstr("; did you mean its label '" + folder + "/a.xml'?")));
  std::ofstream(folder + "/b.zip") << "archive";
  EXPECT_THAT(refusal_of_surface({folder + "/b.zip"}),
              HasSubstr("of an archive name the file inside: '/vsizip/" + folder + "/b.zip/FILE'"));
}

}  // namespace
}  // namespace lsos
