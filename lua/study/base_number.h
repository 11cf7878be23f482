// The numbers of a plan and its scripts that factors multiply.
#pragma once

#include <optional>
#include <string>

#include "edit/plan_document.h"
#include "lua/host/mission_files.h"
#include "study/address.h"

namespace lsos {

class BaseNumbers {
 public:
  // `kml`: the plan's document. `files` must outlive it.
  BaseNumbers(const MissionFiles& files, const std::string& kml);

  // The number at an address in SI, from the plan, its default, or the script of a rover or soil
  // with the plan's own Variant; absent where there is none.
  std::optional<double> of(const Address& address) const;

 private:
  std::optional<double> of_field(const Address& address) const;

  const MissionFiles& files_;
  PlanDocument document_;
};

}  // namespace lsos
