// Numbers of rovers, assets and soils that are likely to be slips; no shipped number is one.
#include "mission/model/model_doubts.h"

#include "script_fixture.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Catalog& shipped() {
  static const Catalog catalog(std::vector<ScriptFolder>{{LSOS_SOURCE_DIR, "shipped"}});
  return catalog;
}

TEST(ModelDoubts, there_are_none_of_what_is_shipped) {
  int count = 0;
  for (const auto& [name, type] : shipped().declarations().rover_types) {
    EXPECT_THAT(type.is_asset ? asset_doubts(shipped().load_asset(name))
                              : rover_doubts(shipped().load_rover(name)),
                IsEmpty())
        << name;
    ++count;
  }
  for (const Script& script : shipped().scripts()) {
    if (script.kind != ScriptKind::soil) continue;
    EXPECT_THAT(soil_doubts(shipped().load_soil(script.name)), IsEmpty()) << script.name;
    ++count;
  }
  EXPECT_GT(count, 20);
}

TEST(ModelDoubts, of_soils_name_the_key_and_the_unit) {
  Soil soil = shipped().load_soil("ApolloNominal");
  soil.name = "Ours";
  soil.density_kgpm3 = 1.52;
  soil.cohesion_pa = 0.17;
  soil.friction_rad = 0.0106;
  soil.shear_modulus_x_m = 1.8;
  EXPECT_THAT(
      soil_doubts(soil),
      ElementsAre(HasSubstr("soil Ours: density_kgpm3 = 1.52: soils have 100 to 6000; is it "
                            "in g/cm3?"),
                  HasSubstr("shear_modulus_x_m = 1.8"), HasSubstr("is it in kPa?"),
                  HasSubstr("friction_rad = 0.0106: soils have 0.1 to 1.2")));
}

TEST(ModelDoubts, of_assets_name_masts_and_panels) {
  AssetModel asset = shipped().load_asset("CommStation");
  asset.antenna_height_m = 1000;
  PanelSpec panel;
  panel.name = "Array";
  panel.length_m = 1500;
  panel.width_m = 6;
  asset.panels.push_back(panel);
  EXPECT_THAT(asset_doubts(asset),
              ElementsAre("antenna_height_m = 1000: is it in cm?",
                          "panels: 'Array' is 1500 m x 6 m: is it in cm or mm?"));
}

}  // namespace
}  // namespace lsos
