// A script host without scripts: event types whose phases are C++ functions. State is a number.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include "mission/port/script_host.h"

namespace lsos::test {

struct MockInstance {
  std::string type;
  EventArguments arguments;
  double state = 0;
};

// Settings of all routes that mock events plan.
inline RouteSettings mock_route_settings() {
  RouteSettings settings;
  settings.slope_max_rad = 0.35;
  return settings;
}

class MockHost : public ScriptHost {
 public:
  using Phase = std::function<PhaseAnswer(MockInstance&, PhaseContext&)>;

  // The first phase of a type is its start.
  void add(const std::string& type, const std::string& phase, Phase function) {
    EventDeclaration& declaration = declarations_.events[type];
    declaration.name = type;
    if (declaration.start_phase.empty()) declaration.start_phase = phase;
    declaration.phases.push_back({phase, "", ""});
    phases_[{type, phase}] = std::move(function);
  }
  void set_place(const std::string& type, const std::string& file, int line) {
    declarations_.events[type].place.file = file;
    declarations_.events[type].phases.back().line = line;
  }
  void set_drives(const std::string& type) { declarations_.events[type].drives = true; }

  void set_goes_on_without_power(const std::string& type) {
    declarations_.events[type].goes_on_without_power = true;
  }

  void set_plans(const std::string& type) {
    set_drives(type);
    planning_.insert(type);
  }

  const Declarations& declarations() const override { return declarations_; }
  std::optional<RouteSettings> route_settings(const std::string& type, const EventArguments&,
                                              Instant) override {
    return planning_.contains(type) ? std::optional(mock_route_settings()) : std::nullopt;
  }
  ScriptInstance begin(const std::string& type, const EventArguments& arguments) override {
    instances_[++last_] = {type, arguments, 0};
    return last_;
  }
  PhaseAnswer run_phase(ScriptInstance id, const std::string& phase,
                        PhaseContext& context) override {
    ++calls;
    return phases_.at({instances_.at(id).type, phase})(instances_.at(id), context);
  }
  std::string run_abort(ScriptInstance, PhaseContext& context) override {
    ++aborts;
    context.rover.brake();
    return "";
  }
  void end(ScriptInstance id) override { instances_.erase(id); }
  std::string save(ScriptInstance id) override { return std::to_string(instances_.at(id).state); }
  void restore(ScriptInstance id, const std::string& bytes) override {
    instances_.at(id).state = std::stod(bytes);
  }

  static inline int calls = 0;
  static inline int aborts = 0;

 private:
  Declarations declarations_;
  std::set<std::string> planning_;
  std::map<std::pair<std::string, std::string>, Phase> phases_;
  std::map<ScriptInstance, MockInstance> instances_;
  ScriptInstance last_ = 0;
};

}  // namespace lsos::test
