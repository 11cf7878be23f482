// The KML document inside a KMZ archive.
#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "base/error.h"
#include "plan/kml_text.h"
#include "plan/kml_writer.h"

namespace lsos {

namespace {

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;
using ZipArchive = std::unique_ptr<zip_t, CloseArchive>;
using Entry = std::unique_ptr<zip_file_t, CloseEntry>;

// "Not a zip archive" as the middle of a sentence; "CRC error" stays.
std::string message(zip_error_t* error) {
  std::string text = zip_error_strerror(error);
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1]))) {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  }
  return text;
}

ZipArchive open_archive(const std::string& bytes, const std::string& file) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive == nullptr) {
    if (source != nullptr) zip_source_free(source);
    const std::string why = message(&error);
    zip_error_fini(&error);
    throw InputError({file, 0},
                     fmt::format("cannot be unpacked: {}; it begins as a KMZ but is cut short or "
                                 "damaged",
                                 why));
  }
  zip_error_fini(&error);
  return ZipArchive(archive);
}

// What macOS adds to archives: no file of the user's.
bool is_of_finder(std::string_view name) {
  const std::size_t slash = name.rfind('/');
  return name.starts_with("__MACOSX/") ||
         name.substr(slash == std::string_view::npos ? 0 : slash + 1).starts_with("._");
}

// doc.kml, as the KMZ convention has it, else the first file in the archive that ends in .kml.
std::string document_name(zip_t* archive) {
  std::string first;
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* entry = zip_get_name(archive, static_cast<zip_uint64_t>(i), 0);
    if (entry == nullptr || is_of_finder(entry)) continue;
    std::string name = entry;
    std::string lower = name;
    std::ranges::transform(lower, lower.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (lower == "doc.kml") return name;
    if (first.empty() && lower.ends_with(".kml")) first = name;
  }
  return first;
}

}  // namespace

bool is_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06");
}

KmlText unpack_kmz(const std::string& bytes, const std::string& file, std::size_t max_bytes) {
  const ZipArchive archive = open_archive(bytes, file);
  const std::string name = document_name(archive.get());
  if (name.empty()) throw InputError({file, 0}, "holds no .kml file; a KMZ has one, named doc.kml");

  KmlText text{file + "/" + name, {}};
  const auto refuse = [&](zip_error_t* error) {
    throw InputError({text.file, 0}, fmt::format("cannot be unpacked: {}", message(error)));
  };
  const Entry entry(zip_fopen(archive.get(), name.c_str(), 0));
  if (!entry) refuse(zip_get_error(archive.get()));
  std::string block(std::size_t{1} << 20, '\0');
  for (;;) {
    const zip_int64_t count = zip_fread(entry.get(), block.data(), block.size());
    if (count < 0) refuse(zip_file_get_error(entry.get()));
    if (count == 0) return text;
    text.utf8.append(block, 0, static_cast<std::size_t>(count));
    if (text.utf8.size() > max_bytes) {
      throw InputError({text.file, 0}, fmt::format("unpacks to more than {} MiB", max_bytes >> 20));
    }
  }
}

std::string pack_kmz(const std::string& kml) {
  const auto fail = [](zip_error_t* error) {
    throw std::runtime_error("a KMZ cannot be packed: " + message(error));
  };
  zip_error_t error;
  zip_error_init(&error);
  const Source packed(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!packed) fail(&error);
  zip_source_keep(packed.get());  // the archive lets go of its own
  ZipArchive archive(zip_open_from_source(packed.get(), ZIP_TRUNCATE, &error));
  if (!archive) fail(&error);
  zip_source_t* source = zip_source_buffer(archive.get(), kml.data(), kml.size(), 0);
  const zip_int64_t index =
      source == nullptr ? -1 : zip_file_add(archive.get(), "doc.kml", source, ZIP_FL_ENC_UTF_8);
  if (index < 0 && source != nullptr) zip_source_free(source);
  // The same document gives the same bytes at any time: all are of 1 January 1980.
  constexpr zip_uint16_t first_day = 0x21;
  if (index < 0 ||
      zip_file_set_dostime(archive.get(), static_cast<zip_uint64_t>(index), 0, first_day, 0) != 0) {
    fail(zip_get_error(archive.get()));
  }
  if (zip_close(archive.get()) != 0) fail(zip_get_error(archive.get()));
  static_cast<void>(archive.release());  // closed
  std::string bytes;
  if (zip_source_open(packed.get()) != 0 || zip_source_seek(packed.get(), 0, SEEK_END) != 0) {
    fail(zip_source_error(packed.get()));
  }
  bytes.resize(static_cast<std::size_t>(zip_source_tell(packed.get())));
  const bool is_read = zip_source_seek(packed.get(), 0, SEEK_SET) == 0 &&
                       zip_source_read(packed.get(), bytes.data(), bytes.size()) ==
                           static_cast<zip_int64_t>(bytes.size());
  zip_source_close(packed.get());
  if (!is_read) fail(zip_source_error(packed.get()));
  return bytes;
}

}  // namespace lsos
