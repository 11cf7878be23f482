// Reads the fields of one Placemark against their declarations: names, kinds, units, ranges.
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/parsed.h"
#include "plan/declaration.h"
#include "plan/kml_reader.h"

namespace lsos {

// Values by script key, in SI.
using FieldValues = std::map<std::string, FieldValue>;

// The value, or nullptr when there is none. The kind of the field determines T.
template <class T>
const T* find_value(const FieldValues& values, const std::string& key) {
  const auto found = values.find(key);
  return found == values.end() ? nullptr : &std::get<T>(found->second);
}

// The value of the event's number with that role, in SI; nullptr when it has none or the plan gives
// no value.
const double* find_number(const FieldValues& values, const EventDeclaration& declaration,
                          NumberRole role);
// The name that the event's field for things of that kind has; nullptr when it has no such field or
// the plan gives no value.
const std::string* find_name(const FieldValues& values, const EventDeclaration& declaration,
                             NameOf names);

// The subject of messages: "plan.kml", line of the Placemark, "Route 'leg 2'".
struct Subject {
  Place place;
  std::string name;
};

// The value as messages show it: "1 m/s", "true", "2026-07-01T12:00:00.000Z".
std::string format_value(const FieldDeclaration& declaration, const FieldValue& value);

class FieldReader {
 public:
  FieldReader(Subject subject, const SourceData& data, Faults& faults)
      : subject_(std::move(subject)), data_(data), faults_(faults) {}

  const Subject& subject() const { return subject_; }

  // Reports fields that are in none of the lists, that have no name, or that are given twice.
  void check_names(std::initializer_list<std::span<const FieldDeclaration>> known);

  // The fields that are given or have a default, by key. A missing required field and a wrong value
  // are faults, and are left out. Defaults that were filled in are appended to `defaults`.
  FieldValues read(std::span<const FieldDeclaration> declarations,
                   std::vector<std::string>* defaults);

  // Number of faults reported so far, without those of add().
  int fault_count() const { return fault_count_; }

  // The field, or nullptr when it is absent. An empty field counts as absent.
  const SourceField* find(const std::string& name) const;

  // Reports "Route 'leg 2': Speed = -1: WHAT" at the field's line; when the field is absent,
  // "Route 'leg 2': Speed: WHAT" at the Placemark's line.
  void error(const std::string& field_name, const std::string& what);
  // Adds faults found elsewhere that explain one of this Placemark.
  void add(const std::vector<Fault>& faults) { faults_.add(faults); }

 private:
  void report(const std::string& what);  // at the Placemark's line
  void report(const SourceField& field, const std::string& what);
  std::optional<FieldValue> parse(const FieldDeclaration& declaration, const SourceField& field);
  Parsed<FieldValue> parsed(const FieldDeclaration& declaration, const std::string& text) const;

  Subject subject_;
  const SourceData& data_;
  Faults& faults_;
  int fault_count_ = 0;
  std::vector<std::string> hints_;  // "; did you mean 'Speed'?"
};

}  // namespace lsos
