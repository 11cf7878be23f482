// What tests allow themselves when a sanitizer watches.
#pragma once

namespace lsos::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;
inline constexpr double slowness = 10;  // of time
#else
inline constexpr bool is_sanitized = false;
inline constexpr double slowness = 1;
#endif

}  // namespace lsos::test
