// "Fold your first leaf": five movements of the hand, each waited for.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "core/model/model.h"
#include "editor/base/phrase.h"
#include "editor/document/document.h"
#include "editor/tools/tool.h"
#include "editor/view/marks.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// What the tour waits for, read off the paper itself: an undo takes the tour back, whatever the
/// hand does otherwise is told, and nothing is done for it. A window opens `startModel()`, takes up
/// `tool()` when a step begins, calls `look` after every change, and draws `ghost` over the model.
class Tour {
 public:
  static constexpr std::size_t kSteps = 5;

  /// The sheet that the leaf is folded from.
  static Model startModel();

  /// The paper or the eye has changed. True when what is said or drawn is another now.
  bool look(const Document& document, const ViewFrame& eye);

  /// The step that is waited for, from 0; kSteps: the leaf is done.
  std::size_t step() const { return step_; }
  bool isFinished() const { return step_ == kSteps; }
  /// The paper is not as the step needs it: `text` says what to do about it.
  bool isAstray() const { return isAstray_; }

  Phrase title() const;
  Phrase text() const;
  /// The tool that the step wants; none: any.
  std::optional<ToolId> tool() const;
  /// The movement of the hand at a part of its way, 0 to 1, over the folded model.
  Marks ghost(double part) const;

 private:
  std::size_t step_ = 0;
  bool isAstray_ = false;
  bool hasLooked_ = false;          ///< the last step: the eye has moved
  std::optional<ViewFrame> start_;  ///< of the eye, when the last step began
};

}  // namespace kiri
