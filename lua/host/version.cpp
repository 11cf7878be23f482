#include "lua/host/version.h"

#include <fmt/format.h>
#include <link.h>

#include <cstddef>

#include "base/error.h"

namespace lsos {

namespace {

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

// The build id among the notes of a program's segment; "" where there is none.
std::string build_id(const char* notes, std::size_t size) {
  std::string id;
  for (std::size_t at = 0; at + sizeof(ElfW(Nhdr)) <= size;) {
    const auto* note = reinterpret_cast<const ElfW(Nhdr)*>(notes + at);
    const std::size_t content = at + sizeof *note + padded(note->n_namesz);
    if (note->n_type == NT_GNU_BUILD_ID && content + note->n_descsz <= size) {
      for (std::size_t i = 0; i < note->n_descsz; ++i) {
        id += fmt::format("{:02x}", static_cast<unsigned char>(notes[content + i]));
      }
      return id;
    }
    at = content + padded(note->n_descsz);
  }
  return id;
}

// Called with the program first, then with the libraries.
int find_build_id(dl_phdr_info* info, std::size_t, void* found) {
  std::string& id = *static_cast<std::string*>(found);
  for (int i = 0; i < info->dlpi_phnum && id.empty(); ++i) {
    const ElfW(Phdr)& segment = info->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader tells addresses as numbers.
    const auto* const notes = reinterpret_cast<const char*>(info->dlpi_addr + segment.p_vaddr);
    id = build_id(notes, segment.p_memsz);
  }
  return 1;  // the libraries are not asked
}

}  // namespace

std::string program_build() {
  static const std::string build = [] {
    std::string id;
    dl_iterate_phdr(find_build_id, &id);
    LSOS_ASSERT(!id.empty());
    return id;
  }();
  return build;
}

}  // namespace lsos
