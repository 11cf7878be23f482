// A smooth map from a plane to grid coordinates, as patches made on demand. Safe on any thread.
#pragma once

#include <functional>
#include <memory>

#include "terrain/grid/key_cache.h"
#include "terrain/grid/patch.h"

namespace lsos {

class PatchMap {
 public:
  using Make = std::function<Patch(const PatchKey&)>;
  explicit PatchMap(Make make) : make_(std::move(make)) {}

  // The coarsest good patch that holds the point, or the finest one where none is good.
  std::shared_ptr<const Patch> patch(const PlanePoint& at) {
    for (int level = 0;; ++level) {
      auto found = patches_.get(Patch::key_of(at, level), make_);
      if (found->is_good() || level == Patch::finest_level) return found;
    }
  }

 private:
  Make make_;
  KeyCache<PatchKey, Patch> patches_{megabytes(6)};
};

}  // namespace lsos
