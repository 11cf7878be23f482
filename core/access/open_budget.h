// How much GDAL may open for one call of this program: VRTs can name each other, and a raster of 22
// of them can stand for four million.
#pragma once

#include <string>

namespace lsos {

// Gives back the whole budget of this thread; done by forget_refusal(), before each call into GDAL.
void renew_open_budget();

// Takes a file, or a VRT, off the budget; false once it is spent.
bool spend_file();
bool spend_vrt();

// Why no more may be opened; the second by the VRT that was to be.
std::string too_many_files();
std::string too_many_vrts(const std::string& name);

}  // namespace lsos
