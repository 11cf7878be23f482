// How well a share is known from a number of cases.
#pragma once

#include <cstddef>

namespace lsos {

struct ShareInterval {
  double low = 0, high = 1;
};

// The 95 % interval of a share of which `count` of `cases` were seen (Wilson 1927).
ShareInterval share_interval(std::size_t count, std::size_t cases);

}  // namespace lsos
