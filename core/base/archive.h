// Serialisation of simulation state. Each type with state lists its members once, in
// `void archive(Archive& a) { LSOS_ARCHIVE(a, x_m, count, name); }`, and that one function both
// writes and reads, which keeps the two directions in step. The names are not saved; they say where
// a saved state that does not fit differs: "rovers[0].vehicle_.wheels_[2].slip".
//
// Saved states are data that anybody may have written. A type that relies on more than the types of
// its members (an index, a size, a number that is finite) says so in `bool is_sound() const`, which
// is asked whenever one has been read.
#pragma once

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/sim_time.h"
#include "base/vector.h"

// Archives several values under the names that stand in the call.
#define LSOS_ARCHIVE(a, ...) (a).fields(#__VA_ARGS__, __VA_ARGS__)

namespace lsos {

class Archive {
 public:
  // Thrown for a saved state that does not fit the program: truncated, or of another version.
  class Mismatch : public std::runtime_error {
    using std::runtime_error::runtime_error;
  };

  static Archive writer() { return Archive({}, false); }
  static Archive reader(std::string bytes) { return Archive(std::move(bytes), true); }
  // A writer that remembers which field the byte at `offset` belongs to, see located().
  static Archive locator(std::size_t offset);
  const std::string& located() const { return located_; }

  bool is_reading() const { return reading_; }
  // Everything written until now.
  const std::string& bytes() const { return bytes_; }
  // Whether a reader has consumed all its bytes.
  bool is_exhausted() const { return position_ == bytes_.size(); }

  // Separates parts by a word; reading a different word in its place throws Mismatch, which names
  // both.
  Archive& tag(std::string_view word);

  // While it lives, what is archived belongs to the part of this name, which must outlive it. An
  // element of a list has a number in place of a name.
  class Part {
   public:
    Part(Archive& a, std::string_view name, std::size_t number = 0) : archive_(a) {
      archive_.path_.push_back({name, number});
    }
    ~Part() { archive_.path_.pop_back(); }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

   private:
    Archive& archive_;
  };

  // Throws Mismatch, which names the part that is archived now.
  [[noreturn]] void refuse(const std::string& why) const;

  // Called by LSOS_ARCHIVE. `names`: one for each value, separated by commas.
  template <class... T>
  Archive& fields(std::string_view names, T&... values) {
    (field(take_name(names), values), ...);
    return *this;
  }

  template <class T>
  requires std::is_arithmetic_v<T> Archive& operator()(T& value) {
    raw(&value, sizeof value);
    return *this;
  }
  // An enumeration whose values count up from 0; `last_value(T)`, beside it, says which is the
  // last.
  template <class T>
  requires std::is_enum_v<T> Archive& operator()(T& value) {
    using Number = std::underlying_type_t<T>;
    auto number = static_cast<Number>(value);
    raw(&number, sizeof number);
    const auto last = static_cast<Number>(last_value(T{}));
    if (std::cmp_less(number, 0) || number > last) refuse("saved state holds an unknown choice");
    value = static_cast<T>(number);
    return *this;
  }
  Archive& operator()(bool& value);
  // A time of a mission: sums of it with others, and calendar times, stay within what is counted.
  Archive& operator()(SimTime& value);
  Archive& operator()(std::string& value);
  Archive& operator()(Vec3& value) { return (*this)(value.x())(value.y())(value.z()); }
  Archive& operator()(Vec2& value) { return (*this)(value.x())(value.y()); }
  Archive& operator()(Quat& value) { return (*this)(value.w())(value.x())(value.y())(value.z()); }

  template <class T>
  Archive& operator()(std::vector<T>& values) {
    const std::size_t count = size(values.size());
    // Memory is taken as elements are read: a count may be damage.
    if (count < values.size()) values.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Part element(*this, {}, i);
      if (i == values.size()) values.emplace_back();
      (*this)(values[i]);
    }
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
      std::size_t number = 0;
      for (auto& [key, value] : values) {
        const Part element(*this, {}, number++);
        K copy = key;
        (*this)(copy)(value);
      }
      return *this;
    }
    values.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const Part element(*this, {}, i);
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
    if constexpr (requires { value.is_sound(); }) {
      if (reading_ && !value.is_sound()) refuse("saved state holds values that no mission has");
    }
    return *this;
  }

 private:
  struct Step {
    std::string_view name;   // empty: an element of a list
    std::size_t number = 0;  // of the element
  };

  Archive(std::string bytes, bool reading) : bytes_(std::move(bytes)), reading_(reading) {}

  template <class T>
  void field(std::string_view name, T& value) {
    const Part part(*this, name);
    (*this)(value);
  }
  // Removes the first name from a list of names.
  static std::string_view take_name(std::string_view& names);
  std::string path() const;
  void raw(void* data, std::size_t size);
  // Writes the size, or reads one and throws Mismatch if it cannot fit into the bytes left.
  std::size_t size(std::size_t size);

  std::string bytes_;
  std::size_t position_ = 0;
  bool reading_;
  std::vector<Step> path_;  // parts within which something is archived now, outermost first
  std::optional<std::size_t> offset_;
  std::string located_;
};

// Name of the field in which two saved states first differ. `save` archives the first of them.
template <class Save>
std::string first_difference(const std::string& first, const std::string& second, Save&& save) {
  std::size_t offset = 0;
  while (offset < std::min(first.size(), second.size()) && first[offset] == second[offset]) {
    ++offset;
  }
  Archive locator = Archive::locator(offset);
  std::forward<Save>(save)(locator);
  return locator.located();
}

}  // namespace lsos
