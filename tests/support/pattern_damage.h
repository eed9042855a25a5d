// Texts of crease patterns in every format, and ways to damage them: for fuzzing their readers.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace kiri::test {

/// One format: the name that makes readPattern choose it, whole files of it, and what damage puts
/// in.
struct PatternSeeds {
  const char* fileName;
  std::vector<std::string> texts;
  std::vector<std::string> tokens;
};

/// FOLD, .cp, .opx, SVG, DXF.
const std::array<PatternSeeds, 5>& patternSeeds();

/// Where damage takes its decisions from.
class DamageSource {
 public:
  virtual ~DamageSource() = default;
  /// A number below `count`, which is above 0.
  virtual std::size_t below(std::size_t count) = 0;
};

/// Changes a byte, takes a part out, doubles one, puts a token in, exchanges a part for a token,
/// changes a number, or moves a part elsewhere.
void damage(std::string& text, const std::vector<std::string>& tokens, DamageSource& source);

}  // namespace kiri::test
