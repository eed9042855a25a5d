// Fewer cases where each takes several times as long.
// SPDX-License-Identifier: MIT
#pragma once

namespace kiri::test {

/// Whether this is the build with sanitizers. It looks for wrong memory, for which some cases do;
/// the other builds look for wrong results, for which there are never enough.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// How many cases to try: `usual`, or `sanitized` in the build with sanitizers.
template <class Number>
constexpr Number casesOf(Number usual, Number sanitized) {
  return kSanitized ? sanitized : usual;
}

}  // namespace kiri::test
