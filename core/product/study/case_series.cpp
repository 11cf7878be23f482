#include "product/study/case_series.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

#include "base/error.h"

namespace lsos {

namespace {

constexpr std::string_view mark = "lsos-host series 1\n";

std::array<double, series_quantities.size()> plotted_values(const SampleRow& row) {
  return {row.charge, row.distance_m, lon_deg(row.place), lat_deg(row.place)};
}

}  // namespace

double between(double before, double after, double share) {
  return std::isfinite(before) && std::isfinite(after) ? before + share * (after - before) : before;
}

SeriesRecorder::SeriesRecorder(double interval_s, const std::vector<std::string>& rovers)
    : interval_s_(interval_s) {
  for (const std::string& id : rovers) rovers_[id];
}

void SeriesRecorder::add(const SampleRow& row) {
  const auto found = rovers_.find(row.rover_id);
  if (found == rovers_.end()) return;
  Rover& rover = found->second;
  const SampleRow& last = rover.last ? *rover.last : row;
  const double from_s = seconds(last.time), to_s = seconds(row.time);
  const auto before = plotted_values(last), after = plotted_values(row);
  for (;;) {
    const double at_s = static_cast<double>(rover.values[0].size()) * interval_s_;
    if (at_s > to_s) break;
    const double share = to_s > from_s ? (at_s - from_s) / (to_s - from_s) : 1;
    for (std::size_t i = 0; i < before.size(); ++i) {
      rover.values[i].push_back(between(before[i], after[i], share));
    }
  }
  rover.last = row;
}

// A line of text that says what follows: doubles of this machine, rover by rover, quantity by
// quantity.
std::string SeriesRecorder::bytes() const {
  std::string head = fmt::format("{}{}\n{}\n", mark, interval_s_, rovers_.size());
  for (const auto& [id, rover] : rovers_) {
    head += fmt::format("{} {}\n", rover.values[0].size(), id);
  }
  for (const auto& [id, rover] : rovers_) {
    for (const std::vector<double>& values : rover.values) {
      head.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
    }
  }
  return head;
}

SeriesFile::SeriesFile(const std::string& file) : file_(file) {
  std::ifstream in(file, std::ios::binary);
  std::string line;
  std::size_t rovers = 0;
  const bool is_ours = std::getline(in, line) && line + "\n" == mark;
  if (is_ours && std::getline(in, line)) interval_s_ = std::stod(line);
  if (is_ours && std::getline(in, line)) rovers = std::stoul(line);
  for (std::size_t i = 0; i < rovers && std::getline(in, line); ++i) {
    const std::size_t blank = line.find(' ');
    parts_.push_back({line.substr(blank + 1), 0, std::stoul(line.substr(0, blank))});
  }
  if (!is_ours || !in || parts_.size() != rovers || !(interval_s_ > 0)) {
    throw InputError({file}, "is no series of a case");
  }
  auto begin = static_cast<std::size_t>(in.tellg());
  for (Part& part : parts_) {
    part.begin = begin;
    begin += part.count * series_quantities.size() * sizeof(double);
  }
}

const SeriesFile::Part* SeriesFile::part_of(const std::string& rover) const {
  for (const Part& part : parts_) {
    if (part.rover == rover) return &part;
  }
  return nullptr;
}

std::size_t SeriesFile::count(const std::string& rover) const {
  const Part* part = part_of(rover);
  return part == nullptr ? 0 : part->count;
}

std::vector<double> SeriesFile::values(const std::string& rover, std::size_t quantity,
                                       std::size_t from, std::size_t count) const {
  const Part* part = part_of(rover);
  if (part == nullptr || from >= part->count) return {};
  std::vector<double> values(std::min(count, part->count - from));
  std::ifstream in(file_, std::ios::binary);
  in.seekg(
      static_cast<std::streamoff>(part->begin + (quantity * part->count + from) * sizeof(double)));
  in.read(reinterpret_cast<char*>(values.data()),
          static_cast<std::streamsize>(values.size() * sizeof(double)));
  if (!in) throw InputError({file_}, "ends early");
  return values;
}

}  // namespace lsos
