// What the proposed step would do, computed while the hand is still moving.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "editor/base/task.h"
#include "editor/tools/proposal.h"
#include "editor/view/marks.h"

namespace kiri {

/// The preview of the newest proposal. While the next is being computed the last one stays, so that
/// the picture follows the hand without flicker.
class Previewer {
 public:
  /// `changed` is called when another preview is there.
  Previewer(TaskRunner& runner, std::function<void()> changed);

  /// Nothing happens when it is what was asked for last.
  void ask(const std::shared_ptr<const FoldedState>& state, const Step& step, int number);
  /// No proposal, no preview.
  void clear();

  /// The newest that is known; none without a proposal.
  const Preview* current() const { return preview_ ? &*preview_ : nullptr; }
  /// For each facet of the preview's `after` whether it has moved; empty without one.
  const std::vector<FacetTint>& tints() const { return tints_; }
  bool isBusy() const { return task_.isBusy(); }

 private:
  struct Asked {
    std::shared_ptr<const FoldedState> state;
    Step step;
    int number = 0;
  };
  std::optional<Asked> asked_;
  std::optional<Preview> preview_;
  std::vector<FacetTint> tints_;
  std::function<void()> changed_;
  LatestTask task_;
};

/// What a step would do. Pure.
Preview previewOf(const std::shared_ptr<const FoldedState>& state, const Step& step, int number);

}  // namespace kiri
