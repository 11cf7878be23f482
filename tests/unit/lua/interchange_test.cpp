// Plans that are exported and imported again are the same plans: all that ship, and random ones of
// all shipped events.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "interchange/imported_plan.h"
#include "interchange/outline.h"
#include "interchange/plan_document.h"
#include "interchange/plan_tables.h"
#include "interchange/source_tables.h"
#include "interchange/table_writer.h"
#include "plan/field_reader.h"
#include "plan/kml_reader.h"
#include "script_fixture.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;

const Declarations& shipped_declarations() {
  static const Catalog catalog(std::vector<ScriptFolder>{{LSOS_SOURCE_DIR, ""}});
  return catalog.declarations();
}

struct ReadBack {
  std::string hash;
  std::size_t faults = 0;  // without those of numbers without units, which come back with them
  std::string text;        // of the faults
};

ReadBack read(const KmlSource& source) {
  Faults faults;
  const Plan plan = read_plan("plan.kml", source, shipped_declarations(), faults);
  ReadBack read{plan.hash(), 0, ""};
  for (const Fault& fault : faults.sorted()) {
    if (fault.what.find("as without a unit") == std::string::npos) ++read.faults;
    read.text += to_string(fault) + "\n";
  }
  return read;
}

const char* const endings[] = {".csv", ".xlsx", ".ods", ".geojson", ".gpkg", ".txt"};

// The plan after a way through a file with that ending.
ReadBack through(const std::string& ending, const KmlSource& plan, const std::string& folder) {
  const KmlSource things = plan_things(plan, shipped_declarations());
  const bool is_map = ending == ".geojson" || ending == ".gpkg";
  const TableDivision division = ending == ".gpkg"                       ? TableDivision::by_type
                                 : ending == ".xlsx" || ending == ".ods" ? TableDivision::parts
                                                                         : TableDivision::none;
  const std::string file = folder + "/plan" + ending;
  std::ofstream(file, std::ios::binary)
      << (ending == ".txt"
              ? outline_of(things, shipped_declarations(), landmarks(plan, shipped_declarations()))
              : tables_as(ending,
                          plan_tables(things, shipped_declarations(), division, is_map,
                                      landmarks(plan, shipped_declarations())),
                          *find_body("Moon"), file));
  std::vector<std::string> left_out;
  Faults faults;
  const std::vector<Table> tables = read_tables(file, shipped_declarations(), left_out);
  ImportedPlan imported = import_tables(tables, shipped_declarations(), faults);
  for (const Fault& fault : faults.sorted()) {
    if (fault.severity == Severity::error) ADD_FAILURE() << to_string(fault);
  }
  EXPECT_TRUE(left_out.empty() && imported.left_out.empty()) << file;
  imported.source.layers.clear();  // the body of a GeoPackage's layers is that of all plans here
  // The document that is written reads as the rows did.
  EXPECT_EQ(read(parse_kml(kml_of(imported.source), "plan.kml")).hash, read(imported.source).hash);
  return read(imported.source);
}

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / fmt::format("lsos_interchange_{}", ::getpid())) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

TEST(Interchange, shipped_plans_come_back_equal_from_every_format) {
  const Folder folder;
  int plans = 0;
  for (const auto& entry : fs::directory_iterator(LSOS_SOURCE_DIR "/plans")) {
    if (entry.path().extension() != ".kml") continue;
    ++plans;
    const KmlSource plan = read_kml(entry.path().string());
    const ReadBack before = read(plan);
    for (const std::string ending : endings) {
      const ReadBack after = through(ending, plan, folder.path());
      EXPECT_EQ(after.hash, before.hash) << entry.path() << ending << "\n" << after.text;
    }
  }
  EXPECT_GT(plans, 8);
}

// Random texts and numbers for the fields of random events.
class RandomPlan {
 public:
  explicit RandomPlan(unsigned seed) : random_(seed) {}

  KmlSource make() {
    KmlSource plan{"plan.kml", {}};
    plan.placemarks.push_back(thing("MissionInfo", {{"Planet", "Moon"},
                                                    {"StartTime", "2026-07-01T06:00:00Z"},
                                                    {"Terrain", "Flat"},
                                                    {"Seed", std::to_string(whole(0, 99))}}));
    for (const char* id : {"A", "rover, two"}) {
      SourcePlacemark rover = thing("Rover", {{"RoverId", id}, {"RoverType", "SEV"}});
      rover.geometries.push_back({"Point", place(), 1});
      plan.placemarks.push_back(std::move(rover));
    }
    const int count = whole(1, 12);
    for (int i = 0; i < count; ++i) plan.placemarks.push_back(event(i));
    std::ranges::shuffle(plan.placemarks, random_);
    return plan;
  }

 private:
  int whole(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random_);
  }
  bool chance(double share) { return std::bernoulli_distribution(share)(random_); }
  std::string place() {
    const auto angle = [&](int most) { return whole(-most, most) / 1e9 * 1000; };
    return fmt::format("{:.9f},{:.9f}", angle(179'000'000), angle(89'000'000));
  }
  std::string words() {
    const char* const all[] = {"Ridge",
                               "a, b; c",
                               "\"in quotes\"",
                               "Gr\xc3\xb6\xc3\x9f"
                               "e (1)",
                               "x:y",
                               "- dash",
                               "#1",
                               "to > from",
                               "8:00",
                               "1/2",
                               "it's",
                               "=SUM(A1)"};
    return all[whole(0, 11)] + fmt::format(" {}", whole(1, 999));
  }

  std::string value(const FieldDeclaration& field) {
    switch (field.kind) {
      case FieldKind::boolean:
        return chance(0.5) ? "true" : "0";
      case FieldKind::choice:
        return field.choices[static_cast<std::size_t>(
            whole(0, static_cast<int>(field.choices.size()) - 1))];
      case FieldKind::integer:
        return std::to_string(whole(0, 50));
      case FieldKind::utc:
        return fmt::format("2026-07-{:02}T{:02}:{:02}:{:06.3f}Z", whole(1, 28), whole(0, 23),
                           whole(0, 59), whole(0, 59999) / 1000.0);
      case FieldKind::duration:
      case FieldKind::moment:
        return chance(0.5) ? fmt::format("{} min", whole(1, 999) / 7.0)
                           : fmt::format("PT{}H{}M", whole(1, 30), whole(0, 59));
      case FieldKind::number:
        return fmt::format("{}", whole(1, 1000) / 31.0);
      case FieldKind::text:
        return field.name == "OnFailure" ? "skip" : words();
    }
    return "";
  }

  SourcePlacemark thing(const std::string& type, std::vector<SourceField> fields) {
    SourcePlacemark made;
    made.data.push_back({"", type, std::move(fields), 1});
    made.line = 1;
    return made;
  }

  SourcePlacemark event(int number) {
    auto chosen = shipped_declarations().events.begin();
    std::advance(chosen, whole(0, static_cast<int>(shipped_declarations().events.size()) - 1));
    const EventDeclaration& declaration = chosen->second;
    SourcePlacemark made = thing(declaration.name, {{"RoverId", chance(0.7) ? "A" : "rover, two"},
                                                    {"Sequence", std::to_string(number * 7 + 3)}});
    if (chance(0.7)) made.name = words();
    if (chance(0.3)) made.description = words();
    for (const auto* list : {&declaration.fields, &common_event_fields()}) {
      for (const FieldDeclaration& field : *list) {
        const bool is_reference = field.name == "StartAfter" || field.name.ends_with("When");
        if (is_reference || (!field.is_required && !chance(0.4))) continue;
        made.data.front().fields.push_back({field.name, value(field)});
      }
    }
    add_geometry(declaration, made);
    return made;
  }

  void add_geometry(const EventDeclaration& declaration, SourcePlacemark& made) {
    const auto& kinds = declaration.geometries;
    if (kinds.empty()) return;
    switch (kinds[static_cast<std::size_t>(whole(0, static_cast<int>(kinds.size()) - 1))]) {
      case GeometryKind::none:
        return;
      case GeometryKind::point:
        return made.geometries.push_back({"Point", place(), 1});
      case GeometryKind::line:
        return made.geometries.push_back(
            {"LineString", place() + " " + place() + "," + std::to_string(whole(0, 9)), 1});
      case GeometryKind::polygon:
        made.geometries.push_back({"Polygon", "1,1 1.5,1 1.5,1.5 1,1.5 1,1", 1});
        made.geometries.back().holes.push_back({"1.1,1.1 1.2,1.1 1.2,1.2 1.1,1.1", 1});
    }
  }

  std::mt19937 random_;
};

void check_random_plans(unsigned first, unsigned last) {
  const Folder folder;
  for (unsigned seed = first; seed <= last; ++seed) {
    const KmlSource plan = RandomPlan(seed).make();
    const ReadBack before = read(plan);
    for (const std::string ending : endings) {
      const ReadBack after = through(ending, plan, folder.path());
      EXPECT_EQ(after.hash, before.hash) << seed << ending << "\n" << before.text << after.text;
      EXPECT_EQ(after.faults, before.faults) << seed << ending << "\n" << before.text << after.text;
    }
  }
}

TEST(Interchange, random_plans_come_back_equal_from_every_format) { check_random_plans(1, 50); }

TEST(LongInterchange, a_thousand_random_plans_come_back_equal) { check_random_plans(51, 1050); }

}  // namespace
}  // namespace lsos::test
