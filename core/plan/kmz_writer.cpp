// Packs files into a zip archive, the format of KMZ and QGZ.
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>
#include <utility>

#include "plan/kml_writer.h"
#include "plan/kmz_archive.h"
#include "plan/zip_handle.h"

namespace lsos {

namespace {

[[noreturn]] void fail(zip_error_t* error) {
  throw std::runtime_error("an archive cannot be packed: " + message(error));
}

// Closes the archive and returns the bytes of what it is written to.
std::string closed(ZipHandle archive, zip_source_t* packed) {
  if (zip_close(archive.get()) != 0) fail(zip_get_error(archive.get()));
  static_cast<void>(archive.release());  // closed
  std::string bytes;
  if (zip_source_open(packed) != 0 || zip_source_seek(packed, 0, SEEK_END) != 0) {
    fail(zip_source_error(packed));
  }
  bytes.resize(static_cast<std::size_t>(zip_source_tell(packed)));
  const bool is_read =
      zip_source_seek(packed, 0, SEEK_SET) == 0 &&
      zip_source_read(packed, bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size());
  zip_source_close(packed);
  if (!is_read) fail(zip_source_error(packed));
  return bytes;
}

// Dates a file 1 January 1980, so that equal documents give equal bytes at any time.
bool set_first_day(const ZipHandle& archive, zip_int64_t index) {
  constexpr zip_uint16_t first_day = 0x21;
  return zip_file_set_dostime(archive.get(), static_cast<zip_uint64_t>(index), 0, first_day, 0) ==
         0;
}

}  // namespace

std::string pack_kmz(const std::string& kml, const std::vector<PackedFile>& others) {
  std::vector<PackedFile> files{{"doc.kml", kml}};
  files.insert(files.end(), others.begin(), others.end());
  return pack_zip(files);
}

std::string pack_zip(const std::vector<PackedFile>& files) {
  zip_error_t error;
  zip_error_init(&error);
  const ZipSource packed(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!packed) fail(&error);
  zip_source_keep(packed.get());  // the archive frees its own reference
  ZipHandle archive(zip_open_from_source(packed.get(), ZIP_TRUNCATE, &error));
  if (!archive) fail(&error);
  for (const auto& [name, bytes] : files) {
    zip_source_t* source = zip_source_buffer(archive.get(), bytes.data(), bytes.size(), 0);
    const zip_int64_t index =
        source == nullptr ? -1
                          : zip_file_add(archive.get(), name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0 && source != nullptr) zip_source_free(source);
    if (index < 0 || !set_first_day(archive, index)) fail(zip_get_error(archive.get()));
  }
  return closed(std::move(archive), packed.get());
}

std::string repacked_zip(const std::string& zip, const std::string& name,
                         const std::string& bytes) {
  zip_error_t error;
  zip_error_init(&error);
  // A copy that libzip owns: where it keeps the beginning of an archive, it frees what it read it
  // from, also a buffer that is not its own (1.7.3).
  void* copy = std::malloc(zip.size());
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, zip.data(), zip.size());
  const ZipSource packed(zip_source_buffer_create(copy, zip.size(), 1, &error));
  if (!packed) {
    std::free(copy);
    fail(&error);
  }
  zip_source_keep(packed.get());
  ZipHandle archive(zip_open_from_source(packed.get(), 0, &error));
  if (!archive) fail(&error);
  const zip_int64_t index = zip_name_locate(archive.get(), name.c_str(), 0);
  zip_source_t* source = zip_source_buffer(archive.get(), bytes.data(), bytes.size(), 0);
  if (index < 0 || source == nullptr ||
      zip_file_replace(archive.get(), static_cast<zip_uint64_t>(index), source, 0) != 0) {
    if (source != nullptr) zip_source_free(source);
    fail(zip_get_error(archive.get()));
  }
  if (!set_first_day(archive, index)) fail(zip_get_error(archive.get()));
  return closed(std::move(archive), packed.get());
}

}  // namespace lsos
