// Whether a sanitizer is active, and by how much it slows tests.
#pragma once

namespace lsos::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;
inline constexpr double slowness = 10;  // factor on time limits
#else
inline constexpr bool is_sanitized = false;
inline constexpr double slowness = 1;
#endif

}  // namespace lsos::test
