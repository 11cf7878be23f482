// SHA-256 of a stream of bytes; used for the hashes of plans, scripts and terrain and for comparing
// logs.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace lsos {

class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void add(std::string_view bytes);
  // Lower-case hexadecimal; nothing may be added afterwards.
  std::string hex();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

std::string sha256_hex(std::string_view bytes);

}  // namespace lsos
