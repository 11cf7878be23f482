#include "lua/study/base_number.h"

#include "lua/host/script_number.h"
#include "plan/field_reader.h"
#include "study/case_plan.h"

namespace lsos {

BaseNumbers::BaseNumbers(const MissionFiles& files, const std::string& kml)
    : files_(files), document_(kml, files.plan, files.catalog->declarations()) {}

std::optional<double> BaseNumbers::of_field(const Address& address) const {
  const FieldDeclaration& field = field_of(address, files_.plan, files_.catalog->declarations());
  SourceData data;
  data.fields = {{field.name, document_.field(mark_of(document_, address), field.name), 0}};
  Faults none;
  const FieldValues values = FieldReader({{}, ""}, data, none).read(std::span(&field, 1), nullptr);
  const auto value = values.find(field.key);
  if (value == values.end()) return {};
  if (const auto* number = std::get_if<double>(&value->second)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&value->second)) {
    return static_cast<double>(*whole);
  }
  return {};
}

std::optional<double> BaseNumbers::of(const Address& address) const {
  switch (address.what) {
    case Address::What::field:
      return of_field(address);
    case Address::What::script_key: {
      if (address.of == Address::Of::soil) return soil_number(files_.terrain.soil, address.name);
      const PlanRover& rover = *rover_of(files_.plan, address.id);
      return script_number(*files_.catalog, rover.type, rover.variant, address.name);
    }
    case Address::What::place:
      break;
  }
  return {};
}

}  // namespace lsos
