#include "lua/session/picture_session.h"

#include <memory>

#include "mission/rover/rover_rows.h"
#include "picture/png.h"

namespace lsos {

namespace {

// The simulation as a run to draw: rovers in their present state, with tracks from the log.
PictureRun run_of(SimSession& session) {
  Simulation& simulation = session.simulation();
  const SimTime now = session.now();
  const MissionInfo& mission = session.files().plan.mission;
  PictureRun run;
  run.files = session.files();
  run.ground = std::shared_ptr<const Ground>(std::shared_ptr<const Ground>(), &simulation.ground());
  run.start = mission.start_time;
  run.end = now;
  run.times = {now};
  session.commit_log();
  const LogReader log(session.folder() + "/log.gpkg");
  run.logged = read_logged(log, run.times, *run.ground, mission.log_interval);
  LoggedMoment& moment = run.logged.moments.front();
  moment.clear();
  for (const FleetRover& rover : simulation.fleet().rovers) {
    const RoverAgent& agent = *rover.agent;
    const EventSequence& sequence = rover.sequence;
    moment.push_back({sample_row(agent, now, sequence.event_label(), sequence.phase()),
                      joint_rows(agent, now), panel_rows(agent, now)});
    run.logged.tracks[agent.id()].push_back({now, moment.back().sample.p_S_m});
    run.rovers.push_back(agent.id());
  }
  return run;
}

}  // namespace

void write_picture(SimSession& session, const PictureRequest& request, const std::string& file) {
  const PictureRun run = run_of(session);
  const Gpu gpu;
  Lettering letters;
  const PictureFrameOut out = picture_of(run, 0, request, gpu, letters);
  write_png(file, out.picture.width_px, out.picture.height_px, out.picture.rgb);
}

}  // namespace lsos
