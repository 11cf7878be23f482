#include "access/refusal.h"

#include "access/open_budget.h"

namespace lsos {

namespace {

thread_local std::string refusal;

}  // namespace

void refuse(const std::string& why) {
  if (refusal.empty()) refusal = why;
}

const std::string& last_refusal() { return refusal; }

void forget_refusal() {
  refusal.clear();
  renew_open_budget();
}

}  // namespace lsos
