#include "product/study/gather.h"

#include <filesystem>

#include "base/files.h"
#include "product/study/case_series.h"

namespace lsos {

namespace {

std::optional<CaseRecord> record_in(const std::string& folder, std::int64_t number) {
  const std::string file = case_folder(folder, number) + "/" + case_file;
  if (auto record = read_case_record(read_file(file).value_or(""))) return record;
  return read_case_record(read_file(not_run_file(folder, number)).value_or(""));
}

// A row of layer `ends`, of an event that failed, or at which a rover's mission ended.
struct End {
  std::int64_t number = 0;
  CaseRecord::Event event;
};

std::vector<End> ends_of(const CaseRecord& record) {
  std::vector<End> ends;
  if (record.status == "completed") return ends;
  for (const CaseRecord::Event& event : record.events) {
    const bool is_bad =
        event.status == "failed" || event.status == "incomplete" || event.status == "not_started";
    if (is_bad && event.place) ends.push_back({record.number, event});
  }
  return ends;
}

void write_ends(const std::vector<End>& ends, const std::vector<PlannedEvent>& events,
                TableFile& table) {
  table.begin({"ends",
               LayerGeometry::point,
               {{"case", ColumnType::integer},
                {"rover_id", ColumnType::text},
                {"sequence", ColumnType::integer},
                {"label", ColumnType::text},
                {"time_s"},
                {"status", ColumnType::text},
                {"reason", ColumnType::text}}});
  for (const auto& [number, event] : ends) {
    ColumnValue label;
    for (const PlannedEvent& planned : events) {
      const bool is_it = planned.rover_id == event.rover_id && planned.sequence == event.sequence;
      if (is_it) label = planned.label;
    }
    table.write({number, event.rover_id, event.sequence, label,
                 event.end_s ? ColumnValue{*event.end_s} : ColumnValue{}, event.status,
                 event.reason.empty() ? ColumnValue{} : ColumnValue{event.reason}},
                event.place);
  }
}

void write_columns(const std::vector<StudyColumn>& columns, TableFile& table) {
  table.begin({"columns",
               LayerGeometry::none,
               {{"name", ColumnType::text},
                {"kind", ColumnType::text},
                {"address", ColumnType::text},
                {"unit", ColumnType::text},
                {"sentence", ColumnType::text}}});
  const auto text = [](const std::string& words) {
    return words.empty() ? ColumnValue{} : ColumnValue{words};
  };
  for (const StudyColumn& column : columns) {
    table.write({column.name, std::string(to_string(column.kind)), text(column.address),
                 text(column.unit), text(column.sentence)});
  }
}

}  // namespace

Gathered gather(const GatherRequest& request) {
  Gathered gathered;
  const std::vector<StudyColumn> columns =
      study_columns(request.parameters, request.gathered, request.rovers);
  TableFile table(request.folder + "/" + study_table, request.crs);
  TableLayer cases{"cases", LayerGeometry::none, {}};
  for (const StudyColumn& column : columns) cases.columns.push_back({column.name, column.type});
  table.begin(cases);
  Arrivals arrivals(request.events);
  std::vector<End> ends;
  std::vector<std::string> series;
  for (std::int64_t number = 1; number <= request.cases; ++number) {
    const std::optional<CaseRecord> record = record_in(request.folder, number);
    if (!record) {
      ++gathered.missing;
      continue;
    }
    const std::string folder = case_folder(request.folder, number);
    table.write(row_of_case(columns, *record, read_file(folder + "/summary.json").value_or(""),
                            request.rovers));
    ++gathered.cases;
    if (record->status == not_run_status) {
      ++gathered.not_run;
      continue;
    }
    gathered.completed += record->status == "completed" ? 1 : 0;
    arrivals.add(*record);
    for (End& end : ends_of(*record)) ends.push_back(std::move(end));
    series.push_back(folder + "/" + series_file);
  }
  write_bands(series, request.rovers, table);
  arrivals.write(table);
  write_ends(ends, request.events, table);
  write_columns(columns, table);
  table.finish();
  return gathered;
}

}  // namespace lsos
