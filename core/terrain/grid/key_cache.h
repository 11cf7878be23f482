// Cache of values that are pure functions of their key, made once and shared by threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace lsos {

constexpr std::size_t megabytes(std::size_t count) { return count << 20; }

// Hash of a square of a grid; any other key uses its standard hash.
template <class Key>
struct KeyHash {
  std::size_t operator()(const Key& key) const {
    if constexpr (requires { key.column + key.row + key.level; }) {
      std::uint64_t z = static_cast<std::uint64_t>(key.column) * 0x9e3779b97f4a7c15u +
                        static_cast<std::uint64_t>(key.row) * 0xd1b54a32d192ed03u +
                        static_cast<std::uint64_t>(key.level);
      z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
      return static_cast<std::size_t>(z ^ (z >> 31));
    } else {
      return std::hash<Key>{}(key);
    }
  }
};

// Keeps between `capacity_bytes` and twice that of the values last requested. Values are shared
// pointers: one may be dropped here while another thread still reads it. A value that owns memory
// reports its size with bytes().
template <class Key, class Value>
class KeyCache {
 public:
  explicit KeyCache(std::size_t capacity_bytes) : capacity_bytes_(capacity_bytes) {}

  // `make(key)` is called under the cache's lock, so it may use what is not thread-safe; it must
  // return the same value for the same key at any time.
  template <class Make>
  std::shared_ptr<const Value> get(const Key& key, const Make& make) {
    const std::lock_guard lock(mutex_);
    if (const auto found = young_.find(key); found != young_.end()) return found->second;
    std::shared_ptr<const Value> value;
    if (const auto found = old_.find(key); found != old_.end()) {
      value = found->second;
    } else {
      value = std::make_shared<const Value>(make(key));
    }
    if (young_bytes_ >= capacity_bytes_) {
      old_ = std::move(young_);
      young_.clear();
      young_bytes_ = 0;
    }
    young_bytes_ += bytes(*value);
    young_.emplace(key, value);
    return value;
  }

 private:
  static std::size_t bytes(const Value& value) {
    constexpr std::size_t node = 64;  // bytes of the map's node and of the pointer's counts
    if constexpr (requires { value.bytes(); }) {
      return node + value.bytes();
    } else {
      return node + sizeof(Value);
    }
  }

  std::size_t capacity_bytes_;
  std::size_t young_bytes_ = 0;
  std::mutex mutex_;
  using Generation = std::unordered_map<Key, std::shared_ptr<const Value>, KeyHash<Key>>;
  Generation young_;
  Generation old_;
};

}  // namespace lsos
