#include "interchange/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "interchange/clock_text.h"
#include "interchange/columns.h"
#include "interchange/outline_item.h"
#include "interchange/places.h"
#include "interchange/sheets.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// A line, or several that a quoted text spans.
struct Line {
  int number = 0;
  std::string text;
  bool is_indented = false;
};

std::vector<Line> lines_of(const std::string& text) {
  std::vector<Line> lines;
  bool is_quoted = false;
  int number = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string line = text.substr(from, end - from);
    from = end + 1;
    ++number;
    const bool is_comment = trimmed(line).empty() || trimmed(line).front() == '#';
    if (!is_quoted && is_comment) continue;
    if (is_quoted) {
      lines.back().text += '\n' + line;
    } else {
      lines.push_back({number, line, line[0] == ' ' || line[0] == '\t'});
    }
    if (std::ranges::count(line, '"') % 2 == 1) is_quoted = !is_quoted;
  }
  return lines;
}

// The text behind the mark of a list: "- ", "* ".
std::string_view without_mark(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with("- ") || text.starts_with("* ")) return trimmed(text.substr(2));
  return text;
}

// Where the heading "Day 3, SEV A" ends: at the first colon that a blank or nothing follows,
// outside quotes. A clock time has a digit there.
std::size_t heading_end(std::string_view text) {
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') is_quoted = !is_quoted;
    if (is_quoted || text[i] != ':') continue;
    if (i + 1 == text.size() || text[i + 1] == ' ' || text[i + 1] == '\t') return i;
  }
  return std::string_view::npos;
}

class OutlineReader {
 public:
  OutlineReader(const std::string& file, const Declarations& declarations)
      : file_(file), declarations_(declarations) {
    events_.file = places_.file = file;
    events_.name = "outline";
    places_.name = "places";
    places_.header = {column::name, column::wkt};
  }

  std::vector<Table> read(const std::string& text) {
    for (const Line& line : lines_of(text)) read_line(line);
    faults_.throw_if_errors();
    return {std::move(places_), std::move(events_)};
  }

 private:
  void error(const Line& line, const std::string& what) {
    faults_.error({file_, line.number}, what);
  }

  void read_line(const Line& line) {
    const std::string_view text = trimmed(line.text);
    const bool is_item = line.is_indented || text.starts_with("- ") || text.starts_with("* ");
    if (is_item) return add_items(line, without_mark(text));
    const std::size_t end = heading_end(text);
    if (end == std::string_view::npos) {
      return error(line,
                   fmt::format("{} is not understood; a line begins with 'Mission:', 'Rover ID:', "
                               "'Asset ID:', 'Place NAME:' or a day and a rover, such as 'Day 3, "
                               "SEV A:'; items of the line above are indented",
                               quoted(std::string(text))));
    }
    read_heading(line, trimmed(text.substr(0, end)), trimmed(text.substr(end + 1)));
  }

  void read_heading(const Line& line, std::string_view heading, std::string_view rest) {
    const std::size_t blank = std::min(heading.find(' '), heading.size());
    std::string word(heading.substr(0, blank));
    std::ranges::transform(word, word.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
    const std::string id = unquoted(heading.substr(blank));
    has_heading_ = false;
    if (word == "Mission" && id.empty()) return add_thing(line, "MissionInfo", "", rest);
    if ((word == "Rover" || word == "Asset") && !id.empty()) return add_thing(line, word, id, rest);
    if (word == "Place" && !id.empty()) return add_place(line, id, rest);
    begin_items(line, heading);
    if (!rest.empty()) add_items(line, rest);
  }

  // "Day 3, SEV A" or "SEV A"; a day holds for the headings below until another is said.
  void begin_items(const Line&, std::string_view heading) {
    has_heading_ = true;
    for (const std::string& part : split_outside(heading, ',')) {
      const std::size_t digit = part.find_first_of("0123456789");
      const bool is_day =
          digit != std::string::npos && static_cast<bool>(date_of_day(part, Instant{}));
      if (is_day) {
        day_ = part;
      } else {
        rover_id_ = unquoted(part);
      }
    }
  }

  void add_items(const Line& line, std::string_view text) {
    if (!has_heading_) {
      return error(line, "an item stands below a line with its rover, such as 'Day 3, SEV A:'");
    }
    for (const std::string& item : split_outside(text, ';')) {
      if (item.empty()) continue;
      Parsed<OutlineFields> fields = parse_item(item, declarations_);
      if (!fields) {
        error(line, fields.why);
        continue;
      }
      // Rows below take the day over.
      if (!day_.empty()) {
        fields.value->emplace_back(column::day, day_);
        day_.clear();
      }
      if (!rover_id_.empty()) fields.value->emplace_back("RoverId", rover_id_);
      add_row(line, *fields.value);
    }
  }

  // "SEV at Base, Heading 90" of a rover or asset; of the mission its fields alone.
  void add_thing(const Line& line, const std::string& type, const std::string& id,
                 std::string_view rest) {
    const std::vector<std::string> parts = split_outside(rest, ',');
    OutlineFields fields{{column::type, type}};
    std::size_t first = 0;
    if (!id.empty()) {
      fields.emplace_back(type + "Id", id);
      const std::string& what = parts.front();
      const std::size_t at = what.find(" at ");
      if (at == std::string::npos) {
        return error(line,
                     fmt::format("{} {}: {} is not understood; it is written like 'SEV at Base' "
                                 "or 'SEV at (30.1, -89.9)'",
                                 type, id, quoted(what)));
      }
      fields.emplace_back(type + "Type", trimmed(what.substr(0, at)));
      fields.emplace_back(column::place, place_text(what.substr(at + 4)));
      first = 1;
    }
    const std::string why = add_fields(parts, first, type, declarations_, fields);
    if (!why.empty()) return error(line, why);
    add_row(line, fields);
  }

  void add_place(const Line& line, const std::string& name, std::string_view rest) {
    PlaceNames none;
    const std::string text = place_text(rest);
    Parsed<SourceGeometry> geometry = none.geometry(text);
    if (!geometry) {
      return error(line, fmt::format("Place {}: {} is no place; it is written like (30.1, -89.9)",
                                     name, quoted(std::string(rest))));
    }
    places_.rows.push_back({line.number, {name}, std::move(geometry.value)});
  }

  void add_row(const Line& line, const OutlineFields& fields) {
    TableRow row{line.number, {}};
    std::set<std::string> given;
    for (const auto& [name, text] : fields) {
      if (!given.insert(name).second) {
        return error(line, fmt::format("{} is given twice", name));
      }
      const auto found = std::ranges::find(events_.header, name);
      const auto index = static_cast<std::size_t>(found - events_.header.begin());
      if (found == events_.header.end()) events_.header.push_back(name);
      row.cells.resize(std::max(row.cells.size(), index + 1));
      row.cells[index] = text;
    }
    events_.rows.push_back(std::move(row));
  }

  std::string file_;
  const Declarations& declarations_;
  Faults faults_;
  Table events_, places_;
  std::string day_;  // of the heading, until an item has it
  std::string rover_id_;
  bool has_heading_ = false;
};

}  // namespace

std::vector<Table> read_outline(const std::string& bytes, const std::string& file,
                                const Declarations& declarations) {
  return OutlineReader(file, declarations).read(csv_text(bytes, file));
}

}  // namespace lsos
