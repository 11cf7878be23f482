// Calls into GDAL that stay silent; what went wrong becomes text for our own messages.
#pragma once

#include <cpl_error.h>

#include <string>

namespace lsos {

// While it lives, GDAL prints nothing on this thread.
class GdalSilence {
 public:
  GdalSilence() {
    CPLErrorReset();
    CPLPushErrorHandler(CPLQuietErrorHandler);
  }
  ~GdalSilence() { CPLPopErrorHandler(); }
  GdalSilence(const GdalSilence&) = delete;
  GdalSilence& operator=(const GdalSilence&) = delete;

  // GDAL's last message on this thread, "" when there is none.
  static std::string message() { return CPLGetLastErrorMsg(); }
};

}  // namespace lsos
