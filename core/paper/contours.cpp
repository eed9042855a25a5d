// SPDX-License-Identifier: MIT
#include "core/paper/contours.h"

#include <array>
#include <cstdint>

namespace kiri {
namespace {

/// For every edge, forwards and backwards: the use that follows in the border of the same facet.
class Followers {
 public:
  explicit Followers(const CreasePattern& pattern) : next_(pattern.edges.size()) {
    for (const Facet& facet : pattern.facets) {
      for (std::size_t loop = 0; loop <= facet.holeStarts.size(); ++loop) {
        const std::size_t begin = loop == 0 ? 0 : facet.holeStarts[loop - 1];
        const std::size_t end =
            loop < facet.holeStarts.size() ? facet.holeStarts[loop] : facet.border.size();
        for (std::size_t i = begin; i < end; ++i) {
          const EdgeUse use = facet.border[i];
          next_[use.edge.index][use.isReversed ? 1 : 0] = facet.border[i + 1 < end ? i + 1 : begin];
        }
      }
    }
  }

  EdgeUse after(EdgeUse use) const { return next_[use.edge.index][use.isReversed ? 1 : 0]; }

 private:
  std::vector<std::array<EdgeUse, 2>> next_;
};

}  // namespace

std::vector<std::vector<EdgeUse>> contoursOf(const CreasePattern& pattern) {
  const Followers followers(pattern);
  std::vector<bool> isDone(pattern.edges.size(), false);
  std::vector<std::vector<EdgeUse>> contours;
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    const Edge& edge = pattern.edges[e];
    const bool hasPaper = edge.left.isValid() || edge.right.isValid();
    if (edge.kind != EdgeKind::Border || !hasPaper || isDone[e]) continue;
    std::vector<EdgeUse> contour;
    EdgeUse use{EdgeId(e), !edge.left.isValid()};
    while (!isDone[use.edge.index]) {
      isDone[use.edge.index] = true;
      contour.push_back(use);
      use = followers.after(use);
      // Turn about the corner, from facet to facet, until paper ends.
      while (pattern[use.edge].kind != EdgeKind::Border) {
        use = followers.after({use.edge, !use.isReversed});
      }
    }
    contours.push_back(std::move(contour));
  }
  return contours;
}

}  // namespace kiri
