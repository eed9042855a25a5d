// Breadth first from the outside; every piece is checked, not only those that were walked across.
// SPDX-License-Identifier: MIT
#include "core/flatfold/cell_facets.h"

#include <algorithm>
#include <numeric>

namespace kiri {
namespace {

/// The facets that border a piece left and right of its direction, sorted.
struct Bordering {
  std::vector<FacetId> left;
  std::vector<FacetId> right;
};

void borderingOf(const LinesAlong& along, const FoldedLines& lines, std::uint32_t code,
                 Bordering& found) {
  found.left.clear();
  found.right.clear();
  for (const LinesAlong::Use* use = along.begin(code / 2); use != along.end(code / 2); ++use) {
    const FoldedLine& line = lines.lines[use->line];
    const bool isBack = use->isBack != (code % 2 == 1);
    (line.firstIsLeft != isBack ? found.left : found.right).push_back(line.first);
    if (line.isHinge())
      (line.secondIsLeft != isBack ? found.left : found.right).push_back(line.second);
  }
  std::sort(found.left.begin(), found.left.end());
  std::sort(found.right.begin(), found.right.end());
}

/// The facets on the right of a piece, given those on its left; false when `left` lacks one that
/// borders there, or has one that would be entered twice.
bool cross(const std::vector<FacetId>& left, const Bordering& border, std::vector<FacetId>& right) {
  right.clear();
  auto leaves = border.left.begin();
  auto enters = border.right.begin();
  for (const FacetId f : left) {
    for (; enters != border.right.end() && *enters < f; ++enters) right.push_back(*enters);
    if (leaves != border.left.end() && *leaves == f) {
      ++leaves;
      continue;
    }
    if (enters != border.right.end() && *enters == f) return false;
    right.push_back(f);
  }
  right.insert(right.end(), enters, border.right.end());
  return leaves == border.left.end() &&
         std::adjacent_find(right.begin(), right.end()) == right.end();
}

}  // namespace

LinesAlong linesAlong(const Arrangement& a) {
  LinesAlong along;
  along.starts.assign(a.pieces.size() + 1, 0);
  for (const std::uint32_t code : a.chain) ++along.starts[code / 2 + 1];
  std::partial_sum(along.starts.begin(), along.starts.end(), along.starts.begin());
  along.uses.resize(a.chain.size());
  std::vector<std::uint32_t> next(along.starts.begin(), along.starts.end() - 1);
  for (std::uint32_t line = 0; line + 1 < a.starts.size(); ++line) {
    for (std::uint32_t i = a.starts[line]; i < a.starts[line + 1]; ++i)
      along.uses[next[a.chain[i] / 2]++] = {line, a.chain[i] % 2 == 1};
  }
  return along;
}

CellFacets facetsOfCells(const Arrangement& a, const PlanarCells& cells, const FoldedLines& lines,
                         const LinesAlong& along) {
  const std::size_t count = cells.corners.size();
  // Codes by the cell on their left.
  std::vector<std::uint32_t> starts(count + 1, 0);
  for (const std::uint32_t cell : cells.leftOf) ++starts[cell + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<std::uint32_t> codes(cells.leftOf.size());
  std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
  for (std::uint32_t c = 0; c < cells.leftOf.size(); ++c) codes[next[cells.leftOf[c]]++] = c;

  CellFacets found;
  found.of.resize(count);
  std::vector<bool> isKnown(count, false);
  std::vector<std::uint32_t> queue{0};
  isKnown[0] = true;
  Bordering border;
  std::vector<FacetId> across;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const std::uint32_t cell = queue[i];
    for (std::uint32_t k = starts[cell]; k < starts[cell + 1]; ++k) {
      const std::uint32_t code = codes[k];
      const std::uint32_t other = cells.rightOf(code);
      if (isKnown[other] && code % 2 == 1) continue;
      borderingOf(along, lines, code, border);
      const bool fits = cross(found.of[cell], border, across);
      if (!fits || (isKnown[other] && across != found.of[other])) {
        found.wrongAt = lerp(a.points[a.pieces[code / 2][0]], a.points[a.pieces[code / 2][1]], 0.5);
        return found;
      }
      if (isKnown[other]) continue;
      isKnown[other] = true;
      found.of[other] = across;
      queue.push_back(other);
    }
  }
  return found;
}

}  // namespace kiri
