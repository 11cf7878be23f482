#include "base/base64.h"

#include <openssl/evp.h>

#include "base/error.h"

namespace lsos {

std::string base64(std::string_view bytes) {
  // OpenSSL counts in int, and ends the text with a 0.
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  LSOS_ASSERT(length >= 0 && static_cast<std::size_t>(length) + 1 == text.size());
  text.resize(static_cast<std::size_t>(length));
  return text;
}

}  // namespace lsos
