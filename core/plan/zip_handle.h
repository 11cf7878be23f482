// Owning handles of libzip, which close in their destructors.
#pragma once

#include <zip.h>

#include <cctype>
#include <memory>
#include <string>

namespace lsos {

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
  void operator()(zip_file_t* entry) const { zip_fclose(entry); }
};
struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using ZipSource = std::unique_ptr<zip_source_t, FreeSource>;
using ZipHandle = std::unique_ptr<zip_t, CloseArchive>;
using ZipEntry = std::unique_ptr<zip_file_t, CloseEntry>;

// Message of an error for the middle of a sentence: "Not a zip archive" begins in lower case, "CRC
// error" does not.
inline std::string message(zip_error_t* error) {
  std::string text = zip_error_strerror(error);
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1]))) {
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  }
  return text;
}

// Opens the archive in `bytes`, which must outlive it, for reading; nullptr with the reason in
// `why` when they are none.
inline ZipHandle open_zip(const std::string& bytes, std::string& why) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive == nullptr) {
    if (source != nullptr) zip_source_free(source);
    why = message(&error);
  }
  zip_error_fini(&error);
  return ZipHandle(archive);
}

}  // namespace lsos
