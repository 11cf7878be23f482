#include "lua/study/study_record.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/files.h"
#include "lua/host/version.h"
#include "mission/model/site.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
// What a study is made of, each with a digest or text that changes with it.
using Parts = std::map<std::string, std::string>;

bool has_raster(const TerrainSpec& terrain) {
  const auto is_raster = [](const Surface& layer) {
    return std::holds_alternative<RasterSurface>(layer);
  };
  return std::ranges::any_of(terrain.layers, is_raster) || terrain.beyond ||
         std::ranges::any_of(terrain.soil_patches,
                             [](const SoilPatch& patch) { return patch.raster.has_value(); });
}

std::string setting_text(const Variation& variation) {
  return fmt::format("{}{} {}", variation.is_factor ? "factor " : "", to_string(variation.form),
                     fmt::join(variation.values, ", "));
}

std::string setting_text(const Gathering& gathering) {
  return fmt::format("{} {} {} {} {} {}", static_cast<int>(gathering.take), gathering.rover,
                     gathering.event, gathering.quantity, gathering.condition, gathering.path);
}

Parts parts_of(const StudyFiles& files) {
  const Study& study = files.study;
  Parts parts{{"the program", program_build()},
              {fmt::format("the plan {}", files.study.plan), files.base.plan.hash()},
              {"seed of the study", fmt::format("{}", study.seed)},
              {"sampling of the study", to_string(study.sampling)},
              {"interval_s of the study", fmt::format("{}", files.interval_s)}};
  for (const auto& [name, digest] : files.scripts) parts[name] = digest;
  for (const Parameter& parameter : files.parameters) {
    parts[fmt::format("vary '{}' of the study", parameter.name())] =
        setting_text(parameter.variation);
  }
  for (const Gathering& gathering : study.gathered) {
    parts[fmt::format("gather '{}' of the study", gathering.name)] = setting_text(gathering);
  }
  if (study.sampling == Sampling::latin_hypercube) {
    parts["cases of the study, which are another Latin hypercube"] = fmt::format("{}", files.cases);
  }
  const Plan& plan = files.base.plan;
  for (const auto& [name, terrain] : files.terrains) {
    if (!has_raster(terrain)) continue;
    parts[fmt::format("the ground of {}", fs::path(name).filename().string())] =
        ground_at(terrain, *plan.mission.planet, site_of(plan), plan.mission.seed)->hash();
  }
  return parts;
}

// "rover_SEV_sha256" as people say it.
std::string shown_part(const std::string& part) {
  constexpr std::string_view ending = "_sha256";
  if (!part.ends_with(ending)) return part;
  std::string name = part.substr(0, part.size() - ending.size());
  std::replace(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(name.find('_') + 1), '_',
               ' ');
  return "the script of " + name;
}

Json parts_json(const StudyFiles& files, const Parts& parts) {
  Json varied = Json::array();
  for (const Parameter& parameter : files.parameters) varied.push_back(parameter.name());
  return {{"program", "lsos-host"},
          {"program_version", program_version},
          {"study", files.study.name},
          {"doc", files.study.doc},
          {"study_file", fs::absolute(files.study.file).lexically_normal().string()},
          {"plan", fs::absolute(files.plan_file).lexically_normal().string()},
          {"seed", files.study.seed},
          {"sampling", to_string(files.study.sampling)},
          {"cases", files.cases},
          {"varied", varied},
          {"interval_s", files.interval_s},
          {"hashes", parts}};
}

// Whether two records are alike but for where their study's files are, which each process calls as
// its user does, and when the study was over.
bool are_alike(Json a, Json b) {
  if (!a.is_object() || !b.is_object()) return false;
  for (const char* key : {"study_file", "plan", "last_case"}) {
    a.erase(key);
    b.erase(key);
  }
  return a == b;
}

// Several processes of a cluster may write the same at once, on machines with the same numbers of
// processes.
void write_record(const std::string& folder, const Json& json) {
  std::array<char, 256> machine{};
  gethostname(machine.data(), machine.size() - 1);
  const std::string file = folder + "/" + study_file,
                    own = fmt::format("{}.{}.{}", file, machine.data(), getpid());
  write_file(own, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  fs::rename(own, file);
}

// The record in the folder; null where there is none.
Json record_in(const std::string& folder) {
  const std::string file = folder + "/" + study_file;
  std::error_code absent;
  if (!fs::exists(file, absent)) return nullptr;
  Json json = Json::parse(read_file(file).value_or(""), nullptr, false);
  const bool is_ours = json.is_object() && json.contains("hashes") && json["hashes"].is_object() &&
                       json.contains("cases") && json["cases"].is_number_integer();
  if (!is_ours) throw InputError({file}, "is not of lsos-host; -o names another folder");
  return json;
}

void refuse_changes(const Json& record, const Parts& parts, const std::string& folder) {
  const auto before = record["hashes"].get<Parts>();
  std::vector<std::string> changed;
  for (const auto& [name, digest] : parts) {
    const auto known = before.find(name);
    if (known == before.end() || known->second != digest) changed.push_back(shown_part(name));
  }
  for (const auto& [name, digest] : before) {
    if (!parts.contains(name)) changed.push_back(shown_part(name));
  }
  if (changed.empty()) return;
  throw InputError({folder}, fmt::format("its cases were made with another state of {}: -o names a "
                                         "new folder, or what has changed is put back",
                                         fmt::join(changed, ", ")));
}

// Locks keep two processes out of a case; some file systems of clusters have none.
void check_locks(const std::string& folder) {
  const std::string file = folder + "/" + study_file;
  const int descriptor = open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor < 0) throw InputError({file}, "cannot be written");
  const bool has_locks = flock(descriptor, LOCK_SH | LOCK_NB) == 0 || errno == EWOULDBLOCK;
  const int reason = errno;
  close(descriptor);
  if (has_locks) return;
  throw InputError({folder}, fmt::format("its file system has no locks ({}), which keep two "
                                         "processes out of one case: Lustre has them when it is "
                                         "mounted with -o flock; -o names another folder",
                                         std::strerror(reason)));
}

}  // namespace

void open_study_folder(const StudyFiles& files, const std::string& folder) {
  std::error_code why;
  const Json record = record_in(folder);
  const Parts parts = parts_of(files);
  if (record.is_null()) {
    const bool has_files = fs::is_directory(folder, why) && !fs::is_empty(folder, why);
    if (has_files && !fs::exists(folder + "/cases", why)) {
      throw InputError({folder},
                       "holds files that are no study of lsos-host, and these are never touched; "
                       "name another folder with -o");
    }
  } else {
    refuse_changes(record, parts, folder);
  }
  fs::create_directories(folder + "/cases", why);
  if (why) throw InputError({folder}, why.message());
  Json json = parts_json(files, parts);
  if (!are_alike(json, record)) {
    if (record.contains("last_case")) json["last_case"] = record["last_case"];
    write_record(folder, json);
  }
  check_locks(folder);
}

void check_study_folder(const StudyFiles& files, const std::string& folder) {
  const Json record = record_in(folder);
  if (record.is_null()) throw InputError({folder}, "holds no study; 'lsos-host sweep' runs one");
  refuse_changes(record, parts_of(files), folder);
}

void note_last_case(const std::string& folder, const std::optional<std::int64_t>& number) {
  Json record = record_in(folder);
  if (record.is_null()) return;
  const Json before = record;
  record.erase("last_case");
  if (number) record["last_case"] = *number;
  if (record != before) write_record(folder, record);
}

std::int64_t cases_of_folder(const std::string& folder) {
  const Json record = record_in(folder);
  if (record.is_null()) throw InputError({folder}, "holds no study; 'lsos-host sweep' runs one");
  return record.value("last_case", record["cases"].get<std::int64_t>());
}

}  // namespace lsos
