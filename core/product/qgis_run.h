// Writes mission.qgz and hillshade.tif: a run as QGIS opens it.
#pragma once

#include <string>

#include "mission/model/mission_model.h"
#include "terrain/ground.h"

namespace lsos {

// Writes both from the run's log. Throws InputError where they cannot be written.
void write_qgis_project(const std::string& run_dir, const MissionModel& files,
                        const Ground& ground);

}  // namespace lsos
