// A file that others see only once it is whole.
#pragma once

#include <string>
#include <string_view>

namespace lsos {

// A new file in the folder of `file`, without a name where the file system has such files, else
// under a name that was free. Nothing is ever written into what lay there before, be it a link, a
// pipe or a half-written file of another program; and nothing is left when the program ends first.
//
// All functions throw InputError where the place cannot be written to, is a folder or is no file;
// otherwise OutputError with the reason, e.g. a full disk.
class WholeFile {
 public:
  enum class Kind { unnamed, named };

  explicit WholeFile(const std::string& file, Kind kind = Kind::unnamed);
  // Removes what was not put in place.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(std::string_view bytes);
  int descriptor() const { return descriptor_; }
  // A name under which this process, or a child that inherits the descriptor, can open the file.
  std::string open_name() const;

  // Gives the file its name. A file or link of that name is replaced: a reader finds the old file
  // or the new one, never half of one.
  void replace();
  // The same, but refuses a name that is taken.
  void place();

 private:
  bool make_unnamed();
  void make_named();
  // Links an unnamed file under a name; false where that is taken.
  bool link(const std::string& name);
  // Finds a free name for the part.
  template <class Take>
  void take_free_name(Take take);
  void check_target() const;
  void close();
  [[noreturn]] void refuse(int error) const;

  std::string file_;  // as the user knows it
  std::string name_;  // in its folder
  std::string part_;  // its name until it is put in place; "": none
  int folder_ = -1, descriptor_ = -1;
};

// Suffix of the name, if any, that a file has until it is whole. No other program has it: browsers
// name a download that is under way "report.html.part".
inline constexpr std::string_view part_suffix = ".lsos-host.part";

}  // namespace lsos
