// The ZIP archive of a spreadsheet: whether it may be opened, and what GDAL does not tell of it.
#pragma once

#include <cstddef>
#include <string>

#include "interchange/workbook_facts.h"

namespace lsos {

// Judges the archive by its directory before anything is unpacked. Throws InputError when it is no
// spreadsheet, damaged, or would unpack to more than `max_bytes`.
WorkbookFacts workbook_facts(const std::string& bytes, const std::string& file,
                             std::size_t max_bytes);

}  // namespace lsos
