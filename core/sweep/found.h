// The first meeting of a motion, as it is looked for among many pairs of facets.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/sweep/sweep.h"
#include "core/sweep/turn.h"

namespace kiri {

/// A moving facet that meets a resting one.
struct Found {
  FacetId moving;
  FacetId resting;
  Turn turn;
  Vec3 place;  ///< axis frame
  bool isCertain = true;
};

/// Keeps the first certain meeting, and the first that rounding decides.
class FirstFound {
 public:
  void add(const Found& found) {
    std::optional<Found>& best = found.isCertain ? certain_ : doubtful_;
    if (!best || isBefore(found, *best)) best = found;
  }
  /// True when nothing that happens after `turn` can matter any more.
  bool isSettledBefore(Turn turn) const {
    return certain_ && certain_->turn.order() < turn.order();
  }
  const std::optional<Found>& certain() const { return certain_; }
  /// What the sweep answers: a certain meeting counts before a doubtful one.
  const std::optional<Found>& best() const { return certain_ ? certain_ : doubtful_; }

 private:
  /// Earlier, or at the same turn with lower facets, so that the answer does not hang on the order
  /// of search.
  static bool isBefore(const Found& a, const Found& b) {
    const double x = a.turn.order();
    const double y = b.turn.order();
    if (x != y) return x < y;
    return a.moving != b.moving ? a.moving < b.moving : a.resting < b.resting;
  }

  std::optional<Found> certain_;
  std::optional<Found> doubtful_;
};

/// Contacts less deep than match() are mere touching; those that are not deeper than this many
/// times as much might be no more than that.
inline constexpr double kDoubtful = 4;

}  // namespace kiri
