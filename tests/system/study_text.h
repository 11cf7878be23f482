// Studies in files, and the tables that they leave.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "system/plan_text.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {

// The text of a study of plan.kml. `keys`: of lsos.study, in Lua; `varied`: lsos.vary's.
inline std::string study_text(const std::string& keys, const std::string& varied) {
  return "local lsos = require 'lsos'\n"
         "return lsos.study {\n"
         "  api = 1, doc = 'A test.', plan = 'plan.kml', seed = 1,\n" +
         keys + "\n  vary = {\n" + varied + "\n  },\n}\n";
}

// A SEV that drives 10 m and pauses for a minute.
inline std::vector<Mark> short_plan(const Fields& rover = {}) {
  Mark sev_a = sev("A", "31,20");
  sev_a.fields.insert(sev_a.fields.end(), rover.begin(), rover.end());
  return {mission({{"MaxDuration", "10 min"}}), sev_a,
          event("Route", "A", 10, {{"Speed", "1 m/s"}}, line("31,20 31.00035,20")),
          event("Pause", "A", 20, {{"Duration", "60"}})};
}

// Rows of a table of study.gpkg, as SQL selects them.
inline nlohmann::json rows(const std::filesystem::path& folder, const std::string& statement) {
  const Outcome outcome = run_command({"sqlite3", "-json", folder / "study.gpkg", statement});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return outcome.out.empty() ? nlohmann::json::array() : nlohmann::json::parse(outcome.out);
}

// All rows of a table in their order, without their points.
inline nlohmann::json all_rows(const std::filesystem::path& folder, const std::string& table) {
  const auto names = rows(folder,
                          "SELECT group_concat('\"' || name || '\"') AS names FROM "
                          "pragma_table_info('" +
                              table + "') WHERE name <> 'geom'");
  return rows(folder, "SELECT " + names[0]["names"].get<std::string>() + " FROM " + table +
                          " ORDER BY fid");
}

// All that two equal sweeps have alike.
inline nlohmann::json equal_parts(const std::filesystem::path& folder) {
  nlohmann::json all;
  for (const char* table : {"cases", "bands", "arrivals", "ends", "columns"}) {
    all[table] = all_rows(folder, table);
    for (nlohmann::json& row : all[table]) {
      for (const char* machine : {"wall_s", "cpu_s", "real_time_factor"}) row.erase(machine);
    }
  }
  return all;
}

}  // namespace lsos::test
