// Computes the digest of a plan's contents. Each value is written with its name and length, so that
// no two different plans give the same text; numbers are written exactly.
#include <fmt/format.h>

#include "base/sha256.h"
#include "plan/plan.h"

namespace lsos {

namespace {

class Digest {
 public:
  void text(std::string_view name, std::string_view text) {
    sha_.add(fmt::format("{}:{}:", name, text.size()));
    sha_.add(text);
    sha_.add("\n");
  }
  void integer(std::string_view name, std::int64_t value) { text(name, fmt::format("{}", value)); }
  void number(std::string_view name, double value) { text(name, fmt::format("{:a}", value)); }
  void place(std::string_view name, const Geodetic& place) {
    number(name, place.lon_rad);
    number(name, place.lat_rad);
    number(name, place.height_m);
  }
  void value(std::string_view name, const FieldValue& value) {
    struct Visitor {
      Digest& digest;
      std::string_view name;
      void operator()(bool flag) const { digest.integer(name, flag); }
      void operator()(std::int64_t count) const { digest.integer(name, count); }
      void operator()(double quantity) const { digest.number(name, quantity); }
      void operator()(const std::string& words) const { digest.text(name, words); }
      void operator()(Instant instant) const { digest.integer(name, instant.tai_us); }
    };
    std::visit(Visitor{*this, name}, value);
  }
  std::string hex() { return sha_.hex(); }

 private:
  Sha256 sha_;
};

void add_mission(Digest& digest, const MissionInfo& mission) {
  digest.text("planet", mission.planet == nullptr ? "" : mission.planet->name);
  digest.integer("start_time", mission.start_time.tai_us);
  digest.text("terrain", mission.terrain.hashed());
  if (!mission.terrain_beyond.name.empty()) {
    digest.text("terrain_beyond", mission.terrain_beyond.hashed());
  }
  if (!mission.soil.empty()) digest.text("soil", mission.soil);
  if (!mission.soil_variant.empty()) digest.text("soil_variant", mission.soil_variant);
  if (mission.site) digest.place("site", *mission.site);
  digest.integer("seed", static_cast<std::int64_t>(mission.seed));
  digest.integer("log_interval", mission.log_interval.count());
  digest.integer("parked_log_interval", mission.parked_log_interval.count());
  // The default depends on scripts too, which the plan's hash does not cover.
  if (mission.has_max_duration) digest.integer("max_duration", mission.max_duration.count());
}

void add_rover(Digest& digest, const PlanRover& rover) {
  digest.text("rover", rover.id);
  digest.text("type", rover.type);
  digest.text("configuration", rover.configuration);
  if (!rover.variant.empty()) digest.text("variant", rover.variant);
  digest.place("start", rover.start);
  if (rover.heading_rad) digest.number("heading", *rover.heading_rad);
  digest.number("initial_charge", rover.initial_charge);
}

void add_asset(Digest& digest, const PlanAsset& asset) {
  digest.text("asset", asset.id);
  digest.text("type", asset.type);
  digest.place("position", asset.position);
  if (asset.antenna_height_m) digest.number("antenna_height", *asset.antenna_height_m);
}

void add_event(Digest& digest, const PlanEvent& event) {
  digest.text("event", event.type);
  digest.text("label", event.label);
  digest.text("rover_id", event.rover_id);
  digest.integer("sequence", event.sequence);
  digest.integer("geometry", static_cast<std::int64_t>(event.geometry.kind));
  for (const Geodetic& point : event.geometry.points) digest.place("point", point);
  for (const std::vector<Geodetic>& hole : event.geometry.holes) {
    digest.integer("hole", static_cast<std::int64_t>(hole.size()));
    for (const Geodetic& point : hole) digest.place("point", point);
  }
  for (const auto& [key, value] : event.params) digest.value(key, value);
  digest.integer("enabled", event.is_enabled);
  if (event.start_time) digest.integer("start_time", event.start_time->tai_us);
  for (const PlanEvent::Reference& awaited : event.start_after) {
    digest.text("after_rover", awaited.rover_id);
    digest.integer("after_sequence", awaited.sequence);
  }
  const auto add_condition = [&](const char* name, const PlanEvent::Condition& condition) {
    if (!condition.text.empty()) digest.text(name, condition.text);
  };
  add_condition("start_when", event.start_when);
  add_condition("skip_when", event.skip_when);
  add_condition("stop_when", event.stop_when);
  add_condition("warn_when", event.warn_when);
  if (event.timeout) digest.integer("timeout", event.timeout->count());
  digest.integer("on_failure", static_cast<std::int64_t>(event.on_failure));
  if (event.on_failure == OnFailure::go_to) digest.integer("go_to", event.go_to_sequence);
}

}  // namespace

std::string event_hash(const PlanEvent& event) {
  Digest digest;
  add_event(digest, event);
  return digest.hex();
}

std::string Plan::hash() const {
  Digest digest;
  add_mission(digest, mission);
  for (const PlanRover& rover : rovers) add_rover(digest, rover);
  for (const PlanAsset& asset : assets) add_asset(digest, asset);
  for (const PlanEvent& event : events) add_event(digest, event);
  return digest.hex();
}

}  // namespace lsos
