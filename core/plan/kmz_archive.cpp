#include "plan/kmz_archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "base/error.h"

namespace lsos {

namespace {

ZipHandle open_archive(const std::string& bytes, const std::string& file) {
  std::string why;
  ZipHandle archive = open_zip(bytes, why);
  if (archive == nullptr) {
    throw InputError({file, 0},
                     fmt::format("cannot be unpacked: {}; it begins as a KMZ but is cut short or "
                                 "damaged",
                                 why));
  }
  return archive;
}

// Whether macOS added the file to the archive; such files are not the user's.
bool is_added_by_macos(std::string_view name) {
  const std::size_t slash = name.rfind('/');
  return name.starts_with("__MACOSX/") ||
         name.substr(slash == std::string_view::npos ? 0 : slash + 1).starts_with("._");
}

std::string in_lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Decodes percent escapes: "a%20b" becomes "a b".
std::string without_escapes(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto is_digit = [&](std::size_t at) {
      return at < text.size() && std::isxdigit(static_cast<unsigned char>(text[at])) != 0;
    };
    if (text[i] == '%' && is_digit(i + 1) && is_digit(i + 2)) {
      plain += static_cast<char>(std::stoi(std::string(text.substr(i + 1, 2)), nullptr, 16));
      i += 2;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

}  // namespace

bool is_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06");
}

KmzArchive::KmzArchive(const std::string& bytes, std::string file, std::size_t max_bytes)
    : file_(std::move(file)),
      archive_(open_archive(bytes, file_)),
      max_bytes_(max_bytes),
      left_bytes_(max_bytes) {}

std::string KmzArchive::document_name() const {
  std::string first;
  const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* entry = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), 0);
    if (entry == nullptr || is_added_by_macos(entry)) continue;
    const std::string lower = in_lower_case(entry);
    if (lower == "doc.kml") return entry;
    if (first.empty() && lower.ends_with(".kml")) first = entry;
  }
  if (first.empty()) {
    throw InputError({file_, 0}, "holds no .kml file; a KMZ has one, named doc.kml");
  }
  return first;
}

std::string KmzArchive::resolved(const std::string& href, const std::string& document) const {
  const std::string file = without_escapes(std::string_view(href).substr(0, href.find('#')));
  if (!in_lower_case(file).ends_with(".kml")) return "";
  const std::string name =
      (std::filesystem::path(document).parent_path() / file).lexically_normal().generic_string();
  return has(name) ? name : "";
}

bool KmzArchive::has(const std::string& name) const {
  return zip_name_locate(archive_.get(), name.c_str(), 0) >= 0;
}

std::string KmzArchive::unpacked(const std::string& name) {
  const auto refuse = [&](zip_error_t* error) {
    throw InputError({path(name), 0}, fmt::format("cannot be unpacked: {}", message(error)));
  };
  const ZipEntry entry(zip_fopen(archive_.get(), name.c_str(), 0));
  if (!entry) refuse(zip_get_error(archive_.get()));
  std::string bytes;
  std::string block(std::size_t{1} << 20, '\0');
  for (;;) {
    const zip_int64_t count = zip_fread(entry.get(), block.data(), block.size());
    if (count < 0) refuse(zip_file_get_error(entry.get()));
    if (count == 0) break;
    bytes.append(block, 0, static_cast<std::size_t>(count));
    if (bytes.size() > left_bytes_) {
      throw InputError({path(name), 0},
                       fmt::format("unpacks to more than {} MiB", max_bytes_ >> 20));
    }
  }
  left_bytes_ -= bytes.size();
  return bytes;
}

}  // namespace lsos
