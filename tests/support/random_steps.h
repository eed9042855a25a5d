// Random steps of all kinds, many of them on purpose through vertices and along creases. Same seed,
// same steps. SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/model/model.h"
#include "core/paper/folded_state.h"

namespace kiri::test {

/// A small generator of its own (splitmix64), so that a seed means the same on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  /// In [0, 1).
  double unit();
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// 0 to count - 1; count > 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  bool chance(double probability) { return unit() < probability; }

 private:
  std::uint64_t state_;
};

struct RandomStepOptions {
  bool hasCuts = true;          ///< straight and curve cuts
  bool hasTears = true;         ///< tear and mend
  bool hasAngles = true;        ///< angles other than 0 and 180
  std::size_t facetLimit = 40;  ///< beyond it only steps that make no facets
};

Model randomSheet(Random& random);
/// A step that may or may not apply to the state.
Step randomStep(Random& random, const FoldedState& state, const RandomStepOptions& options);

/// A short text of a step, to print what led to a failure; in the words of model_text.h.
std::string textOf(const Step& step);
std::string textOf(const Model& model);

}  // namespace kiri::test
