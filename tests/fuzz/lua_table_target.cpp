// Scripts that define a soil, a terrain, a rover or an event: tables of any values.
#include <filesystem>

#include "base/error.h"
#include "fuzz/target.h"
#include "lua/host/catalog.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr const char* names[] = {"terrain/soils/X.lua", "terrain/X.lua", "rovers/X.lua",
                                   "events/X.lua", "lib/X.lua"};
  static const bool is_made = [] {
    for (const char* folder : {"terrain/soils", "rovers", "events", "lib"}) {
      std::filesystem::create_directories(lsos::test::scratch_folder() + "/" + folder);
    }
    return true;
  }();
  lsos::test::Bytes bytes(data, size);
  const std::string name = names[bytes.byte() % std::size(names)];
  if (is_made) lsos::test::write_scratch(name, bytes.rest());
  try {
    const lsos::Catalog catalog(std::vector<std::string>{lsos::test::scratch_folder()});
    catalog.faults().sorted();
  } catch (const lsos::InputError&) {
  }
  std::filesystem::remove(lsos::test::scratch_folder() + "/" + name);
  return 0;
}
