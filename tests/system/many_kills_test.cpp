// A hundred random moments at which runs of shipped plans are killed: while routes are planned,
// while rovers drive, while rows are committed.
#include "system/killed_runs.h"
#include "system/source_files.h"

namespace lsos::test {
namespace {

class ManyKills : public KilledRuns {
 protected:
  std::string copy_of(const std::string& plan) {
    return folder_.write(plan, read_text(repository() / "plans" / plan));
  }
};

TEST_F(ManyKills, of_a_drive_on_planned_routes) {
  whole_run(copy_of("crater_crossing.kml"));
  kill_and_resume(40, true);
}

TEST_F(ManyKills, of_two_rovers) {
  whole_run(copy_of("two_rovers.kml"));
  kill_and_resume(25, true);
}

TEST_F(ManyKills, of_a_stop_for_sunlight) {
  whole_run(copy_of("solar_stop.kml"));
  kill_and_resume(25, true);
}

TEST_F(ManyKills, of_three_rovers_at_the_pole) {
  whole_run(copy_of("polar_team.kml"),
            {"--checkpoint-every", "1 min", "--no-report", "--quiet", "--threads", "2"});
  kill_and_resume(10, true);
}

}  // namespace
}  // namespace lsos::test
