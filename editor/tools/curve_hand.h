// A B-spline that the hand draws across the paper, point by point or in one stroke.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/step.h"
#include "editor/tools/cut_layers.h"
#include "editor/tools/facet_name.h"
#include "editor/tools/tool.h"

namespace kiri {

/// The curve of a cut while it is made. Clicks place its control points (snapped), a drag that
/// begins on nothing is a stroke to which a curve is fitted; then it rests, and its controls can be
/// dragged, added, removed and typed. It lies in the plane of the paper that it was first seen to
/// meet; before it meets any, of the paper nearest to it.
class CurveHand {
 public:
  /// The left button went down. False: not for the curve (which rests, and the pointer is on
  /// neither control nor curve), or there is no paper at all.
  bool press(const PointerEvent& event, const Scope& scope);
  /// The pointer moved, left, was released or clicked twice. True when that concerned the curve.
  bool follow(const PointerEvent& event, const Scope& scope);
  /// Enter ends drawing; Delete, Backspace, Insert (or "+"), Tab and arrows work on controls.
  bool key(const KeyEvent& event, const Scope& scope);
  void reset() { *this = CurveHand(); }

  bool isBusy() const { return phase_ != Phase::Empty; }
  /// Drawn to its end; points can still be moved.
  bool isResting() const { return phase_ == Phase::Resting; }
  /// The hand holds a control, or draws a stroke.
  bool isMoving() const { return held_.has_value() || isStroke_; }
  /// The pointer is on a control.
  bool isOverControl() const { return hovered_.has_value(); }
  bool isClosed() const { return isClosed_; }

  /// The curve as it stands, with the place of the pointer while it is drawn. In the frame of its
  /// facet, all layers, all paper stays. None with fewer than two places, or when its paper is
  /// gone.
  std::optional<CurveCutStep> cut(const FoldedState& state) const;
  /// The same curve as a polyline.
  std::optional<PlaneTrace> trace(const FoldedState& state) const;

  void addMarks(const Scope& scope, Marks& marks) const;
  /// "x" and "y" of the active control, "closed". On the model x and y are those of the model frame
  /// seen from the front, on the sheet (and where the paper stands upright) those of the paper.
  void addFields(const Scope& scope, std::vector<Field>& fields) const;
  /// True when `id` is one of these fields.
  bool setField(const std::string& id, const FieldValue& value, const Scope& scope);

 private:
  enum class Phase { Empty, Drawing, Resting };

  bool begin(const PointerEvent& event, const Scope& scope);
  void addControl(const PointerEvent& event, const Scope& scope);
  void meetPaper(Vec2 pixels, const Scope& scope);
  void moveHeld(const PointerEvent& event, const Scope& scope);
  void hover(const PointerEvent& event, const Scope& scope);
  void goOnStroke(const PointerEvent& event, const Scope& scope);
  void release(const PointerEvent& event, const Scope& scope);
  void finish(const Scope& scope);
  bool insertAt(Vec2 pixels, double reach, const Scope& scope);
  bool remove(const Scope& scope);
  void nudge(const KeyEvent& event, const Scope& scope);

  std::optional<FacetId> frameIn(const FoldedState& state) const;
  std::vector<Vec2> shape() const;
  std::vector<Arc> arcs() const;
  std::optional<Vec2> snapped(Vec2 pixels, const Scope& scope, std::optional<Vec2> from);
  std::optional<std::size_t> controlNear(Vec2 pixels, double reach, const Scope& scope) const;
  std::optional<double> curveNear(Vec2 pixels, double reach, const Scope& scope) const;
  Vec2 pixelsOf(Vec2 paper, const Scope& scope) const;
  bool isInModelFrame(const FoldedState& state) const;
  Vec2 shown(Vec2 paper, const FoldedState& state) const;
  Vec2 fromShown(Vec2 typed, const FoldedState& state) const;

  Phase phase_ = Phase::Empty;
  Pane pane_ = Pane::Model;
  std::optional<FacetName> frame_;
  bool hasMetPaper_ = false;
  std::vector<Vec2> controls_;  ///< paper frame of the facet
  std::optional<Vec2> next_;    ///< where the next would be
  bool isClosed_ = false;
  bool isStroke_ = false;
  std::vector<Vec2> stroke_;
  std::optional<std::size_t> held_;
  std::optional<std::size_t> active_;
  std::optional<std::size_t> hovered_;
  Vec2 pressedAt_;  ///< pixels
  Vec2 lastAt_;
  Marks caught_;
};

/// Where a place of a facet's plane is drawn: in the space of the model, or on the sheet pane only.
MarkPlace placeInPane(const Scope& scope, Pane pane, const Spot& spot);

}  // namespace kiri
