#include "mission/model/breakable.h"

#include <fmt/format.h>

#include <algorithm>

#include "mission/port/note_json.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

using Mode = BreakageMode;

template <class Things>
std::vector<std::string> listed_names(const Things& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.emplace_back(thing.name);
  return names;
}

template <class Things>
std::vector<BreakablePart> numbered(const Things& things) {
  std::vector<BreakablePart> parts;
  for (const auto& thing : things) {
    parts.push_back({thing.name, "", static_cast<int>(parts.size())});
  }
  return parts;
}

std::string one_of(const Breakable& breakable) {
  return fmt::format("{} {}", breakable.what == Equipment::antenna ? "an" : "a", breakable.name);
}

// "; did you mean 'x'?" and what there is.
std::string advice(const std::string& name, const std::vector<std::string>& names) {
  const std::string hint = name.size() > 100 ? "" : did_you_mean(name, names);
  return fmt::format("{}; it has {}", hint, listed(names));
}

using Resolved = Parsed<BreakageOfParts>;

// Why the share that is lost cannot be so; "" when it can.
std::string share_fault(const Breakage& breakage, const Breakable& breakable, const Mode mode) {
  const bool may_have = breakable.has_share && mode == breakable.modes.back().mode;
  if (!breakage.share) {
    const bool is_wanted = mode == Mode::share_lost && !breakage.is_repair;
    return is_wanted ? "Share is missing: how much of its capacity is lost, 0 to 1" : "";
  }
  const std::string share = fmt::format("Share = {:g}: ", *breakage.share);
  if (breakage.is_repair) return share + "a repair makes it whole again";
  if (!breakable.has_share) {
    return share + fmt::format("{} breaks as a whole; a battery or a panel may lose a share",
                               one_of(breakable));
  }
  if (!may_have) {
    return share +
           fmt::format("goes with Mode = {}, not {}", breakable.modes.back().name, breakage.mode);
  }
  const bool is_share = *breakage.share >= 0 && *breakage.share <= 1;
  return is_share ? "" : share + "a share is 0 to 1";
}

Resolved modes_of(const Breakage& breakage, BreakageOfParts result) {
  const std::vector<Breakable::Mode>& modes = result.breakable->modes;
  const auto found = std::ranges::find_if(
      modes, [&](const Breakable::Mode& mode) { return breakage.mode == mode.name; });
  if (!breakage.mode.empty() && found == modes.end()) {
    const std::string known = fmt::format("{}", fmt::join(listed_names(modes), " or "));
    return {{},
            fmt::format("Mode = {}: does not fit {}{}", quoted(breakage.mode),
                        one_of(*result.breakable),
                        known.empty() ? ": Share says how much of its capacity is lost"
                                      : fmt::format(", which is {}", known))};
  }
  // With a share alone, the mode that has one is meant.
  const bool is_share_alone =
      breakage.mode.empty() && breakage.share && result.breakable->has_share;
  const Breakable::Mode& chosen = is_share_alone         ? modes.back()
                                  : found == modes.end() ? modes.front()
                                                         : *found;
  if (const std::string why = share_fault(breakage, *result.breakable, chosen.mode); !why.empty()) {
    return {{}, why};
  }
  result.modes = {chosen.mode};
  if (breakage.is_repair && breakage.mode.empty()) {
    result.modes.clear();
    for (const Breakable::Mode& mode : modes) result.modes.push_back(mode.mode);
  }
  result.share = breakage.share.value_or(1);
  return {std::move(result), ""};
}

}  // namespace

std::span<const Breakable> breakables() {
  static const std::vector<Breakable> table{
      {Equipment::wheel, "wheel", "all wheels", {{"locked", Mode::locked}, {"free", Mode::free}}},
      {Equipment::steering, "steering", "all steering motors", {{"stuck", Mode::stuck}}},
      {Equipment::limb, "limb", "all joints of limbs", {{"locked", Mode::locked}}},
      {Equipment::antenna, "antenna", "all antennas", {{"dead", Mode::dead}}},
      {Equipment::battery, "battery", "battery", {{"", Mode::share_lost}}, true},
      {Equipment::panel,
       "panel",
       "all panels",
       {{"stuck", Mode::stuck}, {"dead", Mode::dead}},
       true}};
  return table;
}

BreakableParts breakable_parts(const VehicleConfig& config, const PowerSpec& power,
                               std::span<const AntennaSpec> antennas) {
  BreakableParts parts;
  int wheels = 0, steerings = 0;
  for (const LinkConfig& link : config.links) {
    if (link.wheel) parts[Equipment::wheel].push_back({link.name, "", wheels++});
    if (link.steering) parts[Equipment::steering].push_back({link.name, "", steerings++});
  }
  for (const LimbConfig& limb : config.limbs) {
    for (const int joint : limb.joints) {
      const LinkConfig& link = config.links[static_cast<std::size_t>(joint)];
      parts[Equipment::limb].push_back({link.name, limb.name, joint});
    }
  }
  parts[Equipment::antenna] = numbered(antennas);
  if (power.battery) parts[Equipment::battery].push_back({"battery"});
  parts[Equipment::panel] = numbered(power.panels);
  return parts;
}

BreakableParts breakable_parts(const RoverModel& model, const std::string& configuration,
                               double gravity_mps2) {
  return breakable_parts(make_vehicle(model.spec, configuration, gravity_mps2), model.power,
                         antennas_of(model, 0));
}

std::vector<AntennaSpec> antennas_of(const RoverModel& model, double top_m) {
  if (!model.antennas.empty()) return model.antennas;
  AntennaSpec top;
  top.name = "top";
  top.p_B_m.z() = top_m;
  return {top};
}

Resolved resolve(const Breakage& breakage, const BreakableParts& parts, const std::string& owner) {
  const auto known = breakables();
  const auto breakable = std::ranges::find_if(
      known, [&](const Breakable& each) { return breakage.what == each.name; });
  if (breakable == known.end()) {
    const std::vector<std::string> names = listed_names(known);
    const std::string hint = did_you_mean(breakage.what, names);
    return {{},
            fmt::format("What = {}: nothing of that name can break{}", quoted(breakage.what),
                        hint.empty() ? fmt::format("; there are {}", listed(names)) : hint)};
  }
  const auto found = parts.find(breakable->what);
  if (found == parts.end() || found->second.empty()) {
    return {{}, fmt::format("{} has no {}", owner, breakable->name)};
  }
  BreakageOfParts result{&*breakable, {}, {}, 1, breakage.is_repair};
  std::vector<std::string> names;
  for (const BreakablePart& part : found->second) {
    if (!part.group.empty() && std::ranges::find(names, part.group) == names.end()) {
      names.push_back(part.group);
    }
    if (breakage.part.empty() || part.name == breakage.part || part.group == breakage.part) {
      result.parts.push_back(part);
    }
  }
  for (const BreakablePart& part : found->second) names.push_back(part.name);
  if (result.parts.empty()) {
    return {{},
            fmt::format("{} has no {} {}{}", owner, breakable->name, quoted(breakage.part),
                        advice(breakage.part, names))};
  }
  return modes_of(breakage, std::move(result));
}

std::string breakage_text(const Breakage& breakage, const BreakageOfParts& resolved) {
  const Breakable& breakable = *resolved.breakable;
  const bool are_all = breakage.part.empty() && resolved.parts.size() > 1;
  const bool is_named = !breakage.part.empty() && breakable.what != Equipment::battery;
  const std::string what = are_all    ? breakable.all
                           : is_named ? fmt::format("{} {}", breakable.name, quoted(breakage.part))
                                      : breakable.name;
  if (resolved.is_repair) return what + ": repaired";
  const Breakable::Mode& mode =
      *std::ranges::find(resolved.breakable->modes, resolved.modes.front(), &Breakable::Mode::mode);
  const bool is_part_lost =
      resolved.breakable->has_share && mode.mode == resolved.breakable->modes.back().mode;
  if (!is_part_lost) return fmt::format("{}: {}", what, mode.name);
  return fmt::format("{}: {:g} % of its {} lost", what, 100 * resolved.share,
                     resolved.breakable->what == Equipment::battery ? "capacity" : "area");
}

std::string breakage_json(const Breakage& breakage, const BreakageOfParts& resolved) {
  std::string mode;
  for (const Breakable::Mode& each : resolved.breakable->modes) {
    if (resolved.modes.size() == 1 && each.mode == resolved.modes.front()) mode = each.name;
  }
  const bool has_share = resolved.breakable->has_share && !resolved.is_repair &&
                         resolved.modes.front() == resolved.breakable->modes.back().mode;
  return fmt::format(R"({{"mode":{},"part":{},"repair":{},"share":{},"what":{}}})",
                     mode.empty() ? "null" : note_json(mode),
                     breakage.part.empty() ? "null" : note_json(breakage.part),
                     resolved.is_repair ? "true" : "false",
                     has_share ? note_json(resolved.share) : "null",
                     note_json(std::string(resolved.breakable->name)));
}

}  // namespace lsos
