#include "study/sampling.h"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <numeric>

#include "base/random.h"

namespace lsos {

namespace {

std::uint64_t key_of(std::uint64_t seed, const std::string& name) {
  return mix_key(mix_key(mix_key(0, "study"), seed), name);
}

// The 53 leading bits as a number in [0, 1).
double share_of(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1.0p-53; }

// A random order of 0..count-1 (Fisher and Yates).
std::vector<std::int64_t> permutation(std::uint64_t key, std::int64_t count) {
  std::vector<std::int64_t> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  RandomStream random(key);
  for (std::size_t i = order.size(); i > 1; --i) {
    const auto other = static_cast<std::size_t>(random.uniform() * static_cast<double>(i));
    std::swap(order[i - 1], order[std::min(other, i - 1)]);
  }
  return order;
}

}  // namespace

Sampler::Sampler(Sampling sampling, std::uint64_t seed, std::int64_t cases,
                 std::vector<Dimension> dimensions)
    : sampling_(sampling), seed_(seed), cases_(cases), dimensions_(std::move(dimensions)) {
  std::ranges::sort(dimensions_, {}, &Dimension::name);
  if (sampling_ != Sampling::latin_hypercube) return;
  for (const Dimension& dimension : dimensions_) {
    permuted_.push_back(permutation(mix_key(key_of(seed_, dimension.name), "strata"), cases_));
  }
}

// Sobol's points are shifted bit by bit, each dimension by its own random number: the shifted
// points stratify as the plain ones do, and the first is no corner of the cube.
std::vector<double> Sampler::sobol_shares(std::int64_t number) const {
  using Engine = boost::random::sobol_engine<std::uint64_t, 64>;
  std::vector<double> shares;
  if (dimensions_.empty()) return shares;
  Engine engine(dimensions_.size());
  // The engine leaves out the first point of the sequence, which is 0 in all dimensions.
  if (number > 1) engine.seed(static_cast<std::uint64_t>(number - 2));
  for (const Dimension& dimension : dimensions_) {
    const std::uint64_t bits = number > 1 ? engine() : 0;
    const std::uint64_t shift = mix_key(key_of(seed_, dimension.name), "shift");
    shares.push_back(share_of(bits ^ shift));
  }
  return shares;
}

std::vector<double> Sampler::grid_shares(std::int64_t number) const {
  std::vector<double> shares(dimensions_.size());
  std::int64_t rest = number - 1;
  for (std::size_t i = dimensions_.size(); i-- > 0;) {
    const std::int64_t choices = dimensions_[i].choices;
    shares[i] = (static_cast<double>(rest % choices) + 0.5) / static_cast<double>(choices);
    rest /= choices;
  }
  return shares;
}

std::map<std::string, double> Sampler::shares(std::int64_t number) const {
  std::vector<double> all;
  if (sampling_ == Sampling::sobol) all = sobol_shares(number);
  if (sampling_ == Sampling::grid) all = grid_shares(number);
  std::map<std::string, double> shares;
  for (std::size_t i = 0; i < dimensions_.size(); ++i) {
    const std::string& name = dimensions_[i].name;
    const double drawn =
        RandomStream(mix_key(key_of(seed_, name), static_cast<std::uint64_t>(number))).uniform();
    switch (sampling_) {
      case Sampling::random:
        shares[name] = drawn;
        break;
      case Sampling::latin_hypercube: {
        const auto stratum = permuted_[i][static_cast<std::size_t>(number - 1)];
        shares[name] = std::min(
            (static_cast<double>(stratum) + drawn) / static_cast<double>(cases_), 1 - 0x1.0p-53);
        break;
      }
      case Sampling::sobol:
      case Sampling::grid:
        shares[name] = all[i];
        break;
    }
  }
  return shares;
}

std::int64_t grid_size(const std::vector<Dimension>& dimensions) {
  std::int64_t size = 1;
  for (const Dimension& dimension : dimensions) {
    size *= std::min(dimension.choices, cases_max + 1);
    if (size > cases_max) return cases_max + 1;
  }
  return size;
}

}  // namespace lsos
