// What `lsos-host sweep` is told.
#pragma once

#include <string>
#include <vector>

#include "lua/study/cluster_options.h"

namespace lsos {

struct SweepOptions {
  std::vector<std::string> words;  // of the command line
  std::string verb;                // run, status, gather; "": run all and gather
  std::string study;
  std::string folder;  // "": out/STUDY-NAME
  std::string cases;   // "40-59,71"; "": all
  std::string retry;   // "failed": those that could not be run, too
  int jobs = 0;        // 0: as many as there are processors
  int threads = 0;     // of each case; 0: processors by jobs
  ClusterOptions cluster;
  bool is_dry = false, is_quiet = false, is_json = false;
};

}  // namespace lsos
