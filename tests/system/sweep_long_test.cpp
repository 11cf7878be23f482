// Studies in the long set: a hundred kills, and whether bands hold what they say.
#include "system/killed_sweep.h"

namespace lsos::test {
namespace {

TEST_F(KilledSweep, at_a_hundred_moments_loses_nothing_and_repeats_nothing) { kill(100); }

// Charges of a study over a short plan with seed 1, and of 500 fresh cases with seed 2. The first
// is a Latin hypercube: of 200 cases at random, one study in forty has a band that holds fewer than
// 84 or more than 96 % of the fresh ones, as its own 5 and 95 % quantiles are uncertain.
TEST(Calibration, of_the_bands_of_200_cases) {
  const TempFolder folder;
  folder.write("plan.kml", kml(short_plan()));
  const auto study = [&](int cases, int seed) {
    std::string text = study_text(
        "cases = " + std::to_string(cases) + (seed == 1 ? ", sampling = 'latin_hypercube'" : "") +
            ", gather = { lsos.gather { event = 'A/20', quantity = 'charge', name = 'charge' } },",
        "lsos.vary { of = 'A/10.Speed', uniform = { '0.5 m/s', '1.5 m/s' } },"
        "lsos.vary { of = 'Rover A.InitialCharge', normal = { mean = 0.6, deviation = 0.1, min = "
        "0.3, max = 0.9 } },");
    text.replace(text.find("seed = 1"), 8, "seed = " + std::to_string(seed));
    const std::string name = "seed" + std::to_string(seed);
    folder.write(name + ".lua", text);
    EXPECT_EQ(
        run({"sweep", name + ".lua", "-o", name, "--quiet"}, {.folder = folder.path()}).exit_code,
        0);
    return folder / name;
  };
  const auto band = all_rows(study(200, 1), "arrivals")[1];
  const auto fresh = rows(study(500, 2), "SELECT charge FROM cases");
  ASSERT_EQ(fresh.size(), 500u);
  int within = 0;
  for (const auto& row : fresh) {
    const double charge = row["charge"];
    within += charge >= band["charge_p5"] && charge <= band["charge_p95"] ? 1 : 0;
  }
  EXPECT_GE(within, 420) << "84 %";
  EXPECT_LE(within, 480) << "96 %";
}

}  // namespace
}  // namespace lsos::test
