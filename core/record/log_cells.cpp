#include "record/log_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "base/error.h"
#include "base/utf8.h"
#include "record/json_text.h"
#include "record/stored_value.h"

namespace lsos {

namespace {

constexpr std::string_view geometry_column = "geom";
constexpr std::size_t shown_bytes = 60;

std::string statement(const LayerSpec& layer, const std::string& where) {
  std::string sql = "SELECT fid";
  for (const ColumnSpec& column : layer.columns) sql += fmt::format(", \"{}\"", column.name);
  if (layer.geometry != LayerGeometry::none) sql += fmt::format(", {}", geometry_column);
  // An index of the file may lie.
  sql += fmt::format(" FROM \"{}\" NOT INDEXED", layer.name);
  return where.empty() ? sql : sql + " WHERE " + where;
}

// Digits where the pattern has '0', else the same bytes.
bool has_form(std::string_view text, std::string_view pattern) {
  return std::ranges::equal(text, pattern, [](char c, char form) {
    return form == '0' ? c >= '0' && c <= '9' : c == form;
  });
}

std::string shown(std::string_view text) { return beginning(text, shown_bytes); }

const char* words_for(ColumnType type) {
  switch (type) {
    case ColumnType::integer:
      return "a whole number";
    case ColumnType::real:
      return "a number";
    case ColumnType::utc:
      return "a time such as 2026-07-01T00:00:00.000Z";
    case ColumnType::text:
      break;
  }
  return "a text";
}

std::string joined(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", word);
  return text;
}

template <class T>
T little_endian(std::string_view bytes, std::size_t at) {
  static_assert(std::endian::native == std::endian::little);
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

// Where the WKB begins in the form of geometry that a GeoPackage has; npos: it is none.
std::size_t wkb_begin(std::string_view blob) {
  constexpr std::size_t head_bytes = 8;
  constexpr std::size_t envelope_bytes[] = {0, 32, 48, 48, 64};
  if (blob.size() < head_bytes || !blob.starts_with("GP")) return std::string_view::npos;
  const auto flags = static_cast<unsigned char>(blob[3]);
  const std::size_t envelope = (flags >> 1) & 7u;
  if (envelope >= std::size(envelope_bytes)) return std::string_view::npos;
  const std::size_t begin = head_bytes + envelope_bytes[envelope];
  return begin <= blob.size() ? begin : std::string_view::npos;
}

constexpr std::uint32_t wkb_point_z = 1001, wkb_line_z = 1002;
constexpr std::size_t wkb_head_bytes = 5, wkb_count_bytes = 4, wkb_place_bytes = 24;

// Where the places begin in little-endian WKB of this geometry, and how many there are.
struct WkbPlaces {
  std::size_t begin = 0, count = 0;
};
std::optional<WkbPlaces> wkb_places(std::string_view wkb, LayerGeometry geometry) {
  if (wkb.size() < wkb_head_bytes || wkb[0] != 1) return {};
  const auto type = little_endian<std::uint32_t>(wkb, 1);
  WkbPlaces places{wkb_head_bytes, 1};
  if (geometry == LayerGeometry::line) {
    if (type != wkb_line_z || wkb.size() < wkb_head_bytes + wkb_count_bytes) return {};
    places.count = little_endian<std::uint32_t>(wkb, wkb_head_bytes);
    places.begin += wkb_count_bytes;
  } else if (type != wkb_point_z) {
    return {};
  }
  if (wkb.size() - places.begin != places.count * wkb_place_bytes) return {};
  return places;
}

}  // namespace

LayerRows::LayerRows(const sqlite::Database& database, const LayerSpec& layer,
                     const std::string& where)
    : database_(database), layer_(layer), query_(database, statement(layer, where)) {}

bool LayerRows::next() {
  if (!query_.next()) return false;
  // In a damaged file rows can come again without end.
  const std::int64_t before = fid_;
  fid_ = query_.integer(0);
  if (fid_ > before) return true;
  throw InputError({database_.file()},
                   fmt::format("layer '{}': fid {} does not follow {}: rows are numbered from 1 up",
                               layer_.name, fid_, before));
}

void LayerRows::refuse(std::string_view column, const std::string& what) const {
  throw InputError({database_.file()},
                   fmt::format("layer '{}', fid {}: {} {}", layer_.name, fid_, column, what));
}

void LayerRows::check_number(const ColumnSpec& column, double number) const {
  const ColumnLimits& limits = column.limits;
  if (is_within(limits, number)) return;
  refuse(column.name, fmt::format("= {}: a number from {} to {} is allowed", number, limits.least,
                                  limits.greatest));
}

ColumnValue LayerRows::value(std::size_t number) const {
  const ColumnSpec& column = layer_.columns[number];
  const int at = static_cast<int>(number) + 1;
  const sqlite::CellKind kind = query_.kind(at);
  const bool is_text = column.type == ColumnType::text || column.type == ColumnType::utc;
  if (kind == sqlite::CellKind::null) {
    if (column.limits.is_required) {
      refuse(column.name, fmt::format("is NULL: {} is needed", words_for(column.type)));
    }
    return {};
  }
  if (column.type == ColumnType::integer && kind == sqlite::CellKind::integer) {
    const std::int64_t integer = query_.integer(at);
    check_number(column, static_cast<double>(integer));
    return integer;
  }
  const bool is_number = kind == sqlite::CellKind::real || kind == sqlite::CellKind::integer;
  if (column.type == ColumnType::real && is_number) {
    const double real = query_.real(at);
    check_number(column, real);
    return real;
  }
  if (!is_text || kind != sqlite::CellKind::text) {
    const bool is_blob = kind == sqlite::CellKind::blob;
    refuse(column.name,
           fmt::format("is {}: {} is allowed",
                       is_blob ? "a blob" : fmt::format("'{}'", shown(query_.text(at))),
                       words_for(column.type)));
  }
  const std::string_view text = query_.text(at);
  if (!is_utf8(text) || text.find('\0') != std::string_view::npos) {
    refuse(column.name, "is no text in UTF-8");
  }
  if (column.type == ColumnType::utc && !has_form(text, "0000-00-00T00:00:00.000Z")) {
    refuse(column.name, fmt::format("= '{}': {} is allowed", shown(text), words_for(column.type)));
  }
  if (column.limits.is_json && !is_json_object(text)) {
    refuse(column.name, fmt::format("= '{}': an object in JSON is allowed, nested at most 64 deep",
                                    shown(text)));
  }
  const auto& words = column.limits.words;
  if (!words.empty() && std::ranges::find(words, text) == words.end()) {
    refuse(column.name, fmt::format("= '{}': allowed are {}", shown(text), joined(words)));
  }
  return std::string(text);
}

std::string_view LayerRows::wkb() const {
  const int at = static_cast<int>(layer_.columns.size()) + 1;
  const sqlite::CellKind kind = query_.kind(at);
  if (kind == sqlite::CellKind::null) return {};
  const std::string_view blob = query_.blob(at);
  const std::size_t begin =
      kind == sqlite::CellKind::blob ? wkb_begin(blob) : std::string_view::npos;
  if (begin != std::string_view::npos) {
    const std::string_view wkb = blob.substr(begin);
    if (wkb_places(wkb, layer_.geometry)) return wkb;
  }
  refuse(geometry_column, fmt::format("is no {} with heights as a GeoPackage has it",
                                      layer_.geometry == LayerGeometry::line ? "line" : "point"));
}

std::string LayerRows::geometry_wkb() const { return std::string(wkb()); }

std::vector<Geodetic> LayerRows::places() const {
  std::vector<Geodetic> places;
  const std::string_view bytes = wkb();
  if (bytes.empty()) return places;
  const WkbPlaces found = *wkb_places(bytes, layer_.geometry);
  for (std::size_t k = 0; k < found.count; ++k) {
    const std::size_t at = found.begin + k * wkb_place_bytes;
    const auto lon_deg = little_endian<double>(bytes, at);
    const auto lat_deg = little_endian<double>(bytes, at + 8);
    const auto height_m = little_endian<double>(bytes, at + 16);
    if (!is_place(lon_deg, lat_deg, height_m)) {
      refuse(geometry_column,
             fmt::format("lies at {},{},{}: that is no place", lon_deg, lat_deg, height_m));
    }
    places.push_back(geodetic_from_degrees(lon_deg, lat_deg, height_m));
  }
  return places;
}

}  // namespace lsos
