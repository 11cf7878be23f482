// A raster's file, and windows of it.
#include "base/error.h"
#include "fuzz/target.h"
#include "terrain/raster/raster.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr const char* names[] = {"dem.tif", "dem.asc", "dem.img", "dem.vrt", "dem.png"};
  lsos::test::Bytes bytes(data, size);
  const std::string name = names[bytes.byte() % std::size(names)];
  const int level = bytes.byte() % 3;
  lsos::test::write_scratch(name, bytes.rest());
  try {
    lsos::RasterSurface surface;
    surface.file = lsos::test::scratch_folder() + "/" + name;
    const lsos::Raster raster(surface, {}, nullptr);
    constexpr int window = 16;
    const int columns = std::min(window, raster.columns() >> level);
    const int rows = std::min(window, raster.rows() >> level);
    if (columns > 0 && rows > 0) {
      raster.heights_m({0, 0, columns, rows}, level);
      raster.heights_m(
          {(raster.columns() >> level) - columns, (raster.rows() >> level) - rows, columns, rows},
          level);
    }
  } catch (const lsos::InputError&) {
  }
  return 0;
}
