// Numbers with units, durations, times and tables, as planners write them.
#include <cmath>

#include "base/csv.h"
#include "base/iso_duration.h"
#include "base/quantity.h"
#include "base/quantity_advice.h"
#include "base/utf8.h"
#include "fuzz/target.h"
#include "planet/utc.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = lsos::test::text_of(data, size);
  for (const lsos::Unit& unit : lsos::all_units()) {
    const auto value = lsos::parse_quantity(text, unit);
    if (!value) {
      lsos::quantity_advice(text, unit);
      continue;
    }
    if (!std::isfinite(*value.value)) std::abort();  // promised by parse_quantity()
    lsos::format_quantity(*value.value, unit);
  }
  lsos::parse_integer(text);
  lsos::parse_boolean(text);
  lsos::whole_number_advice(text);
  lsos::unit_advice(text);
  const auto duration = lsos::parse_iso_duration("P" + text);
  if (duration && !std::isfinite(*duration.value)) std::abort();
  if (const auto utc = lsos::parse_utc(text)) {
    // What is written of a time reads back to the same millisecond.
    const auto again = lsos::parse_utc(lsos::format_utc(*utc.value));
    if (again && std::abs(again.value->tai_us - utc.value->tai_us) > 500) std::abort();
  }
  lsos::is_utf8(text);
  lsos::parse_csv(text);
  return 0;
}
