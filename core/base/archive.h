// Serialisation of simulation state. Each type with state lists its members once, in
// `void archive(Archive& a) { a(x_m)(count)(name); }`, and that one function both writes and reads,
// which keeps the two directions in step.
#pragma once

#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/sim_time.h"
#include "base/vector.h"

namespace lsos {

class Archive {
 public:
  // Thrown for a saved state that does not fit the program: truncated, or of another version.
  class Mismatch : public std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  static Archive writer() { return Archive({}, false); }
  static Archive reader(std::string bytes) { return Archive(std::move(bytes), true); }

  bool is_reading() const { return reading_; }
  // Everything written until now.
  const std::string& bytes() const { return bytes_; }
  // Whether a reader has consumed all its bytes.
  bool is_exhausted() const { return position_ == bytes_.size(); }

  // Separates parts by a word; reading a different word in its place throws Mismatch, which names
  // both.
  Archive& tag(std::string_view word);

  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) Archive& operator()(T& value) {
    raw(&value, sizeof value);
    return *this;
  }
  Archive& operator()(bool& value);
  Archive& operator()(SimTime& value) {
    std::int64_t count = value.count();
    (*this)(count);
    value = SimTime{count};
    return *this;
  }
  Archive& operator()(std::string& value);
  Archive& operator()(Vec3& value) { return (*this)(value.x())(value.y())(value.z()); }
  Archive& operator()(Vec2& value) { return (*this)(value.x())(value.y()); }
  Archive& operator()(Quat& value) { return (*this)(value.w())(value.x())(value.y())(value.z()); }

  template <class T>
  Archive& operator()(std::vector<T>& values) {
    values.resize(size(values.size()));
    for (T& value : values) (*this)(value);
    return *this;
  }
  template <class T>
  Archive& operator()(std::optional<T>& value) {
    bool has = value.has_value();
    (*this)(has);
    if (!has) value.reset();
    if (has && !value) value.emplace();
    if (has) (*this)(*value);
    return *this;
  }
  template <class K, class V>
  Archive& operator()(std::map<K, V>& values) {
    const std::size_t count = size(values.size());
    if (!reading_) {
      for (auto& [key, value] : values) {
        K copy = key;
        (*this)(copy)(value);
      }
      return *this;
    }
    values.clear();
    for (std::size_t i = 0; i < count; ++i) {
      K key{};
      (*this)(key);
      (*this)(values[key]);
    }
    return *this;
  }
  template <class T>
  requires requires(T& value, Archive& a) { value.archive(a); }
  Archive& operator()(T& value) {
    value.archive(*this);
    return *this;
  }

 private:
  Archive(std::string bytes, bool reading) : bytes_(std::move(bytes)), reading_(reading) {}

  void raw(void* data, std::size_t size);
  // Writes the size, or reads one and throws Mismatch if it cannot fit into the bytes left.
  std::size_t size(std::size_t size);

  std::string bytes_;
  std::size_t position_ = 0;
  bool reading_;
};

}  // namespace lsos
