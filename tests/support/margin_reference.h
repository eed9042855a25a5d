// The unfolded margin of a leaf by reflecting the cutting curve through the folds, apart from the
// kernel. SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/paper/folded_state.h"

namespace kiri::test {

/// A flat fold as drawn on the model as it lay: what was left of the line was reflected in it. A
/// fold of chosen layers names a line on the sheet instead, left of which paper was reflected.
struct DrawnFold {
  Vec2 from;
  Vec2 to;
  std::optional<std::pair<Vec2, Vec2>> onSheet = std::nullopt;
};

/// How the paper around one point of the sheet was carried to the model: reflections, one after the
/// other.
class Carried {
 public:
  /// Follows `paper` through the folds.
  Carried(Vec2 paper, const std::vector<DrawnFold>& folds);
  Vec2 toModel(Vec2 paper) const;

 private:
  std::vector<DrawnFold> met_;
};

/// One cubic piece as four control points.
struct Piece {
  Vec2 p[4];
};
/// Pieces of a uniform cubic B-spline by its blending functions; `isClamped` repeats the end knots
/// (de Boor).
std::vector<Piece> splinePieces(const std::vector<Vec2>& controls, bool isClamped);
std::vector<Piece> closedSplinePieces(const std::vector<Vec2>& controls);

/// How far, at the worst, a control point of a curved edge of `state` (a border on the inside of
/// the sheet) is from where the reflected curve puts it; infinity when an edge fits no piece. The
/// edges may be parts of pieces.
double worstMarginError(const FoldedState& state, const std::vector<Piece>& curve,
                        const std::vector<DrawnFold>& folds);

}  // namespace kiri::test
