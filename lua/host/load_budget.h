// What scripts may take to load, all together.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "base/error.h"
#include "lua/runtime/script.h"
#include "lua/runtime/state.h"

namespace lsos {

// What the scripts of one folder that are not shipped may take to load, each within the limits of
// one call. The processor's time is a last resort, as that of one call.
class LoadBudget {
 public:
  explicit LoadBudget(LuaState& lua) : lua_(lua), context_(lua.context()) {}

  // Loads the script by `load`, or adds that there is nothing left for it.
  void spend(const Script& script, Faults& faults, const std::function<void()>& load);

 private:
  struct Spent {
    std::int64_t instructions = 0;
    double cpu_s = 0;
    std::size_t kept = 0;  // bytes
  };

  std::size_t kept_since(std::size_t bytes_before);

  LuaState& lua_;
  LuaContext& context_;
  std::map<std::string, Spent> spent_;  // by folder of scripts
};

}  // namespace lsos
