#include "product/study/case_courses.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "base/files.h"
#include "product/study/case_record.h"
#include "product/study/case_series.h"
#include "record/rows.h"

namespace lsos {

namespace {

enum SeriesQuantity : std::size_t {
  charge_series,
  distance_series,
  longitude_series,
  latitude_series
};  // of series_quantities

Vec2 on_map_m(const SiteFrame& site, double lon_deg, double lat_deg) {
  const Vec3 p_S_m = site.p_S_m(geodetic_from_degrees(lon_deg, lat_deg, site.origin().height_m));
  return {p_S_m.x(), p_S_m.y()};
}

std::vector<std::string> rovers_of(const StudyResults& results) {
  std::vector<std::string> ids;
  for (const StudyBand& band : results.bands) {
    if (std::ranges::find(ids, band.rover_id) == ids.end()) ids.push_back(band.rover_id);
  }
  return ids;
}

// How many times of the bands lie between two that are shown.
std::size_t stride_for(std::size_t times, std::size_t times_max) {
  return std::max<std::size_t>(1, (times + times_max - 1) / std::max<std::size_t>(1, times_max));
}

// Reads the courses of one rover, case by case.
class CourseReader {
 public:
  CourseReader(const std::string& rover_id, const StudyResults& results, const SiteFrame& site,
               const CourseLimits& limits, std::size_t values_max)
      : site_(site) {
    const StudyBand* band = results.band(rover_id, series_quantities[longitude_series]);
    const std::size_t times = band == nullptr ? 0 : band->times_s.size();
    const double interval_s = times > 1 ? band->times_s[1] - band->times_s[0] : 1;
    const std::size_t cases =
        std::max<std::size_t>(1, std::min(limits.cases, results.cases.size()));
    constexpr std::size_t times_min = 12;
    stride_ = stride_for(times, std::max(times_min, values_max / cases));
    spread_stride_ = stride_for(times, limits.spreads);
    courses_.rover_id = rover_id;
    courses_.interval_s = interval_s * static_cast<double>(stride_);
    courses_.spread_interval_s = interval_s * static_cast<double>(spread_stride_);
    courses_.times = (times + stride_ - 1) / stride_;
    courses_.spreads.resize((times + spread_stride_ - 1) / spread_stride_);
  }

  void add(const SeriesFile* series, bool is_shown) {
    std::array<std::vector<double>, series_quantities.size()> values;
    for (std::size_t i = 0; series != nullptr && i < values.size(); ++i) {
      const bool is_place = i == longitude_series || i == latitude_series;
      if (!is_place && !is_shown) continue;
      values[i] = series->values(courses_.rover_id, i, 0, series->count(courses_.rover_id));
    }
    std::vector<std::optional<Vec2>> places_m;
    for (std::size_t k = 0; k < values[longitude_series].size(); ++k) {
      const bool is_wanted = k % spread_stride_ == 0 || (is_shown && k % stride_ == 0);
      places_m.push_back(is_wanted ? std::optional(on_map_m(site_, values[longitude_series][k],
                                                            values[latitude_series][k]))
                                   : std::nullopt);
    }
    for (std::size_t k = 0; k < courses_.spreads.size(); ++k) {
      const std::size_t at = k * spread_stride_;
      if (at < places_m.size() && places_m[at]->allFinite()) courses_.spreads[k].add(*places_m[at]);
    }
    if (!is_shown) return;
    for (std::size_t k = 0; k < courses_.times; ++k) {
      const std::size_t at = k * stride_;
      const bool is_in = at < places_m.size();
      courses_.x_m.push_back(is_in ? places_m[at]->x() : not_modelled);
      courses_.y_m.push_back(is_in ? places_m[at]->y() : not_modelled);
      courses_.charge.push_back(is_in ? values[charge_series][at] : not_modelled);
      courses_.distance_m.push_back(is_in ? values[distance_series][at] : not_modelled);
    }
  }

  RoverCourses take() { return std::move(courses_); }

 private:
  const SiteFrame& site_;
  std::size_t stride_ = 1, spread_stride_ = 1;
  RoverCourses courses_;
};

// Adds where and when the case ended each event that it completed.
void add_places(const CaseRecord* record, const StudyResults& results, const SiteFrame& site,
                bool is_shown, std::vector<EventPlaces>& events) {
  std::map<std::pair<std::string, std::int64_t>, const CaseRecord::Event*> ended;
  for (std::size_t i = 0; record != nullptr && i < record->events.size(); ++i) {
    const CaseRecord::Event& event = record->events[i];
    if (event.status == "completed" && event.place) {
      ended[{event.rover_id, event.sequence}] = &event;
    }
  }
  for (std::size_t i = 0; i < events.size(); ++i) {
    const StudyArrival& arrival = results.arrivals[i];
    const auto found = ended.find({arrival.rover_id, arrival.sequence});
    const CaseRecord::Event* event = found == ended.end() ? nullptr : found->second;
    if (event != nullptr) {
      events[i].spread.add(on_map_m(site, lon_deg(*event->place), lat_deg(*event->place)));
    }
    if (!is_shown) continue;
    events[i].ended_s.push_back(event == nullptr ? not_modelled
                                                 : event->end_s.value_or(not_modelled));
  }
}

}  // namespace

CaseCourses read_courses(const std::string& folder, const StudyResults& results,
                         const SiteFrame& site, const CourseLimits& limits) {
  const std::vector<std::string> ids = rovers_of(results);
  constexpr std::size_t quantities = 4;
  std::vector<CourseReader> readers;
  for (const std::string& id : ids) {
    readers.emplace_back(id, results, site, limits, limits.values / quantities / ids.size());
  }
  CaseCourses courses;
  courses.events.resize(results.arrivals.size());
  const std::vector<std::int64_t> numbers = results.case_numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::string of_case = case_folder(folder, numbers[i]);
    const std::string file = of_case + "/" + series_file;
    std::optional<SeriesFile> series;
    if (std::filesystem::exists(file)) series.emplace(file);
    const bool is_shown = i < limits.cases;
    for (CourseReader& reader : readers) reader.add(series ? &*series : nullptr, is_shown);
    const auto record = read_case_record(read_file(of_case + "/" + case_file).value_or(""));
    add_places(record ? &*record : nullptr, results, site, is_shown, courses.events);
  }
  for (CourseReader& reader : readers) courses.rovers.push_back(reader.take());
  return courses;
}

}  // namespace lsos
