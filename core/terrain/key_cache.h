// Values that are pure functions of their key, made once and shared by threads.
#pragma once

#include <map>
#include <memory>
#include <mutex>

namespace lsos {

// Keeps between `capacity` and twice that many of the values last asked for. Shared pointers:
// a value may be dropped here while a reader on another thread still works with it.
template <class Key, class Value>
class KeyCache {
 public:
  explicit KeyCache(std::size_t capacity) : capacity_(capacity) {}

  // `make(key)` is called under the cache's lock, so it may use what is not thread-safe; it must
  // give the same value for the same key at any time.
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
    if (young_.size() >= capacity_) {
      old_ = std::move(young_);
      young_.clear();
    }
    young_.emplace(key, value);
    return value;
  }

 private:
  std::size_t capacity_;
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<const Value>> young_;
  std::map<Key, std::shared_ptr<const Value>> old_;
};

}  // namespace lsos
