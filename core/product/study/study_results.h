// What study.gpkg holds, read back for the page and the map of a study.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "planet/body.h"
#include "product/study/study_columns.h"

namespace lsos {

struct BandValues {
  double p5 = 0, p50 = 0, p95 = 0;
};

struct StudyBand {
  std::string rover_id, quantity;
  std::vector<double> times_s, p5, p50, p95, share_reached;
};

struct StudyArrival {
  std::string rover_id;
  std::int64_t sequence = 0;
  std::string type, label;
  std::optional<BandValues> end_s, charge;
  double share_reached = 0;
  std::int64_t cases = 0;
  std::optional<Geodetic> place;  // where the event is drawn
};

// Where and why the mission of a case did not complete.
struct StudyEnd {
  std::int64_t number = 0;
  std::string rover_id;
  std::int64_t sequence = 0;
  std::string label, status, reason;
  std::optional<double> time_s;
  std::optional<Geodetic> place;
};

struct StudyResults {
  std::vector<StudyColumn> columns;             // of `cases`
  std::vector<std::vector<ColumnValue>> cases;  // a row a case
  std::vector<StudyBand> bands;
  std::vector<StudyArrival> arrivals;
  std::vector<StudyEnd> ends;

  // Throws InputError where there is no such column.
  std::size_t column(const std::string& name) const;
  // Texts are NaN, as is what a case has not.
  std::vector<double> numbers(std::size_t column) const;
  // The numbers of the cases, row by row.
  std::vector<std::int64_t> case_numbers() const;
  // "" where a case has none, or a number.
  std::vector<std::string> texts(std::size_t column) const;
  const StudyBand* band(const std::string& rover_id, const std::string& quantity) const;
};

// Throws InputError where the folder has no study.gpkg, or one of another form.
StudyResults read_study_results(const std::string& folder);

}  // namespace lsos
