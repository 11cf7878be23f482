// What GDAL does not tell of an ODS spreadsheet.
#pragma once

#include <string>

#include "interchange/workbook_facts.h"

namespace lsos {

// Adds merged cells, and the units that number formats show, of the archive's content.xml and
// styles.xml (OpenDocument 1.3, parts 9 and 16).
void add_ods(const std::string& content_xml, const std::string& styles_xml, WorkbookFacts& facts);

}  // namespace lsos
