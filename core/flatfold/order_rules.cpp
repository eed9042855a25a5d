// Hinge by hinge, along the pieces it was divided into; what several pieces say is said once.
// SPDX-License-Identifier: MIT
#include "core/flatfold/order_rules.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace kiri {
namespace {

/// Numbers that were met since the last `restart`.
class Met {
 public:
  explicit Met(std::size_t count) : round_(count, 0) {}
  void restart() { ++now_; }
  /// True the first time.
  bool add(std::uint32_t i) {
    if (round_[i] == now_) return false;
    round_[i] = now_;
    return true;
  }
  bool has(std::uint32_t i) const { return round_[i] == now_; }

 private:
  std::vector<std::uint32_t> round_;
  std::uint32_t now_ = 0;
};

class Rules {
 public:
  Rules(const GroundLines& ground, OrderProblem& problem)
      : g_(ground),
        problem_(problem),
        facetsMet_(problem.facetCount),
        linesMet_(ground.lines.lines.size()),
        ends_(problem.facetCount) {}

  bool add(const Progress& progress) {
    const std::size_t count = g_.lines.lines.size();
    for (std::uint32_t line = 0; line < count; ++line) {
      if (line % 256 == 0 &&
          !goesOn(progress, static_cast<double>(line) / static_cast<double>(count)))
        return false;
      if (!g_.lines.lines[line].isHinge()) continue;
      facetsMet_.restart();
      linesMet_.restart();
      for (std::uint32_t i = g_.arrangement.starts[line]; i < g_.arrangement.starts[line + 1]; ++i)
        addPiece(line, g_.arrangement.chain[i]);
    }
    dropRepeated();
    return true;
  }

 private:
  /// The facets of a line on one side of a piece that it runs along or against.
  static bool isLeft(bool isLeftOfLine, const LinesAlong::Use& use, std::uint32_t code) {
    return isLeftOfLine != (use.isBack != (code % 2 == 1));
  }

  void addPiece(std::uint32_t line, std::uint32_t code) {
    // Left is the side of the first facet: of the fold, or of a flat hinge its one half.
    if (!g_.lines.lines[line].firstIsLeft) code ^= 1U;
    if (g_.lines.lines[line].isFold()) {
      addFold(line, code);
    } else {
      addFlat(line, code);
    }
  }

  /// Paper that goes on past a fold, and other folds on its side.
  void addFold(std::uint32_t line, std::uint32_t code) {
    const FoldedLine& fold = g_.lines.lines[line];
    ends_.restart();
    for (const LinesAlong::Use* use = g_.along.begin(code / 2); use != g_.along.end(code / 2);
         ++use) {
      const FoldedLine& other = g_.lines.lines[use->line];
      if (other.isHinge() && !other.isFold()) continue;
      if (!isLeft(other.firstIsLeft, *use, code)) continue;
      ends_.add(other.first.index);
      if (!other.isHinge()) continue;
      ends_.add(other.second.index);
      if (use->line > line && linesMet_.add(use->line)) addInterleaving(fold, other);
    }
    for (const FacetId c : g_.facets.of[g_.cells.leftOf[code]]) {
      if (ends_.has(c.index) || !facetsMet_.add(c.index)) continue;
      addSame(problem_.above(fold.first, c), problem_.above(fold.second, c));
    }
  }

  /// A flat hinge over paper that goes on: inside a facet, or at another flat hinge.
  void addFlat(std::uint32_t line, std::uint32_t code) {
    const FoldedLine& flat = g_.lines.lines[line];
    ends_.restart();
    for (const LinesAlong::Use* use = g_.along.begin(code / 2); use != g_.along.end(code / 2);
         ++use) {
      const FoldedLine& other = g_.lines.lines[use->line];
      const bool isLeftHere = isLeft(other.firstIsLeft, *use, code);
      ends_.add(other.first.index);
      if (!other.isHinge()) continue;
      ends_.add(other.second.index);
      if (other.isFold() || use->line <= line || !linesMet_.add(use->line)) continue;
      const FacetId left = isLeftHere ? other.first : other.second;
      const FacetId right = isLeftHere ? other.second : other.first;
      addSame(problem_.above(flat.first, left), problem_.above(flat.second, right));
    }
    for (const FacetId c : g_.facets.of[g_.cells.leftOf[code]]) {
      if (ends_.has(c.index) || !facetsMet_.add(c.index)) continue;
      addSame(problem_.above(flat.first, c), problem_.above(flat.second, c));
    }
  }

  void addSame(Literal first, Literal second) {
    if (second < first) std::swap(first, second);
    if (first == second) return;
    if (first.isNegated()) {
      first = !first;
      second = !second;
    }
    problem_.same.push_back({first, second});
  }

  void addInterleaving(const FoldedLine& one, const FoldedLine& other) {
    const FacetId a = one.first;
    const FacetId b = one.second;
    const FacetId c = other.first;
    const FacetId d = other.second;
    problem_.interleavings.push_back(
        {problem_.above(a, c), problem_.above(b, c), problem_.above(a, d), problem_.above(b, d)});
  }

  static std::array<std::uint32_t, 4> keyOf(const Interleaving& i) {
    std::array<std::uint32_t, 4> key{i.ac.pair(), i.bc.pair(), i.ad.pair(), i.bd.pair()};
    std::sort(key.begin(), key.end());
    return key;
  }

  /// Two facets may share several hinges on one line.
  void dropRepeated() {
    std::vector<SameOrder>& same = problem_.same;
    const auto codes = [](const SameOrder& s) { return std::tie(s.first, s.second); };
    std::sort(same.begin(), same.end(),
              [&](const SameOrder& x, const SameOrder& y) { return codes(x) < codes(y); });
    same.erase(
        std::unique(same.begin(), same.end(),
                    [&](const SameOrder& x, const SameOrder& y) { return codes(x) == codes(y); }),
        same.end());
    std::vector<Interleaving>& all = problem_.interleavings;
    std::stable_sort(all.begin(), all.end(), [](const Interleaving& x, const Interleaving& y) {
      return keyOf(x) < keyOf(y);
    });
    all.erase(std::unique(all.begin(), all.end(),
                          [](const Interleaving& x, const Interleaving& y) {
                            return keyOf(x) == keyOf(y);
                          }),
              all.end());
  }

  const GroundLines& g_;
  OrderProblem& problem_;
  Met facetsMet_;  ///< beside the hinge at hand
  Met linesMet_;
  Met ends_;  ///< facets that end at the piece at hand, on the side that matters
};

}  // namespace

bool addRules(const GroundLines& ground, OrderProblem& problem, const Progress& progress) {
  return Rules(ground, problem).add(progress);
}

void addKnown(const AssignedPattern& creases, const FlatMap& map, OrderProblem& problem) {
  for (std::size_t e = 0; e < creases.pattern.edges.size(); ++e) {
    const Edge& edge = creases.pattern.edges[e];
    if (!creases.isFolded(EdgeId(e)) || creases.of(EdgeId(e)) == Assignment::Unassigned) continue;
    const Literal leftIsAbove = problem.above(edge.left, edge.right);
    const bool holds = map.poses[edge.left.index].isFlipped == (edge.angle > 0);
    problem.known.push_back(holds ? leftIsAbove : !leftIsAbove);
  }
  std::sort(problem.known.begin(), problem.known.end());
  problem.known.erase(std::unique(problem.known.begin(), problem.known.end()), problem.known.end());
}

}  // namespace kiri
