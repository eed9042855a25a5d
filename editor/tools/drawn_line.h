// A straight line that the hand draws across the paper and moves by its handles.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/model/step.h"
#include "core/paper/facet_line.h"
#include "editor/base/events.h"
#include "editor/base/field.h"
#include "editor/tools/facet_name.h"
#include "editor/tools/scope.h"
#include "editor/view/marks.h"

namespace kiri {

/// The pointer must go so far, in pixels, before a press is more than a click.
inline constexpr double kDragBegins = 4;

/// How near the pointer must be to a handle to take it, pixels.
double handleReach(const PointerEvent& event);

/// The line of a fold, an edge or a cut while it is made: drawn by one drag or by two clicks, then
/// resting with a handle at each end and one in the middle (which moves it in parallel). Ends are
/// snapped. It lies in the plane of the facet that is seen under its middle; on the sheet pane that
/// is the facet which holds its middle.
class LineHand {
 public:
  /// Takes the handle under the pointer, if there is one; false otherwise.
  bool takeHandle(const PointerEvent& press, const Scope& scope);
  /// Drops the line and begins a new one under the pointer.
  void begin(const PointerEvent& press, const Scope& scope);
  /// The pointer moved or was released. True when that concerned the line.
  bool follow(const PointerEvent& event, const Scope& scope);
  /// All of the above: what a tool does that knows nothing but this line. Left button only.
  bool pointer(const PointerEvent& event, const Scope& scope);
  void reset();

  /// Something is drawn, or being drawn.
  bool isBusy() const { return start_ || line_; }
  /// The hand holds the line, or its second end.
  bool isMoving() const { return held_ != Held::Nothing; }
  /// A line is there that touches the plane of some paper.
  bool isThere() const { return line_.has_value(); }
  /// The pane it is drawn in; the handles are there.
  Pane pane() const { return pane_; }

  /// The line in a state; none when there is no line, or the paper it lay on is gone.
  std::optional<FacetLine> on(const FoldedState& state) const;
  /// For a step: in the frame of its facet.
  std::optional<DrawnLine> drawn() const;
  /// Puts a line there, as one that was constructed.
  void set(const FoldedState& state, const FacetLine& line, Pane pane);

  /// The line with `role`, its continuation, handles, and what a snap has caught.
  void addMarks(const Scope& scope, MarkRole role, Marks& marks) const;
  /// "length" (mm) and "direction" (degrees from the x axis of the sheet, counter-clockwise).
  void addFields(std::vector<Field>& fields) const;
  /// True when `id` is one of these fields. The line's first end stays.
  bool setField(const std::string& id, const FieldValue& value);

 private:
  enum class Held { Nothing, NewEnd, From, To, Middle };
  /// Where a new line begins, before it is known in which plane it lies.
  struct Start {
    Vec2 pixels;
    std::optional<Spot> caught;  ///< what was snapped to when the line was begun on paper
    SnapSettings snaps;
  };
  struct OnPaper {
    FacetName facet;
    Vec2 from;  ///< paper frame of the facet, mm
    Vec2 to;
  };

  void moveNewEnd(Vec2 pixels, const Scope& scope);
  void moveHandle(Vec2 pixels, const Scope& scope);
  void moveToPaperUnder(const Scope& scope);
  Vec2 startPixels(const Scope& scope) const;
  MarkPlace markPlace(const Scope& scope, FacetId frame, Vec2 paper) const;

  Pane pane_ = Pane::Model;
  Held held_ = Held::Nothing;
  Vec2 pressedAt_;  ///< pixels
  bool isByClicks_ = false;
  std::optional<Start> start_;
  Vec2 end_;  ///< pixels, while it is drawn
  std::optional<OnPaper> line_;
  Marks caught_;  ///< by the last snap
};

/// The paper that is seen under a segment of a pane: under its middle, else as near to it as there
/// is paper.
std::optional<FacetId> paperUnder(const FoldedState& state, const PaneMap& map, Vec2 a, Vec2 b);

/// A point of one facet's plane in the paper frame of another facet, for planes that are the same
/// in the pane's space; otherwise by the line of sight. None: that plane is seen edge-on.
std::optional<Vec2> carried(const FoldedState& state, const PaneMap& map, const Spot& spot,
                            FacetId frame);

}  // namespace kiri
