// The one slider for all fold lines: opens and closes the model (thesis B17).
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/step.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// Openness 0 is folded, every line at the amount it was last folded to; 1 is unfolded. Together as
/// leaves do, or in order. Prepared once for a drag, then asked for moments. A copy shares the
/// ways.
class AllSlider {
 public:
  /// The ways from `state` to both ends. May take long where creases are many or form closed loops.
  /// Errors: NothingToDo - nothing is folded; when neither end can be reached, that of unfolding;
  /// Cancelled.
  static Result<AllSlider> prepare(const FoldedState& state, Sequence sequence,
                                   const Progress& progress = {});

  /// Where the state stands that the drag began with: the part of the degrees that are unfolded. It
  /// stands at an end that cannot be reached.
  double openness() const;
  /// Between the ends the model is looked at, no more. Where the paper would have to bend on the
  /// way it stays as it is up to the end.
  std::shared_ptr<const FoldedState> at(double openness) const;
  /// Why it cannot be unfolded or folded all the way; it stays where it is then.
  const std::optional<Error>& whyNotOpen() const;
  const std::optional<Error>& whyNotFolded() const;

  /// The step that releasing the slider makes: an UnfoldStep at 1, a RefoldStep at 0. None between
  /// the ends, where it springs back: a model that is half open is no step of a file, since single
  /// angles cannot say how creases in closed loops go together.
  std::optional<Step> stepAt(double openness) const;

 private:
  struct Ways;
  explicit AllSlider(std::shared_ptr<const Ways> ways) : ways_(std::move(ways)) {}
  std::shared_ptr<const Ways> ways_;
};

}  // namespace kiri
