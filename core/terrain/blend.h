// Blending of finer layers over coarser ones.
#pragma once

#include <algorithm>
#include <optional>

#include "terrain/layer.h"

namespace lsos {

// Weighted sum of layers, added from fine to coarse. The share of each is its weight times what the
// finer ones left.
class Blend {
 public:
  // Returns false when nothing is left for coarser layers.
  bool add(const LayerSample& s) {
    const double share = left_ * s.weight;
    const Vec2 share_by_xy = left_by_xy_ * s.weight + left_ * s.weight_by_xy;
    height_m_ += share * s.height_m;
    by_xy_ += share_by_xy * s.height_m + share * s.height_by_xy;
    if (share > largest_share_) is_rock_ = s.is_rock;
    largest_share_ = std::max(largest_share_, share);
    sum_ += share;
    sum_by_xy_ += share_by_xy;
    left_ -= share;
    left_by_xy_ -= share_by_xy;
    return left_ > 0;
  }
  bool is_ground() const { return sum_ > 0; }
  // Where the coarser layers have no ground, the finer ones make up all of it.
  LayerSample result() const {
    const double per_sum = 1 / sum_;
    LayerSample s;
    s.height_m = height_m_ * per_sum;
    s.height_by_xy = (by_xy_ - s.height_m * sum_by_xy_) * per_sum;
    s.is_rock = is_rock_;
    return s;
  }

 private:
  double height_m_ = 0;
  Vec2 by_xy_ = Vec2::Zero();
  double left_ = 1;
  Vec2 left_by_xy_ = Vec2::Zero();
  bool is_rock_ = false;
  double largest_share_ = 0;
  double sum_ = 0;  // sum of the shares: 1 - left_, without its cancellation
  Vec2 sum_by_xy_ = Vec2::Zero();
};

// Blends all layers; `sample(k)` returns the sample of layer k, from fine to coarse.
template <class SampleOf>
std::optional<LayerSample> blended(std::size_t layers, const SampleOf& sample) {
  if (layers == 1) return sample(0);
  Blend blend;
  for (std::size_t k = 0; k < layers; ++k) {
    const std::optional<LayerSample> s = sample(k);
    if (s && !blend.add(*s)) break;
  }
  return blend.is_ground() ? std::optional(blend.result()) : std::nullopt;
}

}  // namespace lsos
