// Numbers of rovers' scripts and soils that studies multiply, and soils that plans change.
#include "lua/host/script_number.h"

#include <filesystem>

#include "script_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

const Catalog& shipped_scripts() {
  static const Catalog catalog(std::vector<std::string>{LSOS_SOURCE_DIR});
  return catalog;
}

TEST(ScriptNumber, is_what_the_script_gives) {
  const RoverModel sev = shipped_scripts().load_rover("SEV");
  EXPECT_EQ(script_number(shipped_scripts(), "SEV", "", "battery.capacity_j"),
            sev.power.battery->capacity_j);
  EXPECT_EQ(script_number(shipped_scripts(), "SEV", "", "panels.Roof.efficiency"),
            sev.power.panels.at(0).efficiency);
  EXPECT_EQ(script_number(shipped_scripts(), "SEV", "", "loads.radio.power_w"), 50);
  EXPECT_EQ(script_number(shipped_scripts(), "SEV", "", "cruise_speed_mps"),
            sev.spec.vehicle.cruise_speed_mps);
}

TEST(ScriptNumber, has_the_changes_of_a_variant) {
  EXPECT_EQ(
      script_number(shipped_scripts(), "SEV", "battery.capacity_j = 10 kWh", "battery.capacity_j"),
      3.6e7);
}

TEST(ScriptNumber, is_absent_where_the_script_gives_none) {
  for (const char* key : {"battery.capacty_j", "battery", "batery.capacity_j",
                          "panels.Attic.factor", "battery.capacity_j.more", "name", ""}) {
    EXPECT_FALSE(script_number(shipped_scripts(), "SEV", "", key)) << key;
  }
}

TEST(ChangedSoil, differs_in_what_is_changed_alone) {
  for (const auto& file : std::filesystem::directory_iterator(LSOS_SOURCE_DIR "/terrain/soils")) {
    if (file.path().extension() != ".lua") continue;
    const Soil soil = shipped_scripts().load_soil(file.path().stem());
    if (soil.is_rigid) continue;
    const Soil same = shipped_scripts().changed_soil(soil, "{}", "SoilVariant", {});
    const Soil other =
        shipped_scripts().changed_soil(soil, "{ ['cohesion_pa'] = 321 }", "SoilVariant", {});
    EXPECT_EQ(other.cohesion_pa, 321) << soil.name;
    for (const char* key : {"k_c", "k_phi", "n", "friction_rad", "density_kgpm3",
                            "shear_modulus_x_m", "shear_modulus_y_m", "slip_sinkage"}) {
      EXPECT_EQ(soil_number(same, key), soil_number(soil, key)) << soil.name << " " << key;
      EXPECT_EQ(soil_number(other, key), soil_number(soil, key)) << soil.name << " " << key;
    }
    EXPECT_EQ(same.cohesion_pa, soil.cohesion_pa);
  }
}

TEST(ChangedSoil, tells_what_is_wrong_at_its_place) {
  const Soil soil = shipped_scripts().load_soil("ApolloNominal");
  try {
    shipped_scripts().changed_soil(soil, "{ ['cohesion'] = 3 }", "SoilVariant", {"plan.kml", 7});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("plan.kml:7: SoilVariant: soil: unknown key 'cohesion'; did you mean "
                          "'cohesion_pa'?"));
  }
}

}  // namespace
}  // namespace lsos
