#include "picture/jpeg.h"

#include <cstdio>  // required by jpeglib.h
#include <cstdlib>

#include <jpeglib.h>

#include "base/error.h"

namespace lsos {

std::string jpeg_bytes(int width, int height, int channels, std::span<const std::uint8_t> pixels,
                       int quality) {
  LSOS_ASSERT(pixels.size() == static_cast<std::size_t>(width) * height * channels);
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  // Writing to memory fails only if memory runs out; by default the library would then exit.
  errors.error_exit = [](j_common_ptr) {
    throw InternalError("a picture could not be written as JPEG");
  };
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = static_cast<JDIMENSION>(width);
  jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = channels;
  jpeg.in_color_space = channels == 3 ? JCS_RGB : JCS_GRAYSCALE;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, quality, TRUE);
  jpeg.optimize_coding = TRUE;
  jpeg_start_compress(&jpeg, TRUE);
  const std::size_t stride = static_cast<std::size_t>(width) * channels;
  while (jpeg.next_scanline < jpeg.image_height) {
    auto* row = const_cast<JSAMPROW>(pixels.data() + jpeg.next_scanline * stride);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string text(reinterpret_cast<const char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return text;
}

}  // namespace lsos
