// Errors: faults of the user's input, and failed assertions of the program itself.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lsos {

// A place in a file that the user wrote. `line` 0 means the file as a whole.
struct Place {
  std::string file;
  int line = 0;
  std::string column = {};  // of a spreadsheet, "C": `line` is its row; "": the whole line

  auto operator<=>(const Place&) const = default;
};

enum class Severity { error, warning };

// One thing wrong with the input. `what` is lower case, without a full stop, and says what was
// found, what is allowed and, where there is one, the nearest valid name.
struct Fault {
  Severity severity = Severity::error;
  Place place;
  std::string what;
};

// For example "plans/a.kml:41: Route 'leg 2': Speed = -1: must be at least 0.05 m/s", in a
// spreadsheet "tasks.xlsx/Events:C7: ..."; a warning has "warning: " before the text.
std::string to_string(const Fault& fault);

// Thrown when the input (plan, script, raster, option) is wrong: exit code 2. Holds at least one
// error.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Fault> faults);
  InputError(Place place, std::string what);

  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

// Collects all faults of an input, which are then reported together.
class Faults {
 public:
  void error(Place place, std::string what);
  void warning(Place place, std::string what);
  void add(const std::vector<Fault>& faults);

  bool has_errors() const;
  // Each fault once, ordered by file and line.
  std::vector<Fault> sorted() const;
  // Throws InputError with all errors (not the warnings) if there are any.
  void throw_if_errors() const;

 private:
  std::vector<Fault> faults_;
};

// Levenshtein distance in bytes.
int edit_distance(std::string_view a, std::string_view b);

// "; did you mean 'Speed'?" when a known name is near enough to `name`, else ""; always "" for
// names longer than 64 bytes. Of two names one of which has one or two letters, one begins as the
// other.
std::string did_you_mean(std::string_view name, std::span<const std::string> known);

[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

// An assertion of the program failed (checked in every build): exit code 3.
class InternalError : public std::logic_error {
  using std::logic_error::logic_error;
};

}  // namespace lsos

#define LSOS_ASSERT(condition) \
  ((condition) ? void() : ::lsos::assertion_failed(#condition, __FILE__, __LINE__))
