// What a case of a study leaves beside its summary: case.json.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/vector.h"
#include "planet/body.h"
#include "study/parameter.h"

namespace lsos {

struct CaseRecord {
  using Values = std::vector<std::pair<std::string, Draw::Value>>;

  // An event of the plan as it went.
  struct Event {
    std::string rover_id;
    std::int64_t sequence = 0;
    std::string status, reason;
    std::optional<double> end_s, charge;  // charge: at its end
    // Where the rover then was; of the first that did not end, where its mission ended.
    std::optional<Geodetic> place;
  };

  std::int64_t number = 0;
  std::uint64_t seed = 0;  // of its plan
  Values values;           // of the parameters, by their names, in SI
  Values gathered;         // by the names of what is gathered; without those that it has not
  std::vector<Event> events;
  std::string status;  // of the mission; "not_run" where there was none
  std::string reason;  // why it did not complete; "" where it did
  std::string log_sha256;
  double sim_s = 0;
  double wall_s = 0, cpu_s = 0;  // of the machine
};

inline constexpr const char* case_file = "case.json";
inline constexpr const char* not_run_status = "not_run";

// Why the mission did not complete: its first event that failed, or did not end; "" where it did.
// `summary`: the text of summary.json.
std::string reason_of(const std::string& summary);

std::string to_json(const CaseRecord& record);
// Absent where the text is no such record.
std::optional<CaseRecord> read_case_record(const std::string& json);

// "000012".
std::string case_name(std::int64_t number);
// DIR/cases/000012, and the folder in which it is made.
std::string case_folder(const std::string& study_folder, std::int64_t number);
std::string part_folder(const std::string& study_folder, std::int64_t number);
// The mark of a case that could not be run.
std::string not_run_file(const std::string& study_folder, std::int64_t number);

}  // namespace lsos
