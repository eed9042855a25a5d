// SPDX-License-Identifier: MIT
#include "tests/core/flatfold/made_problems.h"

#include <algorithm>
#include <array>

namespace kiri::test {

Literal aboveOf(const OrderProblem& problem, std::size_t upper, std::size_t lower) {
  const auto [a, b] = std::minmax(upper, lower);
  return {problem.indexOf(FacetId(a), FacetId(b)), upper > lower};
}

OrderProblem mapProblem(std::size_t rows, std::size_t columns) {
  OrderProblem problem;
  problem.facetCount = rows * columns;
  std::vector<FacetId> all;
  for (std::size_t a = 0; a < problem.facetCount; ++a) {
    all.push_back(FacetId(a));
    for (std::size_t b = a + 1; b < problem.facetCount; ++b) {
      problem.pairs.push_back({FacetId(a), FacetId(b)});
    }
  }
  if (all.size() > 1) problem.stacks.add(all);
  // Creases by the side of the square on which they end up.
  std::array<std::vector<std::pair<std::size_t, std::size_t>>, 4> sides;
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t f = r * columns + c;
      if (c + 1 < columns) sides[c % 2].push_back({f, f + 1});
      if (r + 1 < rows) sides[2 + r % 2].push_back({f, f + columns});
    }
  }
  for (const auto& side : sides) {
    for (std::size_t i = 0; i < side.size(); ++i) {
      for (std::size_t j = i + 1; j < side.size(); ++j) {
        const auto [a, b] = side[i];
        const auto [c, d] = side[j];
        problem.interleavings.push_back({aboveOf(problem, a, c), aboveOf(problem, b, c),
                                         aboveOf(problem, a, d), aboveOf(problem, b, d)});
      }
    }
  }
  return problem;
}

OrderProblem randomProblem(std::mt19937& random, std::size_t facets, std::size_t pairs) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  OrderProblem problem;
  problem.facetCount = facets;
  // Stacks first: every two of their facets overlap.
  std::vector<std::vector<FacetId>> stacks;
  for (std::size_t tries = below(6); tries-- > 0;) {
    std::vector<FacetId> stack;
    for (std::size_t f = 0; f < facets; ++f) {
      if (below(2) == 0) stack.push_back(FacetId(f));
    }
    std::vector<FacetPair> grown = problem.pairs;
    for (std::size_t i = 0; i < stack.size(); ++i) {
      for (std::size_t j = i + 1; j < stack.size(); ++j) grown.push_back({stack[i], stack[j]});
    }
    std::sort(grown.begin(), grown.end());
    grown.erase(std::unique(grown.begin(), grown.end()), grown.end());
    if (stack.size() < 2 || grown.size() > pairs) continue;
    problem.pairs = grown;
    stacks.push_back(stack);
  }
  for (const std::vector<FacetId>& stack : stacks) problem.stacks.add(stack);
  if (problem.pairs.empty()) return problem;
  const auto literal = [&] {
    return Literal(static_cast<std::uint32_t>(below(problem.pairs.size())), below(2) == 0);
  };
  for (std::size_t n = below(4); n-- > 0;) problem.same.push_back({literal(), literal()});
  for (std::size_t n = below(5); n-- > 0;) {
    problem.interleavings.push_back({literal(), literal(), literal(), literal()});
  }
  for (std::size_t n = below(4); n-- > 0;) problem.known.push_back(literal());
  return problem;
}

std::vector<std::uint32_t> allStates(const OrderProblem& problem) {
  std::vector<std::array<Literal, 3>> rings;
  for (std::size_t s = 0; s < problem.stacks.size(); ++s) {
    const FacetId* f = problem.stacks.begin(s);
    for (std::size_t i = 0; i < problem.stacks.depth(s); ++i) {
      for (std::size_t j = i + 1; j < problem.stacks.depth(s); ++j) {
        for (std::size_t k = j + 1; k < problem.stacks.depth(s); ++k) {
          rings.push_back({aboveOf(problem, f[i].index, f[j].index),
                           aboveOf(problem, f[j].index, f[k].index),
                           aboveOf(problem, f[k].index, f[i].index)});
        }
      }
    }
  }
  std::vector<std::uint32_t> states;
  for (std::uint32_t mask = 0; mask < 1U << problem.pairs.size(); ++mask) {
    const auto holds = [&](Literal l) { return (mask >> l.pair() & 1) != (l.isNegated() ? 1 : 0); };
    const bool isState =
        std::all_of(problem.known.begin(), problem.known.end(), holds) &&
        std::all_of(problem.same.begin(), problem.same.end(),
                    [&](const SameOrder& s) { return holds(s.first) == holds(s.second); }) &&
        std::all_of(problem.interleavings.begin(), problem.interleavings.end(),
                    [&](const Interleaving& i) {
                      return (holds(i.ac) + holds(i.bc) + holds(i.ad) + holds(i.bd)) % 2 == 0;
                    }) &&
        std::all_of(rings.begin(), rings.end(), [&](const std::array<Literal, 3>& r) {
          return holds(r[0]) != holds(r[1]) || holds(r[1]) != holds(r[2]);
        });
    if (isState) states.push_back(mask);
  }
  return states;
}

}  // namespace kiri::test
