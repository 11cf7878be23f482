// Reports on standard error what is being planned, when that takes more than 2 s.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace lsos {

class PlanningWatch {
 public:
  explicit PlanningWatch(bool is_quiet);
  ~PlanningWatch();
  PlanningWatch(const PlanningWatch&) = delete;
  PlanningWatch& operator=(const PlanningWatch&) = delete;

  // Sets what is planned from now on; "": nothing.
  void plan(const std::string& what);

 private:
  void watch();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::string what_;      // guarded by mutex_, as are the next two
  long long number_ = 0;  // number of calls of plan()
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace lsos
