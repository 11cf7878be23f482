// A study that was read together with its plan: ready to draw cases of.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lua/host/mission_files.h"
#include "lua/host/mission_reader.h"
#include "study/parameter.h"
#include "study/sampling.h"
#include "study/study.h"

namespace lsos {

struct StudyFiles {
  Study study;
  std::string sha256;                           // of the study's file
  std::string plan_file;                        // relative to the working folder
  MissionFiles base;                            // the plan, its scripts and models
  std::string kml;                              // its document
  std::vector<Parameter> parameters;            // in byte order of their names
  std::map<std::string, std::string> scripts;   // digests of those that any case uses
  std::map<std::string, TerrainSpec> terrains;  // of all cases, by name
  std::int64_t cases = 0;
  double interval_s = 0;  // between two times of the bands

  std::string plan_folder() const;
  Sampler sampler() const;
};

// Reads and checks a study and its plan; all faults of both are told together. Throws InputError.
// Warnings are in `base.faults`.
StudyFiles read_study(const std::string& file);

// What a case has in place of the plan's own values. `number`: from 1.
std::vector<Draw> draws_of_case(const StudyFiles& files, const Sampler& sampler,
                                std::int64_t number);

// The plan of a case as if it lay in `folder`, which must exist.
PlanSource plan_of_case(const StudyFiles& files, const std::vector<Draw>& draws,
                        const std::string& folder);

}  // namespace lsos
