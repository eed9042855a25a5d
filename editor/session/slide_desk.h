// The slider under the hand: from the state at which the drag began to where the paper lets it go.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "editor/base/task.h"
#include "editor/motion/all_slider.h"
#include "editor/motion/fold_sliders.h"

namespace kiri {

/// One drag of one slider, or of the slider of all fold lines. Only the newest place of the hand is
/// computed; the picture follows as fast as the paper can.
class SlideDesk {
 public:
  SlideDesk(TaskRunner& runner, std::function<void()> changed);

  void begin(std::shared_ptr<const FoldedState> from, FoldLineId line);
  void beginAll(std::shared_ptr<const FoldedState> from, Sequence sequence);
  void slide(double amount);
  void slideAll(double openness);
  void end();

  bool isSliding() const { return from_ != nullptr; }
  bool isSlidingAll() const { return isSliding() && !line_; }
  const std::shared_ptr<const FoldedState>& from() const { return from_; }
  std::optional<FoldLineId> line() const { return line_; }
  double wanted() const { return wanted_; }
  /// What is known of the newest place; none before the first.
  const std::optional<SlideShow>& show() const { return show_; }
  /// Why all cannot move as asked; none while that is not known or untrue.
  const std::optional<Error>& problem() const { return problem_; }
  /// Where the slider of all stands: what is shown, else where the paper was; none before that is
  /// known.
  std::optional<double> openness() const;
  /// The step that releasing the slider of all makes here; none where it springs back.
  std::optional<Step> stepOfAll() const;

 private:
  void showAll();

  std::shared_ptr<const FoldedState> from_;
  std::optional<FoldLineId> line_;
  double wanted_ = 0;
  bool isWanted_ = false;  ///< the hand has moved
  std::optional<AllSlider> all_;
  std::optional<SlideShow> show_;
  std::optional<Error> problem_;
  std::function<void()> changed_;
  LatestTask task_;
};

}  // namespace kiri
