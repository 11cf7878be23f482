// Which scripts are found, and how broken, hidden and unknown ones are treated.
#include "base/sha256.h"
#include "script_fixture.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* sound_event =
    "local lsos = require 'lsos' return lsos.event { api = 1, doc = 'First.', "
    "phases = { go = function() end } }";

std::string text_of_faults(const Faults& faults) {
  std::string text;
  for (const Fault& fault : faults.sorted()) text += to_string(fault) + "\n";
  return text;
}

template <class F>
std::string input_error(F&& f) {
  try {
    f();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Catalog, broken_script_costs_a_warning_and_the_others_load) {
  ScriptDirectory directory;
  directory.write("events/Good.lua", sound_event);
  directory.write("events/Bad.lua", "return 5 +");
  const Catalog catalog(std::vector<std::string>{directory.path()});
  EXPECT_TRUE(catalog.declarations().events.contains("Good"));
  EXPECT_FALSE(catalog.declarations().events.contains("Bad"));
  EXPECT_FALSE(catalog.faults().has_errors());
  EXPECT_THAT(text_of_faults(catalog.faults()),
              HasSubstr("events/Bad.lua:1: warning: the event 'Bad' cannot be used: "));
}

TEST(Catalog, event_made_of_a_broken_one_cannot_be_used_either) {
  ScriptDirectory directory;
  directory.write("events/Bad.lua", "return 5 +");
  directory.write("events/Whole.lua",
                  "local lsos = require 'lsos' return lsos.event { api = 1, doc = 'x', phases = { "
                  "go = lsos.sub_event { event = 'Part' } } }");
  directory.write("events/Part.lua",
                  "local lsos = require 'lsos' return lsos.event { api = 1, doc = 'x', phases = { "
                  "go = lsos.sub_event { event = 'Bad' } } }");
  const Catalog catalog(std::vector<ScriptFolder>{{directory.path(), ""}});
  EXPECT_TRUE(catalog.declarations().events.empty());
  EXPECT_THAT(errors_of(catalog, ScriptKind::event, "Whole"), HasSubstr("no event 'Part'"));
}

TEST(Catalog, earlier_folder_goes_first_and_says_so) {
  ScriptDirectory first, second;
  first.write("events/Same.lua", sound_event);
  second.write("events/Same.lua",
               "local lsos = require 'lsos' return lsos.event { api = 1, doc = 'Second.', "
               "phases = { go = function() end } }");
  const Catalog catalog(std::vector<ScriptFolder>{{first.path(), "plan"}, {second.path(), ""}});
  EXPECT_EQ(catalog.declarations().events.at("Same").doc, "First.");
  EXPECT_EQ(
      text_of_faults(catalog.faults()),
      "plan/events/Same.lua: warning: is used in place of " + second.path() + "/events/Same.lua\n");
}

TEST(Catalog, equal_copies_are_no_matter) {
  ScriptDirectory first, second;
  first.write("events/Same.lua", sound_event);
  second.write("events/Same.lua", sound_event);
  const Catalog catalog(std::vector<std::string>{first.path(), second.path()});
  EXPECT_EQ(text_of_faults(catalog.faults()), "");
}

TEST(Catalog, folders_need_not_exist) {
  const Catalog catalog(std::vector<std::string>{"/nowhere/at/all"});
  EXPECT_TRUE(catalog.scripts().empty());
}

TEST(Catalog, keeps_source_and_hash_of_every_script) {
  ScriptDirectory directory;
  directory.write("events/Good.lua", sound_event);
  const Catalog catalog(std::vector<ScriptFolder>{{directory.path(), ""}});
  directory.write("events/Good.lua", "changed later");
  ASSERT_EQ(catalog.scripts().size(), 1u);
  EXPECT_EQ(catalog.scripts()[0].file, "events/Good.lua");
  EXPECT_EQ(catalog.scripts()[0].sha256, sha256_hex(sound_event));
  LuaHost host(catalog);
  EXPECT_EQ(host.declarations().events.size(), 1u);
}

class ShippedScripts : public ::testing::Test {
 protected:
  Catalog catalog{std::vector<ScriptFolder>{{LSOS_SOURCE_DIR, ""}}};
};

TEST_F(ShippedScripts, unknown_name_is_an_error_with_the_nearest) {
  const Place place{"plan.kml", 12};
  EXPECT_EQ(input_error([&] { catalog.load_rover("SVE", place); }),
            "plan.kml:12: no rover type 'SVE'; did you mean 'SEV'?");
  EXPECT_EQ(input_error([&] { catalog.load_terrain("Flta", place); }),
            "plan.kml:12: no terrain 'Flta'; did you mean 'Flat'?");
  EXPECT_EQ(input_error([&] { catalog.load_soil("ApolloLose", place); }),
            "plan.kml:12: no soil 'ApolloLose'; did you mean 'ApolloLoose'?");
}

TEST_F(ShippedScripts, sev_has_its_published_size) {
  const RoverSpec sev = catalog.load_rover("SEV").spec;
  const Wishbone& suspension = std::get<Wishbone>(sev.suspension);
  ASSERT_EQ(suspension.modules.size(), 6u);
  EXPECT_EQ(suspension.modules[0].name, "front_left");
  EXPECT_EQ(suspension.modules[5].name, "rear_right");
  EXPECT_EQ(suspension.modules[0].p_B_m.x() - suspension.modules[5].p_B_m.x(), 4);  // wheelbase
  EXPECT_EQ(suspension.modules.size() * suspension.wheel_offsets_m.size(), 12u);
  EXPECT_EQ(suspension.wheel.radius_m, 0.495);
  VehicleConfig whole = sev.vehicle;
  add_wishbone(whole, suspension, 1.62);
  EXPECT_NEAR(whole.mass_kg(), 4000, 1e-9);
  EXPECT_EQ(sev.vehicle.step, SimTime(10000));
  EXPECT_NEAR(sev.vehicle.chassis_clearance_m + sev.vehicle.chassis_size_m.z(), 3, 1e-12);
  EXPECT_FALSE(sev.vehicle.assumptions.empty());
}

TEST_F(ShippedScripts, soils_have_their_published_numbers) {
  const Soil nominal = catalog.load_soil("ApolloNominal");
  EXPECT_EQ(nominal.k_c, 1400);
  EXPECT_EQ(nominal.k_phi, 820000);
  EXPECT_NEAR(nominal.friction_rad, 0.6108652381980153, 1e-15);
  EXPECT_EQ(nominal.shear_modulus_x_m, 0.018);
  const Soil dense = catalog.load_soil("ApolloDense"), loose = catalog.load_soil("ApolloLoose");
  EXPECT_LT(loose.friction_rad, nominal.friction_rad);
  EXPECT_GT(dense.density_kgpm3, nominal.density_kgpm3);
}

TEST_F(ShippedScripts, terrains_have_their_soil_and_shape) {
  EXPECT_THAT(catalog.declarations().terrains,
              ElementsAre("BlackPoint", "Craters", "Flat", "LunarSouthPole", "Slope"));
  const TerrainSpec slope = catalog.load_terrain("Slope");
  EXPECT_NEAR(std::get<PlaneSurface>(slope.layers.front()).slope_rad, 0.17453292519943295, 1e-15);
  EXPECT_EQ(slope.soil.name, "ApolloNominal");
  EXPECT_TRUE(slope.is_synthetic);
  EXPECT_TRUE(catalog.load_terrain("Craters").detail->craters.has_value());
}

TEST(Inertia, flat_discs_and_geared_wheels_are_allowed) {
  ScriptDirectory directory;
  directory.write("rovers/Disc.lua",  // at the limit, except for rounding
                  "local lsos = require 'lsos' "
                  "return lsos.bogie { inertia_kgm2 = lsos.vec3(0.21, 0.47, 0.68) }");
  directory.write("rovers/Geared.lua",
                  "local lsos = require 'lsos' "
                  "return lsos.wheel { inertia_kgm2 = lsos.vec3(0.01, 0.04, 0.01) }");
  const Catalog catalog(std::vector<ScriptFolder>{{directory.path(), ""}});
  for (const char* name : {"Disc", "Geared"}) {
    const std::string errors = errors_of(catalog, ScriptKind::rover, name);
    EXPECT_THAT(errors, HasSubstr("'mass_kg' is missing"));
    EXPECT_THAT(errors, Not(HasSubstr("inertia_kgm2")));
  }
}

TEST(Terrain, raster_is_found_beside_its_script) {
  ScriptDirectory directory;
  directory.write("terrain/Rim.lua",
                  "local lsos = require 'lsos' return lsos.terrain { api = 1, doc = 'x', surface = "
                  "lsos.raster { file = 'rim.tif', band = 2 }, soil = lsos.soil { k_c = 1, k_phi = "
                  "2, n = 1, cohesion_pa = 0, friction_rad = 0.5, density_kgpm3 = 1500, "
                  "shear_modulus_x_m = 0.02 } }");
  const Catalog catalog(std::vector<ScriptFolder>{{directory.path(), ""}});
  const TerrainSpec rim = catalog.load_terrain("Rim");
  EXPECT_EQ(std::get<RasterSurface>(rim.layers.front()).file,
            directory.path() + "/terrain/rim.tif");
  EXPECT_EQ(std::get<int>(std::get<RasterSurface>(rim.layers.front()).band), 2);
  EXPECT_FALSE(rim.is_synthetic);
  EXPECT_EQ(rim.soil.k_phi, 2);
  EXPECT_EQ(rim.place, (Place{"terrain/Rim.lua", 1}));
}

TEST(Fields, limits_and_defaults_are_converted_to_si) {
  EventRun run("local function go() end", R"(phases = { go = go }, params = {
      slope_max_rad = lsos.number { kml = 'MaxSlope', unit = 'deg', min = 0, max = 40, default = 20 },
      speed_mps = lsos.number { kml = 'Speed', unit = 'km/h', default = 36 },
      hold_s = lsos.duration { kml = 'Hold', unit = 'min', default = 2 } })");
  const EventDeclaration& event = run.catalog->declarations().events.at("Probe");
  EXPECT_EQ(std::get<double>(*event.fields[0].default_value), 120);
  EXPECT_EQ(event.fields[0].min_si, 0.0);
  EXPECT_NEAR(*event.fields[1].max_si, 0.6981317007977318, 1e-15);
  EXPECT_NEAR(std::get<double>(*event.fields[2].default_value), 10, 1e-14);
}

TEST(ScriptFolders, are_plan_then_path_then_shipped) {
  std::vector<std::string> text;
  for (const ScriptFolder& folder : script_folders("plans/a.kml", "/one::two", "/usr/share/x")) {
    text.push_back(folder.path + " as '" + folder.shown + "'");
  }
  EXPECT_THAT(text, ElementsAre("plans as 'plans'", "/one as '/one'", "two as 'two'",
                                "/usr/share/x as ''"));
  EXPECT_EQ(script_folders("a.kml", "", "/s")[0].path, ".");
  EXPECT_EQ(script_folders("", "", "/s")[0].path, ".");
  ScriptDirectory directory;
  directory.write("events/Route.lua", "");
  const std::string shipped = directory.path();
  EXPECT_EQ(script_folders(shipped + "/a.kml", shipped + "/events/..", shipped).size(), 1u);
}

TEST(ScriptFolders, shipped_ones_are_found_from_the_program) {
  ScriptDirectory directory;
  directory.write("share/lsos-host/events/Route.lua", "");
  EXPECT_EQ(shipped_folder(directory.path() + "/bin/lsos-host", "/source"),
            directory.path() + "/share/lsos-host");
  ScriptDirectory tree;
  tree.write("events/Route.lua", "");
  EXPECT_EQ(shipped_folder(tree.path() + "/build/bin/lsos-host", "/source"), tree.path());
  EXPECT_EQ(shipped_folder("/nowhere/bin/lsos-host", "/source"), "/source");
}

}  // namespace
}  // namespace lsos
