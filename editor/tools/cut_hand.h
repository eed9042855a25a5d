// What straight and curve cuts share once their line is there: layers, what stays, the step.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/tools/cut_layers.h"
#include "editor/tools/keep_choice.h"

namespace kiri {

/// The second half of a cut. The tool that owns it knows the line; every call gets the step as the
/// line alone says it (in the frame of its facet), and the line as a trace.
class CutHand {
 public:
  struct Line {
    Step step;  ///< StraightCutStep or CurveCutStep, Frame::Paper
    PlaneTrace trace;
  };

  void reset() { *this = CutHand(); }
  /// The line has changed and rests now: proposes what stays.
  void lineRests(const Scope& scope, const Line& line, CutHabit habit);

  /// Left button, on what the line does not want: takes the mark, or begins a click on paper.
  /// False: there is nothing there.
  bool press(const PointerEvent& event, const Scope& scope);
  /// True when that concerned the mark or the click.
  bool follow(const PointerEvent& event, const Scope& scope, const Line& line);
  /// A click on paper has become something else.
  void dropClick() { click_.reset(); }
  bool hasClick() const { return click_.has_value(); }
  Vec2 clickedAt() const { return pressedAt_; }
  bool isMoving() const { return keep_.isMoving(); }
  /// With Ctrl the wheel walks the layers.
  Reaction wheel(const WheelEvent& event, const Scope& scope, const Line& line);

  /// The whole step. `isResting`: false while the line is drawn; then all paper stays.
  Step step(const Scope& scope, const Line& line, bool isResting) const;
  void addMarks(const Scope& scope, Marks& marks) const { keep_.addMarks(*scope.state, marks); }
  void addFields(const Scope& scope, const Line& line, std::vector<Field>& fields) const;
  bool setField(const std::string& id, const FieldValue& value, const Scope& scope,
                const Line& line);
  const KeepChoice& keep() const { return keep_; }

 private:
  CutLayers layers_{true};
  KeepChoice keep_;
  std::optional<Vec2> click_;  ///< the paper under a press that may become a click, paper frame
  Vec2 pressedAt_;             ///< pixels
};

}  // namespace kiri
