// lsos.derive: a rover with the numbers of another one, some of them changed.
#include <algorithm>

#include "lua/host/variant.h"
#include "script_fixture.h"

namespace lsos {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

// Searches a folder of the test before the shipped scripts.
class Derive : public ::testing::Test {
 protected:
  Catalog catalog() const {
    return Catalog(
        std::vector<ScriptFolder>{{directory_.path(), ""}, {LSOS_SOURCE_DIR, "shipped"}});
  }
  void write(const std::string& name, const std::string& base, const std::string& changes) {
    directory_.write("rovers/" + name + ".lua",
                     "local lsos = require 'lsos'\n"
                     "return lsos.derive('" +
                         base + "', " + changes + ")\n");
  }
  // Message of the error that loading the script throws.
  std::string fault(const std::string& name) const {
    try {
      catalog().load_rover(name);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  }
  ScriptDirectory directory_;
};

TEST_F(Derive, changes_what_is_named_and_nothing_else) {
  write("Other", "SEV",
        "{ doc = 'Another.', cruise_speed_mps = 1.5, battery = { capacity_j = 5e8 }, "
        "panels = { Roof = { efficiency = 0.32 } }, loads = { heaters = false }, "
        "suspension = { wheel = { radius_m = 0.5 } }, resources = false }");
  const Catalog catalog = this->catalog();
  const RoverModel base = catalog.load_rover("SEV"), other = catalog.load_rover("Other");
  EXPECT_EQ(other.spec.name, "Other");
  EXPECT_EQ(other.spec.vehicle.type, "Other");
  EXPECT_EQ(other.spec.doc, "Another.");
  EXPECT_EQ(other.spec.vehicle.cruise_speed_mps, 1.5);
  EXPECT_EQ(other.spec.vehicle.speed_max_mps, base.spec.vehicle.speed_max_mps);
  EXPECT_EQ(other.power.battery->capacity_j, 5e8);
  EXPECT_EQ(other.power.battery->reserve, base.power.battery->reserve);
  EXPECT_EQ(other.power.panels.at(0).efficiency, 0.32);
  EXPECT_EQ(other.power.panels.at(0).width_m, base.power.panels.at(0).width_m);
  ASSERT_EQ(other.power.loads.size(), base.power.loads.size() - 1);
  EXPECT_EQ(other.power.loads.at(1).name, "radio");
  EXPECT_TRUE(other.power.resources.empty());
  const auto& wheel = std::get<Wishbone>(other.spec.suspension).wheel;
  EXPECT_EQ(wheel.radius_m, 0.5);
  EXPECT_EQ(wheel.width_m, std::get<Wishbone>(base.spec.suspension).wheel.width_m);
  EXPECT_EQ(other.antennas.size(), base.antennas.size());
  EXPECT_EQ(other.spec.vehicle.chassis.mass_kg, base.spec.vehicle.chassis.mass_kg);
}

TEST_F(Derive, adds_its_assumptions_and_a_sentence_of_the_changes) {
  write("Other", "SEV",
        "{ battery = { capacity_j = 5e8 }, loads = { heaters = false }, assumptions = { 'Other: "
        "it is assumed' } }");
  const std::vector<std::string> all = catalog().load_rover("Other").spec.vehicle.assumptions;
  EXPECT_THAT(all, Contains("Other: it is assumed"));
  EXPECT_THAT(all, Contains("Other: is SEV with battery.capacity_j = 5e+08, no loads.heaters"));
  EXPECT_THAT(all, Contains(HasSubstr("SEV: 4000 kg in all")));
}

TEST_F(Derive, may_be_derived_from_and_knows_its_bases) {
  write("First", "SEV", "{ battery = { capacity_j = 5e8 } }");
  write("Second", "First", "{ cruise_speed_mps = 1 }");
  const Catalog catalog = this->catalog();
  const RoverModel second = catalog.load_rover("Second");
  EXPECT_EQ(second.power.battery->capacity_j, 5e8);
  EXPECT_EQ(second.spec.vehicle.cruise_speed_mps, 1);
  EXPECT_EQ(catalog.bases_of("Second"), (std::set<std::string>{"First", "SEV"}));
  EXPECT_TRUE(catalog.bases_of("SEV").empty());
}

TEST_F(Derive, makes_assets_too) {
  write("Camp", "Habitat", "{ supply_w = 8000 }");
  EXPECT_EQ(catalog().load_asset("Camp").supply_w, 8000);
}

TEST_F(Derive, says_what_cannot_be_changed) {
  const auto fault_of = [&](const std::string& base, const std::string& changes) {
    write("Other", base, changes);
    return fault("Other");
  };
  EXPECT_THAT(fault_of("SVE", "{}"), HasSubstr("there is no rover 'SVE'; did you mean 'SEV'?"));
  EXPECT_THAT(fault_of("Other", "{}"), HasSubstr("'Other' is derived from itself"));
  EXPECT_THAT(fault_of("SEV", "{ cruise_sped_mps = 1 }"),
              HasSubstr("Other.lua:2: rover: unknown key 'cruise_sped_mps'"));
  EXPECT_THAT(fault_of("SEV", "{ battery = { capacity = 1 } }"),
              HasSubstr("Other.lua:2: battery: unknown key 'capacity'"));
  EXPECT_THAT(fault_of("SEV", "{ panels = { Rof = { efficiency = 1 } } }"),
              HasSubstr("panels: there is no 'Rof'; there are Roof"));
  EXPECT_THAT(fault_of("SEV", "{ panels = { Roof = 3 } }"),
              HasSubstr("panels.Roof: a table of changes or false is wanted, found a number"));
  EXPECT_THAT(fault_of("SEV", "{ 3 }"), HasSubstr("names of keys are wanted, found [1]"));
  EXPECT_THAT(fault_of("SEV", "{ suspension = { modules = { nothing = false } } }"),
              HasSubstr("suspension.modules: there is no 'nothing'; there are front_left"));
  EXPECT_THAT(fault_of("SEV", "{ cruise_speed_mps = 9 }"),
              HasSubstr("cruise_speed_mps is above speed_max_mps"));
  EXPECT_THAT(fault_of("SEV", "{ assumptions = 3 }"),
              HasSubstr("assumptions: a list of texts is wanted, found a number"));
  write("A", "B", "{}");
  write("B", "A", "{}");
  EXPECT_THAT(fault("A"), HasSubstr("is derived from itself"));
  EXPECT_THAT(fault("B"), HasSubstr("is derived from itself"));
}

TEST_F(Derive, replaces_vectors_whole) {
  write("Low", "SEV",
        "{ chassis = { center_of_mass_m = lsos.vec3(0, 0, 0.9) }, "
        "panels = { Roof = { position_m = lsos.vec3(0, 0, 3) } } }");
  const RoverModel low = catalog().load_rover("Low");
  EXPECT_EQ(low.spec.vehicle.p_BC_m, Vec3(0, 0, 0.9));
  EXPECT_EQ(low.power.panels[0].p_B_m, Vec3(0, 0, 3));
  EXPECT_THAT(low.spec.vehicle.assumptions,
              Contains("Low: is SEV with chassis.center_of_mass_m = (0, 0, 0.9), "
                       "panels.Roof.position_m = (0, 0, 3)"));
  EXPECT_EQ(variant_table("chassis.center_of_mass_m = 0, 0, 90 cm").value,
            "{ ['chassis'] = { ['center_of_mass_m'] = lsos.vec3(0, 0, 0.9), }, }");
  EXPECT_THAT(variant_table("battery.capacity_j = 144,000,000").why, HasSubstr("has a comma"));
  EXPECT_THAT(variant_table("chassis.center_of_mass_m = true, 0, 1").why,
              HasSubstr("is no number"));
  Faults faults;
  const RoverModel model = catalog().load_variant(
      "SEV", "{ chassis = { center_of_mass_m = lsos.vec3(0, 0, 0.9) } }", "Variant", {}, faults);
  EXPECT_EQ(model.spec.vehicle.p_BC_m, Vec3(0, 0, 0.9));
}

TEST_F(Derive, a_plan_may_change_numbers_alone) {
  const Catalog catalog = this->catalog();
  const RoverModel base = catalog.load_rover("SEV");
  Faults faults;
  const RoverModel model = catalog.load_variant("SEV", "{ battery = { capacity_j = 5e8 } }",
                                                "Rover 'A': Variant", {}, faults);
  EXPECT_TRUE(faults.sorted().empty());
  EXPECT_EQ(model.power.battery->capacity_j, 5e8);
  EXPECT_EQ(model.spec.vehicle.type, "SEV");
  EXPECT_THAT(model.spec.vehicle.assumptions,
              Contains("Rover 'A': Variant: SEV with battery.capacity_j = 5e+08"));
  EXPECT_EQ(catalog.load_rover("SEV").power.battery->capacity_j, base.power.battery->capacity_j);
  catalog.load_variant("SEV", "{ battery = { capacity_j = 60 } }", "Rover 'A': Variant", {},
                       faults);
  ASSERT_EQ(faults.sorted().size(), 1u);
  EXPECT_THAT(
      faults.sorted()[0].what,
      HasSubstr("battery.capacity_j = 60 J: the rover has 1.44e+08; is it in another unit?"));
}

}  // namespace
}  // namespace lsos
