// Bands of a study: what most cases have at each time, and where and when they reach each event.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "product/study/case_record.h"
#include "record/table_file.h"

namespace lsos {

// An event of the study's plan.
struct PlannedEvent {
  std::string rover_id;
  std::int64_t sequence = 0;
  std::string type, label;
  std::optional<Geodetic> place;  // where it is drawn: its last waypoint
};

// Writes layer `bands`. `series`: the files of the cases that have run. Few values lie in memory at
// a time, however many cases and times there are.
void write_bands(const std::vector<std::string>& series, const std::vector<std::string>& rovers,
                 TableFile& table);

// Collects when each event ended, and with what charge.
class Arrivals {
 public:
  explicit Arrivals(const std::vector<PlannedEvent>& events) : events_(events) {}

  void add(const CaseRecord& record);
  // Writes layer `arrivals`.
  void write(TableFile& table);

 private:
  using Key = std::pair<std::string, std::int64_t>;
  struct Reached {
    std::vector<double> end_s, charge;
  };

  const std::vector<PlannedEvent>& events_;
  std::map<Key, Reached> reached_;
  std::size_t cases_ = 0;
};

}  // namespace lsos
