// The KML document inside a KMZ archive.
#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <cctype>
#include <memory>

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

// doc.kml, as the KMZ convention has it, else the first file in the archive that ends in .kml.
std::string document_name(zip_t* archive) {
  std::string first;
  const zip_int64_t count = zip_get_num_entries(archive, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* entry = zip_get_name(archive, static_cast<zip_uint64_t>(i), 0);
    if (entry == nullptr) continue;
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

void write_kmz(const std::string& file, const std::string& kml) {
  const auto fail = [&](const std::string& why) {
    throw InputError({file, 0}, "cannot be written: " + why);
  };
  int code = 0;
  zip_t* archive = zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  if (archive == nullptr) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const std::string why = message(&error);
    zip_error_fini(&error);
    fail(why);
  }
  zip_source_t* source = zip_source_buffer(archive, kml.data(), kml.size(), 0);
  const zip_int64_t index =
      source == nullptr ? -1 : zip_file_add(archive, "doc.kml", source, ZIP_FL_ENC_UTF_8);
  if (index < 0 && source != nullptr) zip_source_free(source);
  // The same document gives the same bytes at any time: archives know none before 1980.
  constexpr std::int64_t year_1980_s = 315'532'800;
  if (index >= 0) {
    zip_file_set_mtime(archive, static_cast<zip_uint64_t>(index), year_1980_s, 0);
  }
  if (index < 0 || zip_close(archive) != 0) {
    const std::string why = message(zip_get_error(archive));
    zip_discard(archive);
    fail(why);
  }
}

}  // namespace lsos
