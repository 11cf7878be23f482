// A plan of the studies in the tests of this folder.
#pragma once

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

#include "edit/plan_document.h"
#include "plan/kml_reader.h"
#include "study/case_plan.h"
#include "study/parameter.h"
#include "unit/plan/plan_fixture.h"

namespace lsos::test {

// Two rovers, one of them with a point in its name, and events of the first.
class StudyPlan {
 public:
  StudyPlan()
      : text(document(mission({{"Seed", "7"}}) +
                      rover("A", {{"InitialCharge", "0.8"}, {"Variant", "mass_kg = 3"}}) +
                      rover("B.2") + event("Route", "out", "A", 10, {{"Speed", "2 m/s"}}, line()) +
                      pause("rest", "A", 20) + pause("rest", "B.2", 10) +
                      event("Wait", "noon", "A", 30, {{"Until", "2026-07-01T12:00:00Z"}}))),
        known(declarations()),
        plan(read(text)) {}

  Plan read(const std::string& kml) const {
    Faults faults;
    Plan read = read_plan("plan.kml", parse_kml(kml, "plan.kml"), known, faults);
    for (const Fault& fault : faults.sorted()) {
      EXPECT_NE(fault.severity, Severity::error) << to_string(fault);
    }
    return read;
  }

  ParameterContext context() const {
    return {plan, known,
            [](const Address& address) -> std::optional<double> {
              if (address.name == "Speed") return 2.0;
              if (address.name == "battery.capacity_j") return 1e8;
              return {};
            },
            [](const std::string& key) { return find_unit(key.ends_with("_j") ? "J" : "1"); }};
  }

  // The parameters of these variations, which must be without faults.
  std::vector<Parameter> parameters(const std::vector<Variation>& varied) const {
    Study study;
    study.varied = varied;
    Faults faults;
    std::vector<Parameter> found = parameters_of(study, context(), faults);
    for (const Fault& fault : faults.sorted()) ADD_FAILURE() << to_string(fault);
    return found;
  }

  // The faults of one variation, joined.
  std::string faults_of(const Variation& variation) const {
    Study study;
    study.varied = {variation};
    Faults faults;
    parameters_of(study, context(), faults);
    std::string all;
    for (const Fault& fault : faults.sorted()) all += to_string(fault) + "\n";
    return all;
  }

  std::string text;
  Declarations known;
  Plan plan;
};

inline Variation vary(const std::string& of, Form form, const std::vector<std::string>& values,
                      bool is_factor = false) {
  return {{"s.lua", 7}, of, is_factor, form, values};
}

}  // namespace lsos::test
