#include "product/study/study_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "product/study/gather.h"
#include "record/rows.h"
#include "record/table_file_reader.h"

namespace lsos {

namespace {

using Kind = StudyColumn::Kind;

double number_of(const ColumnValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return not_modelled;
}

std::string cell_text(const ColumnValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text == nullptr ? "" : *text;
}

// The rows of a layer, with their values by name.
class NamedRows {
 public:
  NamedRows(const TableFileReader& reader, const std::string& file, const std::string& layer)
      : file_(file), layer_(layer), columns_(reader.columns(layer)), rows_(reader.rows(layer)) {}

  std::size_t size() const { return rows_.size(); }
  const std::vector<TableColumn>& columns() const { return columns_; }
  const FileRow& row(std::size_t i) const { return rows_[i]; }
  double number(std::size_t i, const char* name) const { return number_of(value(i, name)); }
  std::int64_t whole(std::size_t i, const char* name) const {
    return std::llround(number(i, name));
  }
  std::string text(std::size_t i, const char* name) const { return cell_text(value(i, name)); }
  std::optional<double> number_if(std::size_t i, const char* name) const {
    const double found = number(i, name);
    return std::isfinite(found) ? std::optional(found) : std::nullopt;
  }
  std::optional<BandValues> band(std::size_t i, const std::string& name) const {
    const auto p50 = number_if(i, (name + "_p50").c_str());
    if (!p50) return {};
    return BandValues{number(i, (name + "_p5").c_str()), *p50, number(i, (name + "_p95").c_str())};
  }

 private:
  const ColumnValue& value(std::size_t i, const char* name) const {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (columns_[k].name == name) return rows_[i].values[k];
    }
    throw InputError({file_}, fmt::format("layer '{}' has no column '{}'", layer_, name));
  }

  std::string file_, layer_;
  std::vector<TableColumn> columns_;
  std::vector<FileRow> rows_;
};

Kind kind_of(const std::string& text) {
  for (const Kind kind : {Kind::parameter, Kind::summary, Kind::gathered, Kind::machine}) {
    if (text == to_string(kind)) return kind;
  }
  return Kind::summary;
}

std::vector<StudyColumn> columns_of(const NamedRows& meanings, const NamedRows& cases) {
  std::map<std::string, StudyColumn> known;
  for (std::size_t i = 0; i < meanings.size(); ++i) {
    const std::string name = meanings.text(i, "name");
    known[name] = {name,
                   kind_of(meanings.text(i, "kind")),
                   meanings.text(i, "address"),
                   meanings.text(i, "unit"),
                   meanings.text(i, "sentence"),
                   ColumnType::real};
  }
  std::vector<StudyColumn> columns;
  for (const TableColumn& column : cases.columns()) {
    StudyColumn meaning = known[column.name];
    meaning.name = column.name;
    meaning.type = column.type;
    columns.push_back(std::move(meaning));
  }
  return columns;
}

std::vector<StudyBand> bands_of(const NamedRows& rows) {
  std::vector<StudyBand> bands;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string rover_id = rows.text(i, "rover_id"), quantity = rows.text(i, "quantity");
    if (bands.empty() || bands.back().rover_id != rover_id || bands.back().quantity != quantity) {
      bands.push_back({rover_id, quantity, {}, {}, {}, {}, {}});
    }
    StudyBand& band = bands.back();
    band.times_s.push_back(rows.number(i, "time_s"));
    band.p5.push_back(rows.number(i, "p5"));
    band.p50.push_back(rows.number(i, "p50"));
    band.p95.push_back(rows.number(i, "p95"));
    band.share_reached.push_back(rows.number(i, "share_reached"));
  }
  return bands;
}

std::vector<StudyArrival> arrivals_in(const NamedRows& rows) {
  std::vector<StudyArrival> arrivals;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    arrivals.push_back({rows.text(i, "rover_id"), rows.whole(i, "sequence"), rows.text(i, "type"),
                        rows.text(i, "label"), rows.band(i, "end_s"), rows.band(i, "charge"),
                        rows.number(i, "share_reached"), rows.whole(i, "cases"),
                        rows.row(i).place});
  }
  return arrivals;
}

std::vector<StudyEnd> ends_in(const NamedRows& rows) {
  std::vector<StudyEnd> ends;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ends.push_back({rows.whole(i, "case"), rows.text(i, "rover_id"), rows.whole(i, "sequence"),
                    rows.text(i, "label"), rows.text(i, "status"), rows.text(i, "reason"),
                    rows.number_if(i, "time_s"), rows.row(i).place});
  }
  return ends;
}

}  // namespace

std::size_t StudyResults::column(const std::string& name) const {
  const auto found = std::ranges::find(columns, name, &StudyColumn::name);
  if (found == columns.end()) {
    throw InputError({study_table}, fmt::format("layer 'cases' has no column '{}'", name));
  }
  return static_cast<std::size_t>(found - columns.begin());
}

std::vector<std::int64_t> StudyResults::case_numbers() const {
  std::vector<std::int64_t> all;
  for (const double number : numbers(column("case"))) all.push_back(std::llround(number));
  return all;
}

std::vector<double> StudyResults::numbers(std::size_t column) const {
  std::vector<double> numbers;
  for (const auto& row : cases) numbers.push_back(number_of(row[column]));
  return numbers;
}

std::vector<std::string> StudyResults::texts(std::size_t column) const {
  std::vector<std::string> texts;
  for (const auto& row : cases) texts.push_back(cell_text(row[column]));
  return texts;
}

const StudyBand* StudyResults::band(const std::string& rover_id,
                                    const std::string& quantity) const {
  for (const StudyBand& band : bands) {
    if (band.rover_id == rover_id && band.quantity == quantity) return &band;
  }
  return nullptr;
}

StudyResults read_study_results(const std::string& folder) {
  const std::string file = folder + "/" + study_table;
  const TableFileReader reader(file);
  const NamedRows cases(reader, file, "cases");
  StudyResults results;
  results.columns = columns_of(NamedRows(reader, file, "columns"), cases);
  for (std::size_t i = 0; i < cases.size(); ++i) results.cases.push_back(cases.row(i).values);
  results.bands = bands_of(NamedRows(reader, file, "bands"));
  results.arrivals = arrivals_in(NamedRows(reader, file, "arrivals"));
  results.ends = ends_in(NamedRows(reader, file, "ends"));
  return results;
}

}  // namespace lsos
