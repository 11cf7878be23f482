// `lsos-host export`: writes a plan as a spreadsheet, map or outline, which `import` reads.
#include <fmt/format.h>

#include <filesystem>

#include "base/console.h"
#include "base/files.h"
#include "base/output_file.h"
#include "interchange/outline.h"
#include "interchange/plan_tables.h"
#include "interchange/table_writer.h"
#include "lua/app/commands.h"
#include "lua/host/mission_reader.h"
#include "plan/kml_reader.h"
#include "plan/kml_text.h"

namespace lsos {

namespace {

struct ExportOptions {
  std::string plan, output;
  bool replaces = false;  // a file that is there
};

std::string bytes_of(const KmlSource& source, const KmlSource& things,
                     const Declarations& declarations, const Body& body, const std::string& file) {
  const std::vector<Landmark> named = landmarks(source, declarations);
  const std::string ending = std::filesystem::path(file).extension().string();
  if (ending == ".txt") return outline_of(things, declarations, named);
  const bool is_map = ending == ".geojson" || ending == ".gpkg";
  const TableDivision division = ending == ".gpkg"                       ? TableDivision::by_type
                                 : ending == ".xlsx" || ending == ".ods" ? TableDivision::parts
                                                                         : TableDivision::none;
  return tables_as(ending, plan_tables(things, declarations, division, is_map, named), body, file);
}

int export_command(const ExportOptions& options) {
  Faults faults;
  check_output("-o", options.output, {".csv", ".xlsx", ".ods", ".geojson", ".gpkg", ".txt"},
               {options.plan}, faults);
  if (!options.replaces) check_free("-o", options.output, "--force replaces it", faults);
  faults.throw_if_errors();
  const std::shared_ptr<const Catalog> catalog = read_catalog(options.plan);
  const Declarations& declarations = catalog->declarations();
  const KmlSource source = parse_plan(read_bytes(options.plan), options.plan);
  const Plan plan = read_plan(options.plan, source, declarations, faults);
  faults.throw_if_errors();
  const KmlSource things = plan_things(source, declarations);
  write_file(options.output,
             bytes_of(source, things, declarations, *plan.mission.planet, options.output));
  print_result("{}: {} rows of {}\n", options.output, things.placemarks.size(), options.plan);
  return 0;
}

}  // namespace

std::function<int()> prepare_export(CommandOptions& command) {
  const auto options = std::make_shared<ExportOptions>();
  command.add_option("PLAN", options->plan, "A plan: KML, KMZ or GeoPackage").required();
  command
      .add_option("-o,--output", options->output,
                  "A spreadsheet (.csv, .xlsx, .ods), map (.geojson, .gpkg) or outline (.txt)")
      .required();
  command.add_flag("--force", options->replaces, "Replace the file where it is there already");
  return [options] { return export_command(*options); };
}

}  // namespace lsos
