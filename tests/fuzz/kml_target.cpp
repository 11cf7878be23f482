// A plan in KML, or a KMZ archive, from its bytes to the plan.
#include "base/error.h"
#include "fuzz/target.h"
#include "plan/kml_reader.h"
#include "plan/plan.h"

namespace {

lsos::FieldDeclaration field(const char* name, const char* key, lsos::FieldKind kind,
                             const char* unit = "") {
  lsos::FieldDeclaration field;
  field.name = name;
  field.key = key;
  field.kind = kind;
  if (*unit != '\0') field.unit = lsos::find_unit(unit);
  return field;
}

lsos::Declarations declarations() {
  lsos::Declarations known;
  lsos::EventDeclaration& route = known.events["Route"];
  route.name = "Route";
  route.drives = true;
  route.geometries = {lsos::GeometryKind::line, lsos::GeometryKind::point};
  route.fields = {field("Speed", "speed_mps", lsos::FieldKind::number, "m/s"),
                  field("ArrivalRadius", "arrival_radius_m", lsos::FieldKind::number, "m")};
  lsos::EventDeclaration& pause = known.events["Pause"];
  pause.name = "Pause";
  pause.geometries = {lsos::GeometryKind::none, lsos::GeometryKind::point,
                      lsos::GeometryKind::polygon};
  pause.fields = {field("Duration", "duration_s", lsos::FieldKind::duration, "s")};
  known.rover_types["SEV"] = {};
  known.terrains = {"Flat"};
  return known;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const lsos::Declarations known = declarations();
  try {
    const lsos::KmlSource source = lsos::parse_kml(lsos::test::text_of(data, size), "plan.kml");
    lsos::Faults faults;
    const lsos::Plan plan = lsos::read_plan("plan.kml", source, known, faults);
    faults.sorted();
    if (!faults.has_errors()) plan.hash();
  } catch (const lsos::InputError&) {
  }
  return 0;
}
