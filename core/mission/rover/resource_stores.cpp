#include "mission/rover/resource_stores.h"

#include <algorithm>
#include <cmath>

namespace lsos {

ResourceStores::ResourceStores(std::span<const ResourceSpec> specs) {
  for (const ResourceSpec& resource : specs) at_first_[resource.name] = resource.amount;
  amounts_ = at_first_;
}

void ResourceStores::begin_with(const std::map<std::string, double>& amounts) {
  for (const auto& [name, amount] : amounts) amounts_.at(name) = amount;
}

std::optional<double> ResourceStores::amount(const std::string& name) const {
  const auto found = amounts_.find(name);
  return found == amounts_.end() ? std::nullopt : std::optional(found->second);
}

bool ResourceStores::use(const std::string& name, double amount) {
  const auto found = amounts_.find(name);
  if (found == amounts_.end()) return false;
  // A remainder from rounding, as after taking equal parts, counts as none.
  constexpr double rounding = 1e-9;
  const double nothing = rounding * at_first_.at(name), left = found->second - amount;
  if (left < -nothing) return false;
  found->second = left > nothing ? left : 0;
  return true;
}

double ResourceStores::restock(const std::string& name, double amount) {
  const auto found = amounts_.find(name);
  if (found == amounts_.end()) return 0;
  const double most = at_first_.at(name), before = found->second;
  found->second = std::max(before, std::min(before + amount, most));
  return found->second - before;
}

bool ResourceStores::is_sound() const {
  return std::ranges::equal(amounts_, at_first_, [](const auto& now, const auto& first) {
    return now.first == first.first && std::isfinite(now.second);
  });
}

}  // namespace lsos
