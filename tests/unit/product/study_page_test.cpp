// The numbers of a study's page and map, of invented cases whose results are known.
#include "product/study/study_page.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "product/report_page.h"
#include "product/study/histogram.h"
#include "product/study/place_spread.h"
#include "product/study/quantiles.h"
#include "product/study/study_overlay.h"
#include "support/reference_data.h"
#include "unit/product/study_folder.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::ordered_json;

// A normal distribution with deviations 30 and 10 m, turned by 30 degrees: 90 % lie within
// sqrt(-2 ln 0.1) = 2.1460 deviations.
TEST(PlaceSpread, is_the_ellipse_of_a_normal_distribution) {
  RandomStream random(11);
  PlaceSpread spread;
  std::vector<Vec2> places;
  const double cos = std::cos(0.5235987755982988), sin = 0.5;
  for (int i = 0; i < 40000; ++i) {
    const double along = 30 * normal(random), across = 10 * normal(random);
    places.emplace_back(1e6 + along * cos - across * sin, -2e6 + along * sin + across * cos);
    spread.add(places.back());
  }
  const auto ellipse = spread.ellipse(0.9);
  ASSERT_TRUE(ellipse);
  EXPECT_NEAR(ellipse->semi_major_m, 64.379, 0.7);
  EXPECT_NEAR(ellipse->semi_minor_m, 21.460, 0.25);
  EXPECT_NEAR(ellipse->angle_rad, 0.5236, 0.01);
  EXPECT_NEAR(ellipse->centre_m.x(), 1e6, 0.5);
  int inside = 0;
  for (const Vec2& place : places) {
    const Vec2 from = place - ellipse->centre_m;
    const double along = (from.x() * cos + from.y() * sin) / ellipse->semi_major_m;
    const double across = (-from.x() * sin + from.y() * cos) / ellipse->semi_minor_m;
    inside += along * along + across * across < 1 ? 1 : 0;
  }
  EXPECT_NEAR(inside / 40000.0, 0.9, 0.005);
}

TEST(PlaceSpread, of_four_corners_is_known_exactly) {
  PlaceSpread spread;
  for (const Vec2& place : {Vec2(3, 1), Vec2(3, -1), Vec2(-3, 1), Vec2(-3, -1)}) spread.add(place);
  const auto ellipse = spread.ellipse(0.9);
  // Variances 36/3 and 4/3.
  EXPECT_NEAR(ellipse->semi_major_m, std::sqrt(2 * std::log(10) * 12), 1e-12);
  EXPECT_NEAR(ellipse->semi_minor_m, std::sqrt(2 * std::log(10) * 4 / 3), 1e-12);
  EXPECT_NEAR(ellipse->angle_rad, 0, 1e-12);
  PlaceSpread pair;
  pair.add({0, 0});
  pair.add({1, 1});
  EXPECT_FALSE(pair.ellipse());
}

TEST(Histogram, counts_each_value_once) {
  std::vector<double> values;
  std::vector<bool> is_completed;
  for (int i = 0; i < 1000; ++i) {
    values.push_back(0.001 * i * i);
    is_completed.push_back(i % 4 != 0);
  }
  values[7] = std::nan("");
  const std::vector<HistogramBar> bars = histogram(values, is_completed);
  EXPECT_GE(bars.size(), 5u);
  EXPECT_LE(bars.size(), 41u);
  std::size_t completed = 0, other = 0;
  for (std::size_t k = 0; k < bars.size(); ++k) {
    completed += bars[k].completed;
    other += bars[k].other;
    EXPECT_DOUBLE_EQ(bars[k].from, k == 0 ? 0 : bars[k - 1].to);
    std::size_t count = 0;
    for (const double value : values) count += value >= bars[k].from && value < bars[k].to ? 1 : 0;
    EXPECT_EQ(bars[k].completed + bars[k].other, count) << k;
  }
  EXPECT_EQ(completed, 749u);
  EXPECT_EQ(other, 250u);
}

TEST(Histogram, has_a_bar_for_each_of_few_values) {
  const std::vector<HistogramBar> bars =
      histogram({2, 1, 2, std::nan(""), 5}, {true, true, false, true, true});
  ASSERT_EQ(bars.size(), 3u);
  EXPECT_EQ(bars[1].from, 2);
  EXPECT_EQ(bars[1].to, 2);
  EXPECT_EQ(bars[1].completed, 1u);
  EXPECT_EQ(bars[1].other, 1u);
  EXPECT_TRUE(histogram({std::nan("")}, {true}).empty());
  EXPECT_EQ(histogram({7.5, 7.5}, {true, true}).size(), 1u);
}

// All tests share one study of 100 cases, of which ten fail.
class StudyPage : public ::testing::Test {
 protected:
  void SetUp() override {
    if (study_ != nullptr) return;  // a folder is named after a test: not before the first
    study_ = new StudyFolder(100);
    document_ = new Json(study_document(study_->request()));
  }
  static void TearDownTestSuite() {
    delete document_;
    delete study_;
  }
  static const Json& study() { return (*document_)["study"]; }
  static const Json& number(const std::string& name) {
    for (const Json& each : study()["numbers"]) {
      if (each["name"] == name) return each;
    }
    throw std::runtime_error("no number " + name);
  }
  static const Json& influence_on(const std::string& name, std::size_t parameter) {
    for (std::size_t k = 0; k < study()["numbers"].size(); ++k) {
      if (study()["numbers"][k]["name"] == name) return study()["influence"][k][parameter];
    }
    throw std::runtime_error("no number " + name);
  }

  static inline StudyFolder* study_ = nullptr;
  static inline Json* document_ = nullptr;
};

TEST_F(StudyPage, counts_cases_as_the_table_has_them) {
  const Json& counts = study()["counts"];
  EXPECT_EQ(counts["gathered"], 100);
  EXPECT_EQ(counts["completed"], 90);
  EXPECT_EQ(counts["not_run"], 0);
  // Wilson's interval of 90 of 100.
  EXPECT_NEAR(counts["completed_low"].get<double>(), 0.8256, 1e-4);
  EXPECT_NEAR(counts["completed_high"].get<double>(), 0.9448, 1e-4);
  ASSERT_EQ(study()["outcomes"].size(), 2u);
  EXPECT_EQ(study()["outcomes"][1]["cases"], Json({10, 20, 30, 40, 50, 60, 70, 80, 90, 100}));
  EXPECT_EQ(study()["outcomes"][1]["reason"], "SEV1/20 'Leg 2' failed: stuck " + hostile);
}

TEST_F(StudyPage, has_the_quantiles_of_the_table) {
  std::vector<double> charges = study_->least_charges;
  const Quantiles expected = quantiles_of(charges);
  const Json& found = number("least charge")["quantiles"];
  EXPECT_DOUBLE_EQ(found[0].get<double>(), expected.p5);
  EXPECT_DOUBLE_EQ(found[1].get<double>(), expected.p50);
  EXPECT_DOUBLE_EQ(found[2].get<double>(), expected.p95);
}

// The least charge is 1 - 0.3 speed: it falls with it and hangs on nothing else.
TEST_F(StudyPage, tells_what_moves_a_result) {
  ASSERT_EQ(study()["parameters"],
            Json({"SEV1/10.Speed", "Noise", "Soil", "MissionInfo.StartTime"}));
  const Json& speed = influence_on("least charge", 0);
  EXPECT_EQ(speed["rho"], -1);
  EXPECT_EQ(speed["is_found"], true);
  EXPECT_GT(speed["share"].get<double>(), 0.98);
  const Json& noise = influence_on("least charge", 1);
  EXPECT_LT(std::abs(noise["rho"].get<double>()), 0.25);
  EXPECT_EQ(noise["is_found"], false);
  EXPECT_EQ(noise["is_share_found"], false);
  const Json& soil = influence_on("least charge", 2);
  EXPECT_TRUE(soil["rho"].is_null()) << "texts have no order";
  EXPECT_EQ(soil["classes"], 2);
  EXPECT_LT(soil["share"].get<double>(), 0.1);
  const Json& start = influence_on("least charge", 3);
  EXPECT_EQ(start["rho"], -1) << "but times have";
}

TEST_F(StudyPage, gives_no_shares_of_a_part_of_a_grid) {
  StudyPageRequest request = study_->request();
  request.is_independent = false;
  const Json document = study_document(request);
  EXPECT_FALSE(document["study"]["has_shares"].get<bool>());
  EXPECT_TRUE(document["study"]["influence"][1][0]["share"].is_null());
  EXPECT_FALSE(document["study"]["influence"][1][0]["rho"].is_null());
}

TEST_F(StudyPage, shows_where_cases_were_when_an_event_ended) {
  const Json& arrival = study()["arrivals"][0];
  EXPECT_EQ(arrival["share_reached"], 1);
  EXPECT_NEAR(study()["arrivals"][1]["share_reached"].get<double>(), 0.9, 1e-12);
  PlaceSpread expected;
  for (const Vec2& end_m : study_->ends_m) expected.add(end_m);
  const SpreadEllipse ellipse = *expected.ellipse();
  const Json& found = arrival["ellipse"];
  // The ground curves away by 0.3 m in a kilometre, and shrinks what lies on it by less than 1e-6.
  EXPECT_NEAR(found["x_m"].get<double>(), ellipse.centre_m.x(), 0.01);
  EXPECT_NEAR(found["y_m"].get<double>(), ellipse.centre_m.y(), 0.05);
  EXPECT_NEAR(found["semi_major_m"].get<double>(), ellipse.semi_major_m, 0.01);
  EXPECT_NEAR(found["semi_minor_m"].get<double>(), ellipse.semi_minor_m, 0.01);
}

TEST_F(StudyPage, is_one_page_that_loads_nothing_whatever_texts_say) {
  const std::string page = study_page(study_->request());
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(page, Not(HasSubstr(hostile)));
  EXPECT_THAT(page_json(*document_), Not(HasSubstr("<")));
  EXPECT_EQ(study()["doc"], "How far it goes " + hostile + ".");
  EXPECT_EQ(study()["files"][0], "plan.kml");
}

TEST_F(StudyPage, shows_the_cases_that_there_are) {
  const StudyFolder one(1);
  const Json few = study_document(one.request())["study"];
  EXPECT_EQ(few["counts"]["gathered"], 1);
  EXPECT_EQ(few["parameters"], Json::array()) << "one case varies nothing";
  EXPECT_TRUE(few["arrivals"][0]["ellipse"].is_null());
  EXPECT_THAT(study_page(one.request()), HasSubstr("</html>"));
  EXPECT_THAT(study_overlay(one.request()), HasSubstr("</kml>"));
}

TEST_F(StudyPage, has_a_map_for_google_earth) {
  const std::string kml = study_overlay(study_->request());
  EXPECT_THAT(kml, HasSubstr("<Document"));
  EXPECT_THAT(kml, HasSubstr("hint=\"target=moon\""));
  EXPECT_THAT(kml, Not(HasSubstr(hostile)));
  EXPECT_THAT(kml, HasSubstr("Leg 2: 90 %"));
  EXPECT_THAT(kml, HasSubstr("charge_p95"));
  EXPECT_THAT(kml, HasSubstr("<name>case 10</name>"));
}

TEST_F(StudyPage, has_a_map_that_is_valid_against_the_schema_of_kml) {
  LSOS_NEEDS_REFERENCE("kml/xsd/ogckml22.xsd");
  const std::string schema = reference_file("kml/xsd/ogckml22.xsd");
  const TestFolder folder;
  write_file(folder / "study.kml", study_overlay(study_->request()));
  // The catalog beside the schema names local copies of the schemas that it includes.
  const std::string catalog = schema.substr(0, schema.rfind('/')) + "/catalog.xml";
  const std::string command = "XML_CATALOG_FILES='" + catalog +
                              "' xmllint --nonet --noout --schema '" + schema + "' '" +
                              (folder / "study.kml") + "' > '" + (folder / "answer.txt") + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(folder / "answer.txt").value_or("");
}

}  // namespace
}  // namespace lsos
