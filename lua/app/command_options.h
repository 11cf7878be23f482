// The options and arguments of a command. Only command_options.cpp and main.cpp include the library
// that reads them: it lies in its headers alone, and takes ten seconds to compile.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace lsos {

// What may be said of an option once it is added.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option* option) : option_(option) {}

  CommandOption& required();
  CommandOption& one_of(const std::vector<std::string>& words);
  CommandOption& between(int lowest, int highest);
  // A seed, 0 to 9223372036854775807: the library would take -1 for the greatest number.
  CommandOption& seed();
  // Several values in one word: 0,0.2,0.5.
  CommandOption& separated_by(char delimiter);
  // Several values by repeating the option, one each time.
  CommandOption& repeated();
  // Accepted, but left out of the help.
  CommandOption& hidden();

 private:
  CLI::Option* option_;
};

class CommandOptions {
 public:
  explicit CommandOptions(CLI::App& app) : app_(&app) {}

  // `names` is "--seed" or "-o,--output" for an option, "PLAN" for an argument. `value` receives
  // what is given, later, and keeps its default otherwise. T: a string, a number, a std::optional
  // or a std::vector of one; command_options.cpp lists them.
  template <typename T>
  CommandOption add_option(const char* names, T& value, const char* what);

  // "--json" sets `value`; "!--no-report" clears it.
  CommandOption add_flag(const char* names, bool& value, const char* what);
  CommandOption add_flag(const char* names, std::function<void()> when_given, const char* what);

  // A text below the options in the help.
  void set_footer(const std::string& text);

  bool has_option(const char* name) const;

 private:
  CLI::App* app_;
};

}  // namespace lsos
