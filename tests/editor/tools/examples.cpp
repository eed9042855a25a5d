// SPDX-License-Identifier: MIT
#include "tests/editor/tools/examples.h"

#include <algorithm>
#include <stdexcept>

#include "tests/support/example_files.h"

namespace kiri::test {
namespace {

std::vector<Arc> rimOf(const FoldedState& state) {
  std::vector<Arc> rim;
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    if (state.pattern.edges[e].kind == EdgeKind::Border)
      rim.push_back(arcOf(state.pattern, EdgeId(e)));
  }
  return rim;
}

double oneWay(const std::vector<Arc>& from, const std::vector<Arc>& to) {
  double most = 0;
  for (const Arc& arc : from) {
    for (int i = 0; i <= 8; ++i) {
      const Vec2 p = pointAt(arc, i / 8.0);
      double nearest = HUGE_VAL;
      for (const Arc& other : to) nearest = std::min(nearest, nearestOn(other, p).distance);
      most = std::max(most, nearest);
    }
  }
  return most;
}

}  // namespace

const FoldedState& Example::after(std::size_t steps) const {
  return steps == 0 ? *replay.start : *replay.outcomes[steps - 1].state;
}

Example exampleOf(const std::string& name) {
  const Model model = modelOfExample(name);
  Result<Replay> replayed = replay(model);
  if (!replayed) throw std::runtime_error(replayed.error().message);
  const auto last = replayed->after(model.steps.size());
  if (!last) throw std::runtime_error(last.error().message);
  return {model, std::move(*replayed)};
}

double rimGap(const FoldedState& a, const FoldedState& b) {
  const std::vector<Arc> p = rimOf(a);
  const std::vector<Arc> q = rimOf(b);
  return std::max(oneWay(p, q), oneWay(q, p));
}

}  // namespace kiri::test
