#include "base/csv.h"

#include <algorithm>
#include <cctype>

#include "base/replaced.h"
#include "base/text.h"

namespace lsos {

namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// The text up to the end of its first line.
std::string_view first_line(std::string_view text) {
  return text.substr(0, text.find_first_of("\r\n"));
}

// Removes the first line with its end.
void remove_line(std::string_view& text) {
  text.remove_prefix(first_line(text).size());
  if (text.starts_with("\r\n")) {
    text.remove_prefix(2);
  } else if (!text.empty()) {
    text.remove_prefix(1);
  }
}

char separator_of(std::string_view heading) {
  constexpr std::string_view separators = ";\t,";
  char most = ',';
  std::ptrdiff_t most_count = 0;
  for (const char separator : separators) {
    bool is_quoted = false;
    std::ptrdiff_t count = 0;
    for (const char c : heading) {
      if (c == '"') is_quoted = !is_quoted;
      if (c == separator && !is_quoted) ++count;
    }
    if (count > most_count) {
      most = separator;
      most_count = count;
    }
  }
  return most;
}

// Reads cells one after the other and counts lines.
class Reader {
 public:
  Reader(std::string_view text, int line, CsvTable& table)
      : text_(text), line_(line), table_(table) {}

  void read() {
    while (at_ < text_.size() && table_.fault.empty()) read_row();
  }

 private:
  bool is_at_end() const { return at_ == text_.size(); }
  bool is_line_end() const { return text_[at_] == '\n' || text_[at_] == '\r'; }

  void pass_line_end() {
    at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
    ++line_;
  }

  void read_row() {
    CsvRow row{line_, {}};
    for (;;) {
      row.cells.push_back(read_cell());
      if (!table_.fault.empty()) return;
      if (is_at_end() || is_line_end()) break;
      ++at_;  // a separator
    }
    if (!is_at_end()) pass_line_end();
    const bool is_blank =
        std::ranges::all_of(row.cells, [](const std::string& cell) { return cell.empty(); });
    if (!is_blank) table_.rows.push_back(std::move(row));
  }

  std::string read_cell() {
    while (!is_at_end() && text_[at_] == ' ') ++at_;
    if (is_at_end() || text_[at_] != '"') return read_plain();
    const int begin = line_;
    std::string cell;
    for (++at_; !is_at_end();) {
      if (text_.substr(at_).starts_with("\"\"")) {
        cell += '"';
        at_ += 2;
      } else if (text_[at_] == '"') {
        ++at_;
        // What follows the quotes, such as a unit, belongs to the cell.
        return cell + read_plain();
      } else if (is_line_end()) {
        cell += '\n';
        pass_line_end();
      } else {
        cell += text_[at_++];
      }
    }
    table_.fault = "a quotation mark opens here and is not closed";
    table_.fault_line = begin;
    return cell;
  }

  std::string read_plain() {
    const std::size_t begin = at_;
    while (!is_at_end() && !is_line_end() && text_[at_] != table_.separator) ++at_;
    return std::string(trimmed(text_.substr(begin, at_ - begin)));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_;
  CsvTable& table_;
};

// "-5.2 deg", "-31.5,20.1; -31.4,20.2": a sign, a digit, and nothing that could call a function.
bool is_signed_number(std::string_view text) {
  constexpr std::string_view signs = "+-", calls = "()|!=@'\"{}[]<>&*^\t\r\n";
  return text.size() > 1 && signs.find(text[0]) != std::string_view::npos &&
         (std::isdigit(static_cast<unsigned char>(text[1])) != 0 || text[1] == '.') &&
         text.find_first_of(calls) == std::string_view::npos;
}

bool is_like_formula(std::string_view text) {
  constexpr std::string_view begins = "=+-@\t\r";
  // A sign alone stands for nothing, as in a cell that was left out.
  return text.size() > 1 && begins.find(text[0]) != std::string_view::npos &&
         !is_signed_number(text);
}

// Whether an apostrophe in front is needed: for a formula, and for a text that would lose one.
bool needs_guard(std::string_view text) {
  const std::size_t apostrophes = std::min(text.find_first_not_of('\''), text.size());
  return is_like_formula(text.substr(apostrophes));
}

}  // namespace

std::string guarded_text(std::string_view text) {
  return (needs_guard(text) ? "'" : "") + std::string(text);
}

std::string unguarded_text(std::string_view text) {
  const bool is_guarded = text.starts_with('\'') && needs_guard(text.substr(1));
  return std::string(is_guarded ? text.substr(1) : text);
}

std::string csv_cell(std::string_view text) {
  const std::string guarded = guarded_text(text);
  if (guarded.find_first_of(",\"\n\r") == std::string::npos) return guarded;
  return '"' + replaced(guarded, "\"", "\"\"") + '"';
}

CsvTable parse_csv(std::string_view text) {
  CsvTable table;
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    table.fault = "is UTF-16; UTF-8 is allowed ('CSV UTF-8' where a spreadsheet saves it)";
    return table;
  }
  if (text.find('\0') != std::string_view::npos) {
    table.fault = "is no text: it has bytes that are 0";
    return table;
  }
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  int line = 1;
  bool is_named = false;
  const auto is_preamble = [&] {
    const std::string_view next = first_line(text);
    return next.starts_with('#') || trimmed(next).empty() ||
           (next.starts_with("sep=") && next.size() == 5);
  };
  while (!text.empty() && is_preamble()) {
    if (text.starts_with("sep=")) {
      table.separator = text[4];
      is_named = true;
    }
    remove_line(text);
    ++line;
  }
  if (!is_named) table.separator = separator_of(first_line(text));
  Reader(text, line, table).read();
  return table;
}

}  // namespace lsos
