#include "lua/app/command_options.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>

#include "base/quantity.h"

namespace lsos {

namespace {

std::string seed_fault(const std::string& text) {
  const Parsed<std::int64_t> seed = parse_integer(text);
  if (seed && *seed.value >= 0) return "";
  return "a whole number from 0 to 9223372036854775807 is wanted, found " + text;
}

}  // namespace

CommandOption& CommandOption::required() {
  option_->required();
  return *this;
}

CommandOption& CommandOption::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
  return *this;
}

CommandOption& CommandOption::between(int lowest, int highest) {
  option_->check(CLI::Range(lowest, highest));
  return *this;
}

CommandOption& CommandOption::seed() {
  option_->check(CLI::Validator(seed_fault, "0..9223372036854775807"));
  return *this;
}

CommandOption& CommandOption::separated_by(char delimiter) {
  option_->delimiter(delimiter);
  return *this;
}

CommandOption& CommandOption::repeated() {
  option_->allow_extra_args(false);
  return *this;
}

CommandOption& CommandOption::hidden() {
  option_->group("");
  return *this;
}

template <typename T>
CommandOption CommandOptions::add_option(const char* names, T& value, const char* what) {
  return CommandOption(app_->add_option(names, value, what));
}

template CommandOption CommandOptions::add_option(const char*, std::string&, const char*);
template CommandOption CommandOptions::add_option(const char*, std::vector<std::string>&,
                                                  const char*);
template CommandOption CommandOptions::add_option(const char*, int&, const char*);
template CommandOption CommandOptions::add_option(const char*, std::optional<int>&, const char*);
template CommandOption CommandOptions::add_option(const char*, std::uint64_t&, const char*);
template CommandOption CommandOptions::add_option(const char*, std::optional<std::uint64_t>&,
                                                  const char*);
template CommandOption CommandOptions::add_option(const char*, double&, const char*);
template CommandOption CommandOptions::add_option(const char*, std::optional<double>&, const char*);
template CommandOption CommandOptions::add_option(const char*, std::vector<double>&, const char*);

CommandOption CommandOptions::add_flag(const char* names, bool& value, const char* what) {
  return CommandOption(app_->add_flag(names, value, what));
}

CommandOption CommandOptions::add_flag(const char* names, std::function<void()> when_given,
                                       const char* what) {
  return CommandOption(app_->add_flag_callback(names, std::move(when_given), what));
}

void CommandOptions::set_footer(const std::string& text) { app_->footer(text); }

bool CommandOptions::has_option(const char* name) const {
  return app_->get_option_no_throw(name) != nullptr;
}

}  // namespace lsos
