// The always-on check: what must hold unless the program itself is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace kiri {

/// Thrown by KIRI_CHECK: a defect of the program, never of the input. Applications catch it at the
/// top, save the model and report it.
class CheckFailed : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void failCheck(const char* claim, const char* file, int line) {
  throw CheckFailed(std::string(claim) + " (" + file + ":" + std::to_string(line) + ")");
}

}  // namespace kiri

/// Reports a defect of the program unless `condition` holds; `claim` says what must hold.
#define KIRI_CHECK(condition, claim)                                \
  do {                                                              \
    if (!(condition)) ::kiri::failCheck(claim, __FILE__, __LINE__); \
  } while (false)
