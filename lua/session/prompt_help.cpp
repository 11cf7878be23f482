#include "lua/session/prompt_help.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "base/error.h"
#include "lua/session/reference.h"
#include "lua/session/session_api.h"

namespace lsos {

namespace {

// A signature, "lsos.sleep(time_s)", and its description below.
std::string entry_text(std::string_view signature, std::string_view doc) {
  return fmt::format("{}\n  {}", signature, doc);
}

struct Entry {
  std::string name;        // "lsos.sleep", "sim", "sim:run_for", "rover.speed_mps"
  std::string short_name;  // "sleep", "sim", "run_for", "speed_mps"
  std::string text;
};

// All entries of the help, in the order of lua/README.md.
std::vector<Entry> entries() {
  std::vector<Entry> all;
  for (const HandleType* type : scripted_objects()) {
    all.push_back({type->name, type->name, help_of(*type)});
    for (const HandleField& field : type->fields) {
      const std::string name = fmt::format("{}.{}", type->name, field.name);
      all.push_back(
          {name, field.name, entry_text(fmt::format("{}  ({})", name, field.type), field.doc)});
    }
    for (const HandleMethod& method : type->methods) {
      all.push_back({fmt::format("{}:{}", type->name, method.name), method.name,
                     entry_text(method.signature, method.doc)});
    }
  }
  const auto add_of_module = [&](const char* name, std::string_view signature, const char* doc) {
    all.push_back({fmt::format("lsos.{}", name), name, entry_text(signature, doc)});
  };
  for (const ApiFunction& entry : all_functions()) {
    add_of_module(entry.name, entry.signature, entry.doc);
  }
  for (const ApiConstant& entry : api_constants()) {
    add_of_module(entry.name, fmt::format("lsos.{}", entry.name), entry.doc);
  }
  for (const ApiSection& section : api_sections()) {
    for (const Constructor& entry : section.constructors) {
      add_of_module(entry.name, fmt::format("lsos.{} {{...}}", entry.name), entry.doc);
    }
  }
  return all;
}

}  // namespace

std::string general_help() {
  return "sim                 the simulation: help(sim)\n"
         "sim:run_for(60)     a minute, as '1 min' is; sim:step(n), sim:run_until(function), "
         "sim:step_phase(), sim:run()\n"
         "sim:where()         what all rovers do\n"
         "sim.rovers.SEV1     a rover: help(sim.rovers.SEV1)\n"
         "lsos.sim {...}      another one: help 'lsos.sim'\n"
         "help 'ev'           what scripts are given: ev, rover, sleep, ...\n"
         "x = 5               keeps a value; a local lasts to the end of its line\n"
         "Ctrl-C stops a run; quit or Ctrl-D ends.";
}

std::string help_of(const HandleType& type) {
  std::string text = fmt::format("{}: {}", type.name, type.doc);
  for (const HandleField& field : type.fields) {
    text += fmt::format("\n  .{:<18} {:<10} {}", field.name, field.type, field.doc);
  }
  for (const HandleMethod& method : type.methods) {
    text += fmt::format("\n  {}\n      {}", method.signature, method.doc);
  }
  return text;
}

std::string help_of(const std::string& name) {
  std::string found;
  std::vector<std::string> known;
  for (const Entry& entry : entries()) {
    known.push_back(entry.name);
    known.push_back(entry.short_name);
    if (name != entry.name && name != entry.short_name) continue;
    found += (found.empty() ? "" : "\n") + entry.text;
  }
  if (!found.empty()) return found;
  return fmt::format("there is no '{}'{}; help() says what there is", name,
                     did_you_mean(name, known));
}

}  // namespace lsos
