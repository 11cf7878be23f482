// Which bodies hide a line of sight, and for how long.
#include "mission/light/sight_watch.h"

#include <gmock/gmock.h>

#include "planet/sky.h"

namespace lsos {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const SiteFrame site{*find_body("Moon"), geodetic_from_degrees(0, 0)};

SimTime hours(double h) { return from_seconds(3600 * h); }

// An end on level ground whose antenna stands 3 m high, and what stands about it.
class OneEnd : public ::testing::Test {
 protected:
  OneEnd() {
    end.id = "A";
    end.antenna_S_m = {0, 0, 3};
  }

  Vec3 to_earth() const {
    const Vec3 p_F_m = site.p_F_m(end.antenna_S_m);
    return site.R_FS().transpose() *
           sighting(site.body(), p_F_m, CelestialBody::earth, start).direction_F;
  }
  // A box of that side, so far from the antenna towards Earth.
  NamedMesh box(const std::string& id, double side_m, double away_m) const {
    NamedMesh body{id, {}};
    append(body.mesh, box_mesh({side_m, side_m, side_m}), Mat3::Identity(), away_m * to_earth());
    return body;
  }
  std::vector<SightIntervalRow> after(double h, const std::vector<NamedMesh>& bodies) {
    return watch.look(hours(h), start + hours(h), {end},
                      [&](const Vec3&, const Vec3&) { return bodies; });
  }

  static TerrainSpec level_ground() {
    TerrainSpec spec;
    spec.layers = {PlaneSurface{}};
    return spec;
  }

  Instant start = *parse_utc("2027-01-01T00:00:00Z").value;
  Renderer renderer;
  Ground ground{level_ground(), site, 1};
  SightEnd end;
  SightWatch watch{ground, renderer, 1};
};

TEST_F(OneEnd, is_hidden_by_the_bodies_of_which_each_alone_hides_it) {
  EXPECT_THAT(after(0, {box("A", 2, 4), box("B", 2, 9), box("C", 0.01, 15)}), IsEmpty());
  const std::vector<SightIntervalRow> ended = watch.finish(hours(1), {end});
  ASSERT_EQ(ended.size(), 1u);
  EXPECT_EQ(ended[0].kind, "hidden");
  EXPECT_EQ(ended[0].by, "A,B");
}

TEST_F(OneEnd, has_an_interval_for_each_hider) {
  after(0, {box("A", 2, 4)});
  const std::vector<SightIntervalRow> first = after(2, {box("B", 2, 4)});
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].by, "A");
  EXPECT_EQ(first[0].end, hours(2));
  const std::vector<SightIntervalRow> second = after(4, {});
  ASSERT_EQ(second.size(), 1u);
  EXPECT_EQ(second[0].by, "B");
  EXPECT_EQ(second[0].start, hours(2));
  EXPECT_THAT(watch.finish(hours(5), {end}),
              ElementsAre(::testing::Field(&SightIntervalRow::kind, "visible"),
                          ::testing::Field(&SightIntervalRow::kind, "link")));
}

// Only where it could have been linked: with its antenna up, and by its own body.
TEST_F(OneEnd, warns_of_an_hour_that_its_own_body_cost) {
  after(0, {box("B", 2, 4)});
  after(2, {box("A", 2, 4)});
  after(2.9, {});
  EXPECT_THAT(watch.warnings_of_own_way({end}), IsEmpty());
  after(5, {box("A", 2, 4)});
  end.has_link = false;
  end.motion = Motion::has_ended;
  after(5.2, {box("A", 2, 4)});
  after(9, {});
  EXPECT_THAT(watch.warnings_of_own_way({end}), IsEmpty());
  end.has_link = true;
  after(10, {box("A", 2, 4)});
  after(11, {});
  EXPECT_THAT(
      watch.warnings_of_own_way({end}),
      ElementsAre(HasSubstr("A: its own body or panels hid Earth from its antenna for 1.9 h")));
}

}  // namespace
}  // namespace lsos
