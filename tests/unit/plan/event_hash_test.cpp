// What counts in the hash of an event.
#include <gtest/gtest.h>

#include <set>

#include "plan/plan.h"

namespace lsos {
namespace {

TEST(EventHash, differs_by_each_condition_that_is_given) {
  std::set<std::string> hashes{event_hash({})};
  for (PlanEvent::Condition PlanEvent::*condition :
       {&PlanEvent::start_when, &PlanEvent::skip_when, &PlanEvent::stop_when,
        &PlanEvent::warn_when}) {
    PlanEvent event;
    (event.*condition).line = 7;
    EXPECT_TRUE(hashes.contains(event_hash(event))) << "a line is no content";
    (event.*condition).text = "charge < 0.3";
    EXPECT_TRUE(hashes.insert(event_hash(event)).second);
  }
}

}  // namespace
}  // namespace lsos
