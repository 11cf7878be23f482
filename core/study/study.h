// A study as its file says it: a plan, what of it varies and how, how many cases, what is gathered.
// Values are texts as a plan would have them; what they mean is known once the plan is read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"

namespace lsos {

enum class Sampling { random, latin_hypercube, sobol, grid };
const char* to_string(Sampling sampling);

enum class Form { list, range, uniform, normal, triangular, within };
const char* to_string(Form form);

// One thing that varies.
struct Variation {
  Place place;
  std::string of;  // address as written: "SEV1/20.Speed"
  bool is_factor = false;
  Form form = Form::list;
  // list: the values; range: from, to, step; uniform: from, to; normal: mean, deviation, min, max;
  // triangular: min, mode, max; within: the radius.
  std::vector<std::string> values = {};
};

// One number (or text) that is gathered of each case.
struct Gathering {
  enum class Take {
    summary,   // a value of summary.json
    at_start,  // a quantity when an event starts
    at_end,    // when it ends
    least,     // of a quantity over the mission
    greatest,
    share  // of the mission's time, while a condition holds
  };
  Place place;
  std::string name;  // of its column
  Take take = Take::summary;
  std::string rover;     // whose quantity
  std::string event;     // as written; then ROVER/SEQUENCE
  std::string quantity;  // of the log's samples
  std::string condition;
  std::string path;  // in summary.json: "rovers.SEV1.p95_slip", "events.SEV1/20.end_s"
};

// Which logs of cases are kept.
enum class Keep { none, failed, all };
const char* to_string(Keep keep);

// When a sweep stops before all cases have run.
struct StopRule {
  Place place;
  std::string of;                  // what is gathered, by its name, or share_completed
  std::optional<double> quantile;  // of it that is wanted, 0..1; none of share_completed
  double within = 0;               // half the width of its 95 % interval that is narrow enough, SI
  std::int64_t after = 30;         // not before so many cases
};
// The share of missions that complete.
inline constexpr const char* share_completed = "completed";

struct Study {
  Place place;
  std::string file;  // of the study
  std::string name;  // the file's, without .lua
  std::string doc;
  std::string plan;  // file, relative to the study's folder
  std::optional<std::int64_t> cases;
  std::uint64_t seed = 0;
  Sampling sampling = Sampling::random;
  std::vector<Variation> varied;
  std::vector<Gathering> gathered;
  double interval_s = 0;  // between two times of the bands; 0: by the plan
  Keep keep = Keep::none;
  std::optional<StopRule> stop_when;
};

// Greatest number of cases: their folders are named by six digits.
inline constexpr std::int64_t cases_max = 999'999;

}  // namespace lsos
