// Numbers of folded states as people write them: decimal, of any length.
// SPDX-License-Identifier: MIT
#include "apps/cli/state_number.h"

namespace kiri::cli {

bool isStateNumber(const std::string& text) {
  constexpr std::size_t kMostDigits = 10000;
  return !text.empty() && text.size() <= kMostDigits &&
         text.find_first_not_of("0123456789") == std::string::npos;
}

StateCount stateNumber(const std::string& digits) {
  const std::size_t first = digits.find_first_not_of('0');
  return first == std::string::npos ? StateCount(0) : StateCount(digits.substr(first));
}

}  // namespace kiri::cli
