#include "access/refusal.h"

namespace lsos {

namespace {

thread_local std::string refusal;

}  // namespace

void refuse(const std::string& why) {
  if (refusal.empty()) refusal = why;
}

const std::string& last_refusal() { return refusal; }

void forget_refusal() { refusal.clear(); }

}  // namespace lsos
