#include "lua/host/saved_mission.h"

#include <fmt/format.h>

#include <set>

#include "base/archive.h"
#include "lua/host/version.h"

namespace lsos {

namespace {

void archive(Archive& a, SavedMission& mission) {
  LSOS_ARCHIVE(a, mission.build, mission.plan_file, mission.values, mission.every, mission.soil,
               mission.from, mission.state);
}

std::string value(const std::map<std::string, std::string>& values, const std::string& key) {
  const auto found = values.find(key);
  return found == values.end() ? "none" : found->second;
}

// "event_Route_sha256" is "the event script Route".
std::string key_words(const std::string& key) {
  if (key == "plan_sha256") return "the plan";
  if (key == "from_log_sha256") return "the log of the run with whose end it began";
  if (key == "terrain_sha256") return "the ground (its rasters, or what the terrain script adds)";
  for (const char* kind : {"event", "rover", "terrain", "soil", "lib"}) {
    const std::string head = fmt::format("{}_", kind), tail = "_sha256";
    if (!key.starts_with(head) || !key.ends_with(tail)) continue;
    const std::string name = key.substr(head.size(), key.size() - head.size() - tail.size());
    return fmt::format("the {} script {}", kind, name);
  }
  return fmt::format("'{}'", key);
}

// Between the time of a change of the renderer and the new one.
constexpr std::string_view goes_on = " on ";

// The last one in renderers_text().
std::string last_renderer(const std::string& text) {
  const std::size_t change = text.rfind(", from ");
  const std::size_t at = change == std::string::npos ? change : text.find(goes_on, change);
  return at == std::string::npos ? text : text.substr(at + goes_on.size());
}

}  // namespace

std::string to_bytes(SavedMission mission) {
  Archive a = Archive::writer();
  archive(a, mission);
  return a.bytes();
}

SavedMission saved_mission(const std::string& bytes) {
  SavedMission mission;
  Archive a = Archive::reader(bytes);
  archive(a, mission);
  if (!a.is_exhausted()) throw Archive::Mismatch("saved mission is longer than expected");
  return mission;
}

std::string renderers_text(const std::string& saved, const std::string& renderer, SimTime time) {
  if (last_renderer(saved) == renderer) return saved;
  return fmt::format("{}, from {:.6g} s{}{}", saved, seconds(time), goes_on, renderer);
}

Faults differences(const SavedMission& saved, const std::string& build,
                   const std::map<std::string, std::string>& now, const std::string& folder,
                   bool is_renderer_allowed) {
  Faults faults;
  if (saved.build != build) {
    faults.error({folder},
                 fmt::format("was written by another build of lsos-host ({}; this one is {}): only "
                             "that one can go on with it",
                             value(saved.values, "program_version"), program_version));
  }
  std::set<std::string> keys;
  for (const auto* values : {&saved.values, &now}) {
    for (const auto& [key, ignored] : *values) keys.insert(key);
  }
  for (const std::string& key : keys) {
    std::string before = value(saved.values, key);
    if (key == "renderer") before = last_renderer(before);
    const std::string after = value(now, key);
    if (before == after || key == "program_version") continue;
    if (key != "renderer") {
      faults.error({folder},
                   fmt::format("{} is not what was run: put it back, or run the plan again",
                               key_words(key)));
      continue;
    }
    const std::string text = fmt::format(
        "light and sight were drawn by {}, and would be by {} from here on", before, after);
    if (is_renderer_allowed) {
      faults.warning({folder}, text + ": the log is not that of a run in one piece");
    } else {
      faults.error({folder}, text + ": --allow-renderer goes on nevertheless");
    }
  }
  return faults;
}

}  // namespace lsos
