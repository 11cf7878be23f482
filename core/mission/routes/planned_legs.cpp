#include "mission/routes/planned_legs.h"

#include <utility>

#include "base/random.h"
#include "base/sha256.h"
#include "route/route_planner.h"

namespace lsos {

namespace {

constexpr std::size_t kept_max = 2000;
constexpr std::size_t kept_parts = 50;
// Tags of a leg's key, from which its seed is made, and of what is kept.
constexpr std::string_view tag = "lsos-host planned legs";
constexpr std::string_view kept_tag = "lsos-host planned legs with gears";

std::string bytes_of(auto value) {
  Archive a = Archive::writer();
  a(value);
  return a.bytes();
}

using Legs = std::map<std::string, PlannedLeg>;

Legs legs_of(const std::string& bytes) {
  constexpr std::size_t hash_size = 64;
  if (bytes.size() < hash_size) return {};
  const std::string body = bytes.substr(hash_size);
  if (sha256_hex(body) != bytes.substr(0, hash_size)) return {};
  try {
    Archive a = Archive::reader(body);
    Legs legs;
    a.tag(kept_tag)(legs);
    return legs;
  } catch (const Archive::Mismatch&) {
    return {};  // the legs are planned again
  }
}

std::string archived(Legs& legs) {
  Archive a = Archive::writer();
  a.tag(kept_tag)(legs);
  return sha256_hex(a.bytes()) + a.bytes();
}

}  // namespace

PlannedLegs::PlannedLegs(const Ground& ground, std::uint64_t seed) : ground_(&ground), seed_(seed) {
  Archive a = Archive::writer();
  std::string terrain = ground.stamp();
  Geodetic origin = ground.site().origin();
  a.tag(tag)(terrain)(seed_)(origin.lon_rad)(origin.lat_rad)(origin.height_m);
  ground_key_ = a.bytes();
}

const PlannedLeg& PlannedLegs::leg(const DriveCost& cost, LegRequest request) {
  request.seed = 0;
  const std::string key = sha256_hex(ground_key_ + bytes_of(cost) + bytes_of(request));
  {
    const std::lock_guard lock(mutex_);
    requested_.insert(key);
    const auto known = legs_.find(key);
    if (known != legs_.end()) return known->second;
  }
  request.seed = mix_key(seed_, key);
  PlannedLeg planned = plan_leg(*ground_, cost, request);
  const std::lock_guard lock(mutex_);
  const PlannedLeg& leg = legs_.emplace(key, std::move(planned)).first->second;
  ++planned_;
  if (keep_ && ++not_yet_kept_ > planned_ / kept_parts) {
    keep_(kept_locked());
    not_yet_kept_ = 0;
  }
  return leg;
}

void PlannedLegs::recall(const std::string& bytes) {
  Legs legs = legs_of(bytes);
  const std::lock_guard lock(mutex_);
  legs_.merge(legs);
}

std::string PlannedLegs::kept() const {
  const std::lock_guard lock(mutex_);
  return kept_locked();
}

std::string PlannedLegs::kept_locked() const {
  if (planned_ == 0) return "";
  std::map<std::string, PlannedLeg> legs;
  for (const auto& [key, leg] : legs_) {
    if (requested_.contains(key)) legs.insert({key, leg});
  }
  for (auto other = legs_.begin(); other != legs_.end() && legs.size() < kept_max; ++other) {
    legs.insert(*other);
  }
  return archived(legs);
}

std::string merged_legs(const std::string& earlier, const std::string& later) {
  Legs legs = legs_of(later);
  for (const auto& [key, leg] : legs_of(earlier)) {
    if (legs.size() >= kept_max) break;
    legs.insert({key, leg});
  }
  return archived(legs);
}

}  // namespace lsos
