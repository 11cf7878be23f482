// A rover's charge, distance and place over the time of one case, on the times that all cases of a
// study share: what bands are made of once the logs are gone.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record/rows.h"

namespace lsos {

// Quantities of a series, as in layer `samples`.
inline constexpr std::array<const char*, 4> series_quantities{"charge", "distance_m", "lon_deg",
                                                              "lat_deg"};

// Collects a case's series from its samples.
class SeriesRecorder {
 public:
  SeriesRecorder(double interval_s, const std::vector<std::string>& rovers);

  // Rows come in the order of time. Between two rows values change evenly.
  void add(const SampleRow& row);
  // The bytes of the file.
  std::string bytes() const;

 private:
  struct Rover {
    std::optional<SampleRow> last;
    std::array<std::vector<double>, series_quantities.size()> values;
  };

  double interval_s_;
  std::map<std::string, Rover> rovers_;
};

inline constexpr const char* series_file = "series.bin";

// Reads parts of a series' file.
class SeriesFile {
 public:
  // Throws InputError where it is none.
  explicit SeriesFile(const std::string& file);

  double interval_s() const { return interval_s_; }
  // Number of times of a rover; 0 where it has none.
  std::size_t count(const std::string& rover) const;
  // Values of a quantity from the time with that index on, at most `count`; fewer at the end.
  std::vector<double> values(const std::string& rover, std::size_t quantity, std::size_t from,
                             std::size_t count) const;

 private:
  struct Part {
    std::string rover;
    std::size_t begin = 0, count = 0;  // of its first value in the file, and per quantity
  };
  const Part* part_of(const std::string& rover) const;

  std::string file_;
  double interval_s_ = 0;
  std::vector<Part> parts_;
};

// A row between two of one rover, in their proportion at `time`; quantities that one of them lacks
// are the earlier one's.
double between(double before, double after, double share);

}  // namespace lsos
