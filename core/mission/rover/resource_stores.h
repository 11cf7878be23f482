// What a rover carries besides energy, and what is left of it.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "base/archive.h"
#include "power/power_spec.h"

namespace lsos {

class ResourceStores {
 public:
  explicit ResourceStores(std::span<const ResourceSpec> specs);
  // Sets how much there is as the mission begins. The names must be among the specs'.
  void begin_with(const std::map<std::string, double>& amounts);

  const std::map<std::string, double>& amounts() const { return amounts_; }
  // Absent when there is no such resource.
  std::optional<double> amount(const std::string& name) const;
  // Returns false when less is left; then nothing is taken.
  bool use(const std::string& name, double amount);
  // Adds an amount, up to what the spec says; returns what was added, 0 for an unknown resource.
  double restock(const std::string& name, double amount);

  void archive(Archive& a) { a(amounts_); }
  // Whether there are the resources of the specs.
  bool is_sound() const;

 private:
  std::map<std::string, double> at_first_, amounts_;
};

}  // namespace lsos
