// `lsos-host import`: makes a plan of spreadsheets, maps, xGDS plans and outlines.
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/files.h"
#include "base/output_file.h"
#include "base/text.h"
#include "interchange/imported_plan.h"
#include "interchange/plan_document.h"
#include "interchange/source_tables.h"
#include "lua/app/commands.h"
#include "lua/edit/import_onto.h"
#include "lua/edit/imported_files.h"
#include "lua/edit/new_plan.h"
#include "lua/host/mission_reader.h"
#include "plan/kml_reader.h"
#include "plan/kml_writer.h"
#include "product/balloon.h"

namespace lsos {

namespace {

struct ImportOptions {
  std::vector<std::string> files;
  std::string output;
  std::string onto;  // a plan that takes up the rows; "": none
  bool removes_missing = false;
  bool replaces = false;  // a file that is there
  bool is_json = false;
};

void check_options(const ImportOptions& options) {
  Faults faults;
  check_output("-o", options.output, {".kml", ".kmz"}, options.files, faults);
  if (!options.replaces) check_free("-o", options.output, "--force replaces it", faults);
  if (options.removes_missing && options.onto.empty()) {
    faults.error({}, "--remove-missing: is for --onto PLAN.kml, whose Placemarks it removes");
  }
  faults.throw_if_errors();
}

std::string answer_text(const ImportOptions& options, const Plan& plan, const Faults& faults,
                        const ImportedPlan& made) {
  std::string text;
  for (const Fault& fault : faults.sorted()) text += to_string(fault) + "\n";
  for (const std::string& line : made.notes) text += fmt::format("note: {}\n", line);
  for (const std::string& line : made.left_out) text += fmt::format("left out: {}\n", line);
  return text + fmt::format("{}: {}, {}, {} of {}\n", options.output,
                            counted(plan.rovers.size(), "rover"),
                            counted(plan.assets.size(), "asset"),
                            counted(plan.events.size(), "event"), fmt::join(options.files, ", "));
}

std::string answer_json(const ImportOptions& options, const Plan& plan, const Faults& faults,
                        const ImportedPlan& made) {
  nlohmann::ordered_json warnings = nlohmann::ordered_json::array();
  for (const Fault& fault : faults.sorted()) warnings.push_back(to_string(fault));
  const nlohmann::ordered_json answer{
      {"plan", options.output},       {"plan_sha256", plan.hash()},
      {"rovers", plan.rovers.size()}, {"assets", plan.assets.size()},
      {"events", plan.events.size()}, {"warnings", warnings},
      {"notes", made.notes},          {"left_out", made.left_out}};
  return answer.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

int import_command(const ImportOptions& options) {
  check_options(options);
  if (!options.onto.empty()) {
    print_result("{}", import_onto({options.files, options.onto, options.output,
                                    options.removes_missing, options.is_json}));
    return 0;
  }
  const std::shared_ptr<const Catalog> catalog = read_catalog(options.output);
  const Declarations& declarations = catalog->declarations();
  Faults faults;
  std::vector<std::string> left_out;
  std::vector<Table> tables = read_all_tables(options.files, declarations, left_out);
  ImportedPlan made = import_tables(std::move(tables), declarations, faults);
  made.left_out.insert(made.left_out.begin(), left_out.begin(), left_out.end());
  // The scripts and the ground that the plan names are found beside it.
  allow_beside(options.output);
  const MissionFiles files =
      read_mission(PlanSource{options.output, made.source, "", "", true}, catalog);
  const Plan& plan = files.plan;
  faults = with_plan_faults(faults, files.faults);
  faults.add(placing_faults(files));
  faults = in_words_for_sheets(faults);
  tell_left_out(faults, made.left_out);
  faults.throw_if_errors();

  DocumentLook look;
  look.name = std::filesystem::path(options.output).stem().string();
  look.description = html_text(fmt::format("Imported from {}.", fmt::join(options.files, ", ")));
  look.target = target_of(*plan.mission.planet);
  look.has_folders = true;
  look.places = made.places;
  const std::string kml = kml_of(made.source, look);
  // What was checked is what is written.
  Faults none;
  LSOS_ASSERT(
      read_plan(options.output, parse_kml(kml, options.output), declarations, none).hash() ==
      plan.hash());
  write_file(options.output, options.output.ends_with(".kmz") ? pack_kmz(kml) : kml);
  print_result("{}", options.is_json ? answer_json(options, plan, faults, made)
                                     : answer_text(options, plan, faults, made));
  return 0;
}

}  // namespace

std::function<int()> prepare_import(CommandOptions& command) {
  const auto options = std::make_shared<ImportOptions>();
  command.add_option("FILE", options->files, import_formats).required();
  command.add_option("-o,--output", options->output, "The plan: X.kml or X.kmz").required();
  command.add_option(
      "--onto", options->onto,
      "A plan that was drawn (KML, KMZ), which takes up the rows and keeps all else");
  command.add_flag("--remove-missing", options->removes_missing,
                   "With --onto: what has no row is removed; else it is kept");
  command.add_flag("--force", options->replaces, "Replace the plan where it is there already");
  command.add_flag("--json", options->is_json, "What was made, as JSON");
  return [options] { return import_command(*options); };
}

}  // namespace lsos
